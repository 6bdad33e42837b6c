/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "makeFarFieldMesh.H"
#include "backgroundMesh.H"
#include "coreBoundary.H"
#include "coreZones.H"
#include "farFieldSizes.H"
#include "farFieldTets.H"
#include "improveTets.H"
#include "ListOps.H"
#include "mergeCells.H"
#include "planarColumns.H"
#include "planarFarField.H"
#include "prismQuality.H"
#include "ranges.H"
#include "replacedPatches.H"
#include "tetBoundary.H"
#include "tetrahedralize.H"

#include <memory>

namespace Foam
{

// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

const word farFieldName("farField");
const word hexCoreName("hexCore");


//- The triangles of the outer surface of the layers, and their front faces
static wallSurface outerSurface(const prismLayers& layers, labelList& faces)
{
    wallSurface outer(outerPolygons(layers));
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
    removeFlatCells(mesh);
    splitCornerCells(mesh);

    neighbourCells neighbours;
    if (mesh.hasLayers)
    {
        neighbours.centres = layerCentres(layers, mesh);
    }
    neighbours.volumes.setSize(neighbours.centres.size(), 0);
    pointField centres;
    scalarField volumes;
    setCentresAndVolumes(core, mesh.cutCells, centres, volumes);
    neighbours.centres.append(centres);
    neighbours.volumes.append(volumes);
    improveTets(neighbours, mesh);
    renumber(mesh);

    label flat = labelMax;

    #pragma omp parallel for schedule(static) reduction(min:flat)
    forAll(mesh.tets, t)
    {
        if (!allPositive(mesh.points, SubList<tetCell>(mesh.tets, 1, t)))
        {
            flat = min(flat, t);
        }
    }
    if (flat < labelMax)
    {
        throw flatCellError(mesh.tets[flat].tet(mesh.points).centre());
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
            << " them, at " << both.points[0] << nl
            << "Has the mesh other units than the surface (surface.scale)? Is"
            << " it another region (farField.region)?" << exit(FatalError);
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


//- Tells the user of patches that were asked for and have no faces
static void noteEmptyPatches
(
    const List<farPatch>& wanted,
    farFieldMesh& far
)
{
    for (const farPatch& patch : wanted)
    {
        const label patchi = far.patches.names.find(patch.name);
        if (patchi < 0 || far.topology.patchSizes[1 + patchi] == 0)
        {
            far.notes.append
            (
                "The patch " + patch.name + " of the far boundary has no faces:"
              + " the fluid reaches none of its sides"
            );
        }
    }
}


//- Names the patches of the core that the patches of the wall replace, also to
//  the user
static void setReplaced
(
    const prismLayers& layers,
    const polyMeshParts& core,
    const coreCut& cut,
    farFieldMesh& far
)
{
    const labelList replaced(replacedPatches(layers, core, cut.wallPatches));
    forAll(replaced, patchi)
    {
        const label old = replaced[patchi];
        const word name(old < 0 ? word::null : core.patches.names[old]);
        far.replaced.names.append(name);
        far.replaced.entries.append
        (
            old < 0 ? dictionary() : core.patches.entries[old]
        );
        if (name.size() && name != layers.patchNames[patchi])
        {
            far.notes.append
            (
                "The patch " + layers.patchNames[patchi] + " of the wall has"
              + " the name " + name + " of the patch that it replaces"
            );
        }
    }
}


//- Names the hexahedra of a core. They come after the tetrahedra. Then merges
//  tetrahedra, if the controls ask for polyhedra, and sets the grade, unless
//  the far field is for polygons.
static void finish
(
    const prismLayers& layers,
    const farFieldControls& controls,
    const label nTets,
    farFieldMesh& far
)
{
    const bool isHexCore = controls.type == farFieldType::hexCore;
    noteEmptyPatches(controls.boundary.patches, far);
    if (isHexCore || emptySides(layers.border).first() >= 0)
    {
        dropEmptySides(layers.border.sides, far);
    }
    if (isHexCore)
    {
        far.cellZones.append
        (
            cellZoneParts(hexCoreName, identity(far.nCells - nTets, nTets))
        );
    }
    if (!controls.forPolygons)
    {
        mergeControls merges;
        merges.maxTets = controls.polyhedra ? merges.maxTets : 0;
        mergeCells(layers, frontAddressing(layers), nTets, merges, far);
    }
}


//- Tetrahedra, and beside them what stays of a core.
//  fromLayers: as sizesFromLayers returns them
static farFieldMesh fillWithCells
(
    const prismLayers& layers,
    const wallSurface& outer,
    const layerSizes& fromLayers,
    farFieldDomain& domain,
    const farFieldControls& controls,
    farFieldTets& mesh
)
{
    coreCut cut;
    const tetBoundary far
    (
        controls.type == farFieldType::tet
      ? makeTetBoundary(layers, domain.boundary, std::cref(fromLayers.inSpace))
      : makeCoreBoundary
        (
            layers, outer, controls, std::cref(fromLayers.inSpace), domain,
            cut
        )
    );
    const wallSurface both(joined(outer, far));
    checkBoundary(both, outer.faces.size(), domain.core);
    setBoundary(outer, both, far, mesh);

    const std::unique_ptr<const cellSizes> fromBoth
    (
        hasOwnSizes(controls)
      ? sizesFromBoth(both, fromLayers.atPoints, far, domain, controls)
      : nullptr
    );
    const cellSizes& sizes = fromBoth ? *fromBoth : fromLayers.inSpace;
    fillWithTets
    (
        both, seedsOf(layers, outer, far), sizes, controls.maxCells, mesh
    );
    improve(layers, domain.core, mesh);

    farFieldMesh made(joinCells(mesh, domain.core, cut));
    made.notes =
        coreNotes(domain.core, cut, made, std::cref(fromLayers.inSpace));
    setReplaced(layers, domain.core, cut, made);

    return made;
}


//- Makes the far field.
//  Errors: flatCellError, and those of makeFarFieldMesh
static farFieldMesh tryFarFieldMesh
(
    const prismLayers& layers,
    farFieldDomain domain,
    const farFieldControls& controls
)
{
    farFieldTets mesh;
    mesh.hasLayers = layers.nLayers > 0;
    const wallSurface outer(outerSurface(layers, mesh.outerFaces));
    const labelList across
    (
        columnsAcross(layers.faces, layers.border, layers.pointsOf(0))
    );
    const layerSizes sizes
    (
        sizesFromLayers
        (
            outer, frontAddressing(layers), layers.border, across, domain,
            controls
        )
    );

    farFieldMesh made
    (
        across.size()
      ? makePlanarFarField
        (
            layers, across,
            makeTetBoundary
            (
                layers, domain.boundary, std::cref(sizes.inSpace)
            ),
            domain.boundary.cyclicSides
        )
      : fillWithCells(layers, outer, sizes, domain, controls, mesh)
    );
    const label nStaying =
        across.size() ? 0 : made.nCells - mesh.tets.size();
    finish(layers, controls, mesh.tets.size(), made);
    requireVolumes(made, made.nCells - nStaying);
    setCyclic(domain.boundary.cyclicSides, made.patches);

    return made;
}


//- So often the far field is made with other sizes if cells are flat
static constexpr label nRetries = 3;

//- The share of the growth by which the growth rate falls each time
static constexpr scalar growthShare = 0.05;


farFieldMesh makeFarFieldMesh
(
    const prismLayers& layers,
    farFieldDomain domain,
    const farFieldControls& controls
)
{
    // A mesh around the layers would be there twice
    const label nTries = controls.type == farFieldType::mesh ? 0 : nRetries;
    farFieldControls changed(controls);
    for (label n = 0; n < nTries; ++n)
    {
        try
        {
            farFieldMesh made(tryFarFieldMesh(layers, domain, changed));
            if (n)
            {
                made.notes.append
                (
                    "Cells were flat but for rounding with growthRate "
                  + name(controls.growthRate) + ": made with "
                  + name(changed.growthRate)
                );
            }

            return made;
        }
        catch (const flatCellError&)
        {
            changed.growthRate -= growthShare*(controls.growthRate - 1);
        }
    }

    return tryFarFieldMesh(layers, std::move(domain), changed);
}

} // End namespace Foam

// ************************************************************************* //
