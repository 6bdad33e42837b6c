/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "makeFarFieldMesh.H"
#include "backgroundMesh.H"
#include "coreBoundary.H"
#include "coreNotes.H"
#include "farFieldSizes.H"
#include "fillWithTets.H"
#include "improveTets.H"
#include "outerTriangles.H"
#include "ranges.H"
#include "tetrahedralize.H"

#include <functional>
#include <memory>

namespace Foam
{

// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

const word farFieldName("farField");
const word hexCoreName("hexCore");


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The triangles of the outer surface of the layers, and their front faces
static wallSurface outerSurface(const prismLayers& layers, labelList& faces)
{
    wallSurface outer;
    outer.points = layers.outerPoints();
    outer.faces = layers.faces;
    outer.faces = outerTriangles(outer, faces);

    return outer;
}


//- The connectivity of the front
static wallAddressing frontAddressing(const prismLayers& layers)
{
    wallSurface front;
    front.points = layers.pointsOf(0);
    front.faces = layers.faces;
    front.border = layers.border;

    return makeWallAddressing(front);
}


//- A point inside the layers of each body, below its largest outer face, and
//  those in what stays of a core
static pointField seedsOf
(
    const prismLayers& layers,
    const wallSurface& outer,
    const tetBoundary& far
)
{
    DynamicList<point> seeds(far.seeds);

    for (const label i : largestFaces(outer))
    {
        seeds.append(pointBelow(outer.faces[i], layers));
    }

    return pointField(std::move(seeds));
}


//- The centre of the last cell below each outer triangle
static pointField layerCentres
(
    const prismLayers& layers,
    const farFieldTets& mesh
)
{
    pointField centres(mesh.outerFaces.size(), Zero);

    forAll(centres, i)
    {
        const face& f = layers.faces[mesh.outerFaces[i]];

        for (const label c : f)
        {
            centres[i] +=
                (layers(c, layers.nLayers) + layers(c, layers.nLayers - 1))
               /(2*f.size());
        }
    }

    return centres;
}


//- Makes the tetrahedra better; they remain positive
static void improve
(
    const prismLayers& layers,
    const polyMeshParts& core,
    farFieldTets& mesh
)
{
    splitCornerCells(mesh);

    neighbourCells neighbours;
    neighbours.centres = layerCentres(layers, mesh);
    neighbours.volumes.setSize(neighbours.centres.size(), 0);
    pointField centres;
    scalarField volumes;
    setCentresAndVolumes(core, mesh.cutCells, centres, volumes);
    neighbours.centres.append(centres);
    neighbours.volumes.append(volumes);
    improveTets(neighbours, mesh);

    if (!allPositive(mesh.points, mesh.tets))
    {
        FatalErrorInFunction
            << "The tetrahedra of the far field could not be certified"
            << exit(FatalError);
    }
}


//- Refuses a boundary that is not around the layers
static void checkBoundary
(
    const wallSurface& both,
    const label nOuter,
    const polyMeshParts& core
)
{
    if (both.faces.size() > nOuter)
    {
        checkFarBoundary(both, nOuter);
    }
    else if (core.nCells)
    {
        FatalErrorInFunction
            << "The mesh is not around the layers: none of its cells is near to"
            << " them, at " << both.points[0] << exit(FatalError);
    }
    else
    {
        checkBodies(both, nOuter);
    }
}


static void setBoundary
(
    const wallSurface& outer,
    const wallSurface& both,
    const tetBoundary& far,
    farFieldTets& mesh
)
{
    const label nOuter = outer.points.size();
    const auto triangles = [&](const label n, const label start)
    {
        return faceList
        (
            SubList<face>(both.faces, n, outer.faces.size() + start)
        );
    };

    mesh.nBoundaryPoints = both.points.size();
    mesh.outerTriangles = outer.faces;
    mesh.boundaryTriangles = triangles(far.nPatchFaces(), 0);
    mesh.cutTriangles = triangles(far.cutFaces.size(), far.nPatchFaces());
    mesh.patchIDs = SubList<label>(far.surface.patchIDs, far.nPatchFaces());
    forAll(far.surface.patchNames, patchi)
    {
        mesh.patches.append
        (
            far.surface.patchNames[patchi], far.surface.patchTypes[patchi]
        );
    }

    mesh.cutFaces = far.cutFaces;
    mesh.cutCells = far.cutCells;
    if (far.corePoints.size())
    {
        const label nCommon = far.columns.size();
        mesh.corePoints = labelList(nOuter, -1);
        mesh.corePoints.append
        (
            SubList<label>
            (
                far.corePoints, far.corePoints.size() - nCommon, nCommon
            )
        );
    }
}


//- Leaves out sides of the box that have no faces and are no side patches
static void dropEmptySides(const UList<sidePatch>& sides, farFieldMesh& far)
{
    DynamicList<label> kept;
    forAll(far.patches.names, patchi)
    {
        const word& name = far.patches.names[patchi];
        const bool isSide = anyOf(sides, [&](const sidePatch& side)
        {
            return side.name == name;
        });
        if (isSide || far.topology.patchSizes[1 + patchi])
        {
            kept.append(patchi);
        }
    }

    far.keepPatches(kept);
}


//- The hexahedra come after the tetrahedra
static void addHexCoreZone
(
    const label nTets,
    const label nHexahedra,
    farFieldMesh& far
)
{
    far.cellZones.append
    (
        cellZoneParts(hexCoreName, identity(nHexahedra, nTets))
    );
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

farFieldMesh makeFarFieldMesh
(
    const prismLayers& layers,
    farFieldDomain domain,
    const farFieldControls& controls
)
{
    farFieldTets mesh;
    const wallSurface outer(outerSurface(layers, mesh.outerFaces));
    const scalarField layerSizes
    (
        layerSizesOf(outer, frontAddressing(layers), controls.growthRate)
    );
    const cellSizes fromLayers
    (
        sizesFromLayers(outer, layerSizes, domain, controls)
    );

    coreCut cut;
    const tetBoundary far
    (
        controls.type == farFieldType::tet
      ? makeTetBoundary(layers, domain.boundary, std::cref(fromLayers))
      : makeCoreBoundary
        (
            layers, outer, controls, std::cref(fromLayers), domain, cut
        )
    );
    const wallSurface both(joined(outer, far));
    checkBoundary(both, outer.faces.size(), domain.core);
    setBoundary(outer, both, far, mesh);

    const std::unique_ptr<const cellSizes> fromBoth
    (
        hasOwnSizes(controls)
      ? sizesFromBoth(both, layerSizes, far, domain, controls)
      : nullptr
    );
    const cellSizes& sizes = fromBoth ? *fromBoth : fromLayers;
    fillWithTets
    (
        both, seedsOf(layers, outer, far), sizes,
        domain.core.nCells
      ? nTetsIn(domain.core, cut.room, sizes) : nTetsBetween(both, sizes),
        controls.maxCells, mesh
    );
    improve(layers, domain.core, mesh);

    farFieldMesh made(joinCells(mesh, domain.core, cut));
    made.notes = coreNotes(domain.core, cut, made, std::cref(fromLayers));
    if (controls.type == farFieldType::hexCore)
    {
        dropEmptySides(layers.border.sides, made);
        addHexCoreZone(mesh.tets.size(), cut.cells.size(), made);
    }

    return made;
}

} // End namespace Foam

// ************************************************************************* //
