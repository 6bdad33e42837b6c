/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "regionMeshes.H"
#include "equalPoints.H"
#include "SubField.H"
#include "triangleIndex.H"
#include "UIndirectList.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Moves points of layers and far field of a region back, as closeRegion does.
//  Cells are not tested.
static void closeParts
(
    spaceRegions& all,
    const label regioni,
    pointField& ofLayers,
    pointField& ofFarField
)
{
    pointField points(ofLayers);
    points.append(ofFarField);
    all.close(regioni, points);
    ofLayers = SubField<point>(points, ofLayers.size());
    ofFarField = SubField<point>(points, ofFarField.size(), ofLayers.size());
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

commonTriangles commonTrianglesOf
(
    const spaceRegions& all,
    const label regioni,
    const wallSurface& wall
)
{
    const spaceRegion& region = all.regions[regioni];
    const triangleIndex index(makeTriangleIndex(region.surface.faces));
    equalPoints places;
    forAll(region.surface.points, p)
    {
        places.insert(region.surface.points[p], p);
    }
    labelList ofRegion(wall.points.size());
    forAll(ofRegion, p)
    {
        ofRegion[p] = places.find(wall.points[p]);
    }

    commonTriangles common;
    common.points = UIndirectList<label>(region.points, ofRegion);
    common.faces.setSize(wall.faces.size());
    common.isCommon.resize(wall.faces.size());
    common.isJoined.resize(wall.faces.size());
    forAll(wall.faces, facei)
    {
        face f(wall.faces[facei]);
        inplaceRenumber(ofRegion, f);
        const label ofRegionFace = index[triFace(f)];
        const label whole = region.faces[ofRegionFace];
        const labelPair& both = all.regionsOfFace[whole];
        common.faces[facei] = whole;
        common.isCommon.set(facei, both.first() >= 0 && both.second() >= 0);
        common.isJoined.set(facei, all.beyond(regioni, ofRegionFace) >= 0);
    }

    return common;
}


List<polygonMesh> makePolygonRegions
(
    spaceRegions& all,
    std::vector<regionParts>& regions
)
{
    std::vector<touchedMesh> touched;
    forAll(all.regions, r)
    {
        regionParts& parts = regions[r];
        closeParts(all, r, parts.layers.points, parts.farField.points);
        touched.push_back({parts.layers, parts.farField, parts.common});
    }

    return makePolygonCells(touched, all.surface.faces.size());
}

} // End namespace Foam

// ************************************************************************* //
