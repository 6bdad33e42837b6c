/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "makeFarFieldMesh.H"
#include "backgroundMesh.H"
#include "checkFarBoundary.H"
#include "improveTets.H"
#include "limitGradient.H"
#include "outerTriangles.H"
#include "refineSurface.H"
#include "tetrahedralize.H"
#include "unitConversion.H"
#include "wallSearch.H"

#include <functional>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Tetrahedra of a far field over the integral of 1/size^3, measured
static const scalar tetsPerCube = 10;

//- Cubes of sizes that there may be for each tetrahedron: several times as many
//  as there are, within the body too
static const label cubesPerTet = 4;

//- Non-orthogonality [deg] beyond which points are moved, below the 70 that
//  checkMesh warns of
static const scalar poorAngle = 60;


//- The outer surface of the layers, its polygons cut into triangles, of which
//  faces has the front face of each
static wallSurface outerSurface(const prismLayers& layers, labelList& faces)
{
    wallSurface outer;
    outer.points = layers.outerPoints();
    outer.faces = layers.faces;
    outer.faces = outerTriangles(outer, faces);
    outer.patchIDs = labelList(faces.size(), Zero);
    outer.patchNames = wordList({"layerOuter"});

    return outer;
}


//- Both surfaces, the points of the first before those of the second
static wallSurface joined(const wallSurface& a, const wallSurface& b)
{
    wallSurface both(a);
    both.points.append(b.points);
    both.patchIDs.append(b.patchIDs);

    for (const face& f : b.faces)
    {
        face g(f);
        for (label& p : g)
        {
            p += a.points.size();
        }
        both.faces.append(g);
    }

    return both;
}


//- Points inside the layers, one for each body: of its largest outer face the
//  centre of a tetrahedron that is part of the last cell
static pointField layerSeeds
(
    const prismLayers& layers,
    const wallSurface& outer
)
{
    DynamicList<point> seeds;

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


//- Centres of the last cells, for each triangle on them
static pointField layerCentres
(
    const prismLayers& layers,
    const farFieldMesh& mesh
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


//- Points that are in no tetrahedron, of those that TetGen added, left out
static void compact(farFieldMesh& mesh)
{
    boolList used(mesh.points.size(), false);
    for (const tetCell& tet : mesh.tets)
    {
        for (const label p : tet)
        {
            used[p] = true;
        }
    }

    labelList newLabels(mesh.points.size());
    label n = 0;
    forAll(used, p)
    {
        newLabels[p] = n;

        if (used[p] || p < mesh.nBoundaryPoints)
        {
            mesh.points[n++] = mesh.points[p];
        }
    }
    mesh.points.setSize(n);

    for (tetCell& tet : mesh.tets)
    {
        for (label& p : tet)
        {
            p = newLabels[p];
        }
    }
}


//- By how many cells it would have; 0 where that is not known
static void refuse(const label nCells, const label maxCells)
{
    FatalErrorInFunction
        << "The far field needs "
        << (nCells ? "about " + name(nCells) : word("many more")).c_str()
        << " cells, more than farField.maxCells " << maxCells << nl
        << "Raise that, growthRate or the cell sizes, or make the wall coarser"
        << exit(FatalError);
}


//- Refused where they take many more cubes than there may be cells
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
        cubesPerTet*controls.maxCells
    );

    if (!made.complete())
    {
        refuse(0, controls.maxCells);
    }

    return made;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::farFieldMesh Foam::makeFarFieldMesh
(
    const prismLayers& layers,
    const wallAddressing& frontAddressing,
    const farBoundary& boundary,
    const farFieldControls& controls,
    const sizeBounds& bounds
)
{
    farFieldMesh mesh;
    const wallSurface outer(outerSurface(layers, mesh.outerFaces));
    mesh.outerTriangles = outer.faces;
    mesh.patchNames = boundary.surface.patchNames;
    mesh.patchTypes = boundary.patchTypes;

    boundBox box(outer.points, false);
    box.add(boundary.surface.points);

    // Sizes at the layers, then with those of the boundary
    scalarField sizes(meanEdges(outer, frontAddressing));
    limitGradient(outer, frontAddressing, controls.growthRate - 1, sizes);
    const cellSizes fromLayers
    (
        makeSizes(outer.points, sizes, box, controls, bounds)
    );

    wallSurface far(boundary.surface);
    refineSurface(far, std::cref(fromLayers), boundary.project);
    sizes.append(meanEdges(far, makeWallAddressing(far)));

    const wallSurface both(joined(outer, far));
    mesh.patchIDs = far.patchIDs;
    mesh.boundaryTriangles = SubList<face>
    (
        both.faces, far.faces.size(), mesh.outerTriangles.size()
    );

    if (far.faces.size())
    {
        checkFarBoundary(outer, both.points, mesh);
    }

    const cellSizes wanted
    (
        makeSizes(both.points, sizes, box, controls, bounds)
    );
    const wallSearch search(both);
    const scalar nCells = tetsPerCube*wanted.nCubes
    (
        [&](const point& x) { return search.inFront(x); }
    );

    if (nCells > controls.maxCells)
    {
        refuse(nCells, controls.maxCells);
    }

    tetDomain domain;
    domain.points = both.points;
    domain.facets = both.faces;
    domain.holes = layerSeeds(layers, outer);

    tetMesh filled
    (
        tetrahedralize(domain, std::cref(wanted), controls.maxCells)
    );

    if (filled.tets.size() > controls.maxCells)
    {
        refuse(filled.tets.size(), controls.maxCells);
    }

    mesh.points.transfer(filled.points);
    mesh.tets.transfer(filled.tets);
    mesh.nBoundaryPoints = both.points.size();
    compact(mesh);
    splitCornerCells(mesh);
    mesh.neighbours = tetNeighbours(mesh.tets);
    movePoorPoints(layerCentres(layers, mesh), degToRad(poorAngle), mesh);

    if (!allPositive(mesh.points, mesh.tets))
    {
        FatalErrorInFunction
            << "The tetrahedra of the far field could not be certified"
            << exit(FatalError);
    }

    return mesh;
}


// ************************************************************************* //
