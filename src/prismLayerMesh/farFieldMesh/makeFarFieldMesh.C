/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "makeFarFieldMesh.H"
#include "backgroundMesh.H"
#include "coreBoundary.H"
#include "coreNotes.H"
#include "farFieldMeshControls.H"
#include "improveTets.H"
#include "limitGradient.H"
#include "outerTriangles.H"
#include "tetrahedralize.H"
#include "wallSearch.H"

#include <functional>

namespace Foam
{

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


//- A point inside the layers of each body, the centre of a tetrahedron in the
//  last cell on its largest outer face, and those in what stays of a core
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
        const face& f = outer.faces[i];
        seeds.append
        (
            0.25
           *(
                outer.points[f[0]] + outer.points[f[1]] + outer.points[f[2]]
              + layers(f[0], layers.nLayers - 1)
            )
        );
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


//- Leaves out the points that TetGen added and that are in no tetrahedron
static void compact(farFieldTets& mesh)
{
    boolList used(mesh.nBoundaryPoints, true);
    used.setSize(mesh.points.size(), false);

    for (const tetCell& tet : mesh.tets)
    {
        for (const label p : tet)
        {
            used[p] = true;
        }
    }

    const labelList kept(findIndices(used, true));
    const labelList newLabels(invert(used.size(), kept));
    mesh.points = pointField(mesh.points, kept);

    for (tetCell& tet : mesh.tets)
    {
        inplaceRenumber(newLabels, tet);
    }
}


//- The number of cells that it needs is 0 if it is not known
static void refuse(const label nCells, const label maxCells)
{
    FatalErrorInFunction
        << "The far field needs "
        << (nCells ? "about " + name(nCells) : word("many more")).c_str()
        << " cells, more than farField.maxCells " << maxCells << nl
        << "Raise that, growthRate or the cell sizes, or make the wall coarser"
        << exit(FatalError);
}


//- The sizes from those at the points, refused if they are not complete
static cellSizes makeSizes
(
    const pointField& points,
    const scalarField& sizes,
    const boundBox& box,
    const farFieldControls& controls,
    const sizeBounds& bounds
)
{
    const cellSizes made
    (
        points, sizes, controls.growthRate, box, bounds,
        farFieldTuned.cubesPerTet*controls.maxCells
    );

    if (!made.complete())
    {
        refuse(0, controls.maxCells);
    }

    return made;
}


//- The tetrahedra between the surfaces, in front of them, refused if there are
//  or would be too many
static void fill
(
    const wallSurface& both,
    const pointField& holes,
    const cellSizes& sizes,
    const label maxCells,
    farFieldTets& mesh
)
{
    const wallSearch search(both);
    const scalar nCells = farFieldTuned.tetsPerCube*sizes.nCubes
    (
        [&](const point& x) { return search.inFront(x); }
    );

    if (nCells > maxCells)
    {
        refuse(nCells, maxCells);
    }

    // What TetGen may take, in cells and in time, is for a mesh of that size
    const label mostCells = min
    (
        scalar(maxCells),
        farFieldTuned.cellsPerEstimated*nCells
      + farFieldTuned.cellsPerTriangle*both.faces.size()
    );
    const tetDomain domain{both.points, both.faces, holes};
    tetMesh filled(tetrahedralize(domain, std::cref(sizes), mostCells));

    if (filled.tets.size() > maxCells)
    {
        refuse(filled.tets.size(), maxCells);
    }

    mesh.points.transfer(filled.points);
    mesh.tets.transfer(filled.tets);
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

    cellsBeyond beyond;
    beyond.centres = layerCentres(layers, mesh);
    beyond.volumes.setSize(beyond.centres.size(), 0);
    pointField centres;
    scalarField volumes;
    setCentresAndVolumes(core, mesh.cutCells, centres, volumes);
    beyond.centres.append(centres);
    beyond.volumes.append(volumes);
    improvePoorTets(beyond, mesh);

    if (!allPositive(mesh.points, mesh.tets))
    {
        FatalErrorInFunction
            << "The tetrahedra of the far field could not be certified"
            << exit(FatalError);
    }
}


//- Sizes at the points of the layers
static scalarField layerSizes
(
    const wallSurface& outer,
    const wallAddressing& addressing,
    const scalar growthRate
)
{
    scalarField sizes(meanEdges(outer, addressing));
    limitGradient(outer, addressing, growthRate - 1, sizes);

    return sizes;
}


//- Sizes at the points of the far boundary that are not on the layers
static scalarField sizesOf(const tetBoundary& far)
{
    const label nCommon = far.columns.size();
    const scalarField sizes
    (
        meanEdges(far.surface, makeWallAddressing(far.surface))
    );

    return scalarField
    (
        SubList<scalar>(sizes, sizes.size() - nCommon, nCommon)
    );
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
}


static void setBoundary
(
    const wallSurface& outer,
    const tetBoundary& far,
    farFieldTets& mesh
)
{
    const label nOuter = outer.points.size();
    const wallSurface both(joined(outer, far));
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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

farFieldMesh makeFarFieldMesh
(
    const prismLayers& layers,
    const wallAddressing& frontAddressing,
    farFieldDomain domain,
    const farFieldControls& controls
)
{
    farFieldTets mesh;
    const wallSurface outer(outerSurface(layers, mesh.outerFaces));
    scalarField sizes
    (
        layerSizes(outer, frontAddressing, controls.growthRate)
    );
    boundBox box(outer.points, false);
    box.add(domain.boundary.surface.points);
    box.add(domain.core.points);
    const cellSizes fromLayers
    (
        makeSizes(outer.points, sizes, box, controls, domain.bounds)
    );

    coreCut cut;
    const tetBoundary far
    (
        controls.type == "tet"
      ? makeTetBoundary(layers, domain.boundary, std::cref(fromLayers))
      : makeCoreBoundary
        (
            layers, outer, controls, std::cref(fromLayers), domain, cut
        )
    );
    const wallSurface both(joined(outer, far));
    checkBoundary(both, outer.faces.size(), domain.core);
    sizes.append(sizesOf(far));

    fill
    (
        both, seedsOf(layers, outer, far),
        makeSizes
        (
            both.points, sizes, boundBox(both.points, false), controls,
            domain.bounds
        ),
        controls.maxCells, mesh
    );
    setBoundary(outer, far, mesh);
    compact(mesh);
    improve(layers, domain.core, mesh);

    farFieldMesh made(joinCells(mesh, domain.core, cut));
    made.notes = coreNotes(domain.core, cut, made, std::cref(fromLayers));

    return made;
}

} // End namespace Foam

// ************************************************************************* //
