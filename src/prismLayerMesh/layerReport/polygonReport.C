/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polygonReport.H"
#include "DynamicField.H"
#include "makeFarFieldMesh.H"
#include "polygonGeometry.H"
#include "UIndirectList.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The cells of the zone of polyhedra
static bitSet polyhedraOf(const polyMeshParts& mesh)
{
    bitSet cells(mesh.nCells);
    for (const cellZoneParts& zone : mesh.cellZones)
    {
        if (zone.name == farFieldName)
        {
            cells.set(zone.cells);
        }
    }

    return cells;
}


//- Counts the faces between cells
static void countFaces
(
    const polygonMesh& polygons,
    const polygonGeometry& geometry,
    const qualityControls& bounds,
    layerReport& layers,
    farFieldReport& far
)
{
    const polyMeshParts& mesh = polygons.mesh;
    const polyMeshTopology& t = mesh.topology;
    const bitSet isPolyhedron(polyhedraOf(mesh));
    const auto isLayer = [&](const label celli)
    {
        return celli < polygons.counts.nLayerCells;
    };
    const auto cell = [&](const label celli)
    {
        return faceCell
        {
            geometry.cellCentres[celli], geometry.cellVolumes[celli]
        };
    };

    DynamicField<scalar> ratios;
    forAll(t.neighbour, facei)
    {
        const label own = t.owner[facei], nei = t.neighbour[facei];
        const label nPolyhedra =
            label(isPolyhedron.test(own)) + label(isPolyhedron.test(nei));
        faceQualityCounts& faces =
            isLayer(nei) ? layers.faces
          : isLayer(own) ? far.transition
          : nPolyhedra == 2 ? far.farField
          : nPolyhedra == 1 ? far.cut : far.core;
        const UIndirectList<point> points(mesh.points, t.faces[facei]);
        faces.add
        (
            facei, faceGeometry(points), points, cell(own), cell(nei), bounds
        );
        if (isLayer(own) && !isLayer(nei))
        {
            ratios.append
            (
                geometry.cellVolumes[nei]/geometry.cellVolumes[own]
            );
        }
    }
    far.volumeRatio = makePercentiles(ratios);
}


//- The first cells of the columns with a cell whose centre is outside of it
static pointField outlyingCentres
(
    const polygonMesh& polygons,
    const polygonGeometry& geometry
)
{
    const label nLayerCells = polygons.counts.nLayerCells;
    const label nLayers = nLayerCells/max(polygons.counts.nColumns, label(1));
    DynamicList<point> places;
    label last = -1;
    for (const label celli : geometry.invalidCells(polygons.mesh))
    {
        if (celli >= nLayerCells)
        {
            continue;
        }
        const label first = celli - celli % nLayers;
        if (first != last)
        {
            places.append(geometry.cellCentres[first]);
            last = first;
        }
    }

    return pointField(places);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void reportPolygons
(
    const polygonMesh& polygons,
    const qualityControls& bounds,
    layerReport& layers,
    farFieldReport& far
)
{
    const polyMeshParts& mesh = polygons.mesh;
    const polygonGeometry geometry(mesh);

    farFieldReport ofPolygons(far);
    ofPolygons.transition = faceQualityCounts();
    ofPolygons.farField = faceQualityCounts();
    ofPolygons.cut = faceQualityCounts();
    ofPolygons.core = faceQualityCounts();
    layers.faces = faceQualityCounts();
    countFaces(polygons, geometry, bounds, layers, ofPolygons);
    layers.nCells = polygons.counts.nLayerCells;
    layers.outlyingCentres = outlyingCentres(polygons, geometry);
    if (!far.nCells)
    {
        return;
    }

    ofPolygons.nCells = mesh.nCells - polygons.counts.nLayerCells;
    ofPolygons.nTets = polygons.counts.nPolyhedra;
    ofPolygons.shape = "polyhedra";
    ofPolygons.grade = polygons.counts.grade;
    forAll(far.patches, i)
    {
        const label patchi = mesh.patches.names.find(far.patches[i]);
        ofPolygons.patchFaces[i] = mesh.topology.patchSizes[patchi];
    }
    far = ofPolygons;
}

} // End namespace Foam

// ************************************************************************* //
