/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polygonCells.H"

#include "OStringStream.H"
#include "polygonMaker.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Makes meshes in rounds until all are valid
static void makeValid(const label nTriangles, PtrList<polygonMaker>& makers)
{
    commonPolygons polygons(nTriangles);
    bool hasChanged = true;
    for (bool areValid = false; !areValid;)
    {
        polygons.clear();
        for (bool isNew = true; isNew;)
        {
            isNew = false;
            for (polygonMaker& maker : makers)
            {
                isNew = maker.keepWhole(polygons) || isNew;
            }
            hasChanged = hasChanged || isNew;
        }
        for (const polygonMaker& maker : makers)
        {
            if (!hasChanged && !maker.isValid())
            {
                maker.refuse();
            }
        }
        for (polygonMaker& maker : makers)
        {
            maker.group(polygons);
        }
        polygons.divide();
        for (polygonMaker& maker : makers)
        {
            maker.collectFaces(polygons);
        }
        areValid = true;
        hasChanged = false;
        for (polygonMaker& maker : makers)
        {
            maker.makeMesh(polygons);
            areValid = areValid && maker.isValid();
            hasChanged = hasChanged || maker.hasChanged();
        }
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

dictionary toDictionary(const polygonCounts& counts)
{
    dictionary entries;
    entries.add("columns", counts.nColumns);
    entries.add("layerCells", counts.nLayerCells);
    entries.add("polyhedra", counts.nPolyhedra);
    entries.add("otherCells", counts.nOthers);
    entries.add("partsOfColumns", counts.nPartsOfColumns);
    entries.add("partsOfPolyhedra", counts.nPartsOfPolyhedra);
    entries.add("keptFaces", counts.nKeptFaces);
    entries.add("keptTets", counts.nKeptTets);
    entries.add("wallDistance", counts.wallDistance);
    entries.add("wallAreaRatio", counts.wallAreaRatio);
    entries.add("largeGains", counts.grade.nLargeGains);
    entries.add("factor", counts.grade.factor);

    return entries;
}


string textOf(const polygonCounts& counts)
{
    OStringStream text;
    text<< counts.nColumns << " columns, " << counts.nLayerCells
        << " cells in layers, " << counts.nPolyhedra << " polyhedra";
    if (counts.nPartsOfColumns || counts.nPartsOfPolyhedra)
    {
        text<< "\ncolumns divided into " << counts.nPartsOfColumns
            << " parts, polyhedra into " << counts.nPartsOfPolyhedra
            << "; " << counts.nKeptFaces
            << " columns of prisms and " << counts.nKeptTets
            << " tetrahedra stay";
    }
    text<< "\npoints of the wall are off the polygons by "
        << counts.wallDistance << " m at most, their area is "
        << counts.wallAreaRatio << " of the wall's";

    return text.str();
}


polygonMesh makePolygonCells
(
    const prismLayers& layers,
    farFieldMesh& far,
    const UList<sidePatch>& sides,
    const polygonControls& controls
)
{
    const commonTriangles none;
    PtrList<polygonMaker> makers(1);
    makers.set(0, new polygonMaker(layers, far, none, sides, controls));
    makeValid(0, makers);

    return makers[0].take();
}


List<polygonMesh> makePolygonCells
(
    const std::vector<touchedMesh>& meshes,
    const label nTriangles,
    const polygonControls& controls
)
{
    PtrList<polygonMaker> makers(meshes.size());
    forAll(makers, i)
    {
        makers.set
        (
            i,
            new polygonMaker
            (
                meshes[i].layers, meshes[i].far, meshes[i].common,
                List<sidePatch>(), controls
            )
        );
    }
    makeValid(nTriangles, makers);
    List<polygonMesh> made(makers.size());
    forAll(made, i)
    {
        made[i] = makers[i].take();
    }

    return made;
}

} // End namespace Foam

// ************************************************************************* //
