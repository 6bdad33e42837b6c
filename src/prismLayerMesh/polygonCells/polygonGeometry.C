/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polygonGeometry.H"

#include "cellPredicates.H"
#include "faceQuality.H"
#include "primitiveMesh.H"
#include "surfaceMeasures.H"
#include "UIndirectList.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

polygonGeometry::polygonGeometry(const polyMeshParts& mesh)
:
    faceAreas(mesh.topology.faces.size()),
    faceCentres(faceAreas.size()),
    cellCentres(mesh.nCells, Zero),
    cellVolumes(mesh.nCells, Zero)
{
    const polyMeshTopology& t = mesh.topology;
    primitiveMesh::calcCells(cells, t.owner, t.neighbour, mesh.nCells);

    #pragma omp parallel for schedule(static)
    forAll(faceAreas, facei)
    {
        setFace(mesh, facei);
    }

    #pragma omp parallel for schedule(static)
    forAll(cells, celli)
    {
        setCell(mesh, celli);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void polygonGeometry::setFace(const polyMeshParts& mesh, const label facei)
{
    const faceGeometry geometry
    (
        UIndirectList<point>(mesh.points, mesh.topology.faces[facei])
    );
    faceAreas[facei] = geometry.area;
    faceCentres[facei] = geometry.centre;
}


void polygonGeometry::setCell(const polyMeshParts& mesh, const label celli)
{
    point middle(Zero);
    for (const label facei : cells[celli])
    {
        middle += faceCentres[facei]/cells[celli].size();
    }
    vector sum(Zero);
    scalar volume3 = 0;
    for (const label facei : cells[celli])
    {
        const scalar way = mesh.topology.owner[facei] == celli ? 1 : -1;
        const vector to(faceCentres[facei] - middle);
        const scalar pyramid3 = way*(faceAreas[facei] & to);
        sum += pyramid3*0.75*to;
        volume3 += pyramid3;
    }
    cellVolumes[celli] = volume3/3;
    cellCentres[celli] =
        mag(volume3) > VSMALL ? middle + sum/volume3 : middle;
}


finiteVolumes polygonGeometry::volumes(const polyMeshParts& mesh) const
{
    return finiteVolumes
    {
        mesh.topology.owner, mesh.topology.neighbour, cells, faceAreas,
        faceCentres, cellCentres, cellVolumes
    };
}


labelList polygonGeometry::invalidCells
(
    const polyMeshParts& mesh,
    const bitSet& some
) const
{
    const polyMeshTopology& t = mesh.topology;
    DynamicList<label> invalid;
    for (const label celli : some)
    {
        bool isValid = true;
        scalar area = 0;
        boundBox box(boundBox::invertedBox);
        const point& centre = cellCentres[celli];
        for (const label facei : cells[celli])
        {
            const face& f = t.faces[facei];
            const point* x[3] =
            {
                &mesh.points[f[0]], &mesh.points[f[1]], &mesh.points[f[2]]
            };
            const scalar way = t.owner[facei] == celli ? 1 : -1;
            isValid = isValid
             && way
               *(
                    f.size() == 3
                  ? -orientation(*x[0], *x[1], *x[2], centre)
                  : faceAreas[facei] & (faceCentres[facei] - centre)
                ) > 0;
            area += mag(faceAreas[facei]);
            for (const label p : f)
            {
                box.add(mesh.points[p]);
            }
        }
        if (!isValid || cellVolumes[celli] <= roundingVolume(box, area))
        {
            invalid.append(celli);
        }
    }

    return labelList(std::move(invalid));
}


labelList polygonGeometry::skewCells
(
    const polyMeshParts& mesh,
    const scalar maxSkewness
) const
{
    const polyMeshTopology& t = mesh.topology;
    bitSet skew(mesh.nCells);
    forAll(t.neighbour, facei)
    {
        const label own = t.owner[facei], other = t.neighbour[facei];
        const scalar skewness = skewnessAbove
        (
            faceAt(facei), UIndirectList<point>(mesh.points, t.faces[facei]),
            cellCentres[own], cellCentres[other], maxSkewness
        );
        if (skewness > maxSkewness)
        {
            skew.set(own);
            skew.set(other);
        }
    }

    return skew.sortedToc();
}

} // End namespace Foam

// ************************************************************************* //
