/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "makeFarFieldMesh.H"
#include "backgroundMesh.H"
#include "farFieldMeshControls.H"
#include "improveTets.H"
#include "limitGradient.H"
#include "outerTriangles.H"
#include "readWallSurface.H"
#include "refineSurface.H"
#include "sideRemainders.H"
#include "sideShape.H"
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


//- The points and triangles of both, those of the first before the others. The
//  first points of the second surface are points of the first.
static wallSurface joined
(
    const wallSurface& a,
    const wallSurface& b,
    const labelUList& common
)
{
    const label nCommon = common.size();
    const label n = b.points.size() - nCommon;

    wallSurface both;
    both.points = a.points;
    both.points.append(SubList<point>(b.points, n, nCommon));
    both.faces = a.faces;
    both.faces.append(b.faces);

    for (label i = a.faces.size(); i < both.faces.size(); ++i)
    {
        for (label& p : both.faces[i])
        {
            p = p < nCommon ? common[p] : p - nCommon + a.points.size();
        }
    }

    return both;
}


//- A point inside the layers of each body: the centre of a tetrahedron in the
//  last cell on its largest outer face
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


//- The centre of the last cell below each outer triangle
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


//- Leaves out the points that TetGen added and that are in no tetrahedron
static void compact(farFieldMesh& mesh)
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
static tetMesh fill
(
    const wallSurface& both,
    const pointField& holes,
    const cellSizes& sizes,
    const label maxCells
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

    return filled;
}


//- Makes the tetrahedra better; they remain positive
static void improve(const prismLayers& layers, farFieldMesh& mesh)
{
    splitCornerCells(mesh);
    improvePoorTets(layerCentres(layers, mesh), mesh);

    if (!allPositive(mesh.points, mesh.tets))
    {
        FatalErrorInFunction
            << "The tetrahedra of the far field could not be certified"
            << exit(FatalError);
    }
}


//- Puts the points whose triangles are of one curved side patch, or of sectors
//  of one, on it; not those of the layers. Then merges patches of one name.
static void putOnSides
(
    const UList<sidePatch>& sides,
    const endedBoundary& ended,
    wallSurface& far
)
{
    labelList patches(far.points.size(), -1);
    bitSet onSeveral(far.points.size());

    forAll(far.faces, facei)
    {
        const label patchi = far.patchIDs[facei];

        for (const label p : far.faces[facei])
        {
            const label other = patches[p];
            if (other >= 0 && far.patchNames[other] != far.patchNames[patchi])
            {
                onSeveral.set(p);
            }
            patches[p] = patchi;
        }
    }

    for (label p = ended.columns.size(); p < far.points.size(); ++p)
    {
        const label s = patches[p] - ended.firstSide;

        if (s >= 0 && sides[s].isCurved() && !onSeveral.test(p))
        {
            far.points[p] = sides[s].shape->nearest(far.points[p]).rawPoint();
        }
    }

    // In the order of the far boundary's patches: some of them are sides
    for (label& patchi : far.patchIDs)
    {
        patchi = far.patchNames.find(far.patchNames[patchi]);
    }
    mergePatches(far);
}


//- The boundary of the far field with triangles of the given size [m], and the
//  columns on whose outer points its first points are
static wallSurface refinedBoundary
(
    const prismLayers& layers,
    const farBoundary& boundary,
    const std::function<scalar(const point&)>& size,
    labelList& columns
)
{
    wallSurface far(boundary.surface);
    far.patchTypes = boundary.patchTypes;

    if (layers.border.sides.empty())
    {
        refineSurface(far, size, boundary.project);

        return far;
    }

    const endedBoundary ended(makeEndedBoundary(layers, boundary, size));
    columns = ended.columns;
    far = ended.surface;
    refineSurface(far, size, boundary.project);
    putOnSides(layers.border.sides, ended, far);

    return far;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

farFieldMesh makeFarFieldMesh
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
    boundBox box(outer.points, false);
    box.add(boundary.surface.points);

    // Sizes at the layers, then with those of the boundary
    scalarField sizes(meanEdges(outer, frontAddressing));
    limitGradient(outer, frontAddressing, controls.growthRate - 1, sizes);
    const cellSizes fromLayers
    (
        makeSizes(outer.points, sizes, box, controls, bounds)
    );

    labelList columns;
    const wallSurface far
    (
        refinedBoundary(layers, boundary, std::cref(fromLayers), columns)
    );
    const label nCommon = columns.size();
    const scalarField farSizes(meanEdges(far, makeWallAddressing(far)));
    sizes.append(SubList<scalar>(farSizes, farSizes.size() - nCommon, nCommon));

    const wallSurface both(joined(outer, far, columns));
    if (far.faces.size())
    {
        checkFarBoundary(both, outer.faces.size());
    }
    tetMesh filled
    (
        fill
        (
            both,
            layerSeeds(layers, outer),
            makeSizes(both.points, sizes, box, controls, bounds),
            controls.maxCells
        )
    );

    mesh.points.transfer(filled.points);
    mesh.tets.transfer(filled.tets);
    mesh.nBoundaryPoints = both.points.size();
    mesh.outerTriangles = outer.faces;
    mesh.boundaryTriangles = faceList
    (
        SubList<face>(both.faces, far.faces.size(), outer.faces.size())
    );
    mesh.patchIDs = far.patchIDs;
    mesh.patchNames = far.patchNames;
    mesh.patchTypes = far.patchTypes;
    compact(mesh);
    improve(layers, mesh);

    return mesh;
}

} // End namespace Foam

// ************************************************************************* //
