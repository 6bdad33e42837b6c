/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farFieldTets.H"
#include "bitSet.H"
#include "farFieldMeshControls.H"
#include "ListOps.H"
#include "packPoints.H"
#include "refineTets.H"
#include "SubList.H"
#include "tetrahedralize.H"
#include "triangleIndex.H"
#include "wallChanges.H"
#include "wallSearch.H"

#include <algorithm>
#include <numeric>

namespace Foam
{

// * * * * * * * * * * * * * * * Boundary Tets * * * * * * * * * * * * * * * //

boundaryTets findBoundaryTets(const farFieldTets& tets)
{
    faceList triangles(tets.outerTriangles);
    triangles.append(tets.boundaryTriangles);
    triangles.append(tets.cutTriangles);
    const triangleIndex index(makeTriangleIndex(triangles));
    labelList found(triangles.size(), -1);
    forAll(tets.tets, t)
    {
        for (label i = 0; i < 4; ++i)
        {
            if (tets.neighbours[t][i] < 0)
            {
                found[index[tets.tets[t].face(i)]] = t;
            }
        }
    }

    const label n = tets.outerTriangles.size();
    const label m = tets.boundaryTriangles.size();

    return boundaryTets
    {
        SubList<label>(found, n),
        SubList<label>(found, m, n),
        SubList<label>(found, tets.cutTriangles.size(), n + m)
    };
}


// * * * * * * * * * * * * * *  Fill With Tets * * * * * * * * * * * * * * * //

//- Leaves out the points inside that are in no tetrahedron
static void compact(farFieldTets& mesh)
{
    bitSet used(mesh.points.size());
    used.set(labelRange(0, mesh.nBoundaryPoints));
    for (const tetCell& tet : mesh.tets)
    {
        used.set(tet);
    }

    const labelList newLabels(invert(used));
    inplaceSubset(used, mesh.points);
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
        << "Raise maxCells, growthRate or the cell sizes, or make the wall"
        << " coarser" << exit(FatalError);
}


cellSizes makeSizes
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


//- Moves every few of the wanted points to the points of TetGen's domain, and
//  sets the nearest of these for each point that stays
static void moveSome(wantedPoints& wanted, pointField& domainPoints)
{
    const label stride = farFieldTuned.firstPacked;
    DynamicList<point> moved, staying;
    DynamicList<label> near;
    forAll(wanted.points, i)
    {
        if (i % stride == 0)
        {
            moved.append(wanted.points[i]);
        }
        else
        {
            staying.append(wanted.points[i]);
            near.append(domainPoints.size() + i/stride);
        }
    }
    domainPoints.append(moved);
    wanted.points = staying;
    wanted.near = near;
}


void fillWithTets
(
    const wallSurface& both,
    const pointField& holes,
    const cellSizes& sizes,
    const label maxCells,
    farFieldTets& mesh
)
{
    const wallSearch search(both);
    const cubeCentres cubes
    (
        cubesBetween
        (
            both.points, search, sizes, farFieldTuned.cubesPerTet*maxCells
        )
    );
    const scalar nCells = farFieldTuned.tetsPerCube*cubes.nCubes;
    if (!cubes.complete || nCells > maxCells)
    {
        refuse(cubes.complete ? nCells : 0, maxCells);
    }

    // No more points than for a mesh of that size
    const label mostCells = min
    (
        scalar(maxCells),
        farFieldTuned.cellsPerEstimated*nCells
      + farFieldTuned.cellsPerTriangle*both.faces.size()
    );
    tetDomain domain{both.points, both.faces, holes, !mesh.hasLayers};
    wantedPoints wanted;
    if (mesh.cutTriangles.empty())
    {
        // Beside a core the space is only a few cells wide
        wanted.points = packPoints(both.points, search, sizes, cubes);
        moveSome(wanted, domain.points);
    }
    tetMesh filled(tetrahedralize(domain));
    refineTets(wanted, std::cref(sizes), mostCells, filled);

    if (filled.tets.size() > maxCells)
    {
        refuse(filled.tets.size(), maxCells);
    }

    mesh.points.transfer(filled.points);
    mesh.tets.transfer(filled.tets);
    compact(mesh);
}


// * * * * * * * * * * * * * * * * Renumber  * * * * * * * * * * * * * * * * //

//- Returns new labels of tetrahedra, in the order of their first points
static labelList newLabelsByPoints
(
    const tetCellList& tets,
    const label nPoints
)
{
    const auto first = [](const tetCell& tet)
    {
        return *std::min_element(tet.begin(), tet.end());
    };
    labelList starts(nPoints + 1, 0);
    for (const tetCell& tet : tets)
    {
        ++starts[first(tet) + 1];
    }
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    labelList newLabels(tets.size());
    forAll(tets, t)
    {
        newLabels[t] = starts[first(tets[t])]++;
    }

    return newLabels;
}


void renumber(farFieldTets& mesh)
{
    const label n = mesh.nBoundaryPoints;
    labelList newPoints(identity(mesh.points.size()));
    const labelList order
    (
        hilbertOrder(SubList<point>(mesh.points, mesh.points.size() - n, n))
    );
    forAll(order, i)
    {
        newPoints[n + order[i]] = n + i;
    }
    inplaceReorder(newPoints, mesh.points);

    #pragma omp parallel for schedule(static)
    forAll(mesh.tets, t)
    {
        inplaceRenumber(newPoints, mesh.tets[t]);
    }
    const labelList newTets
    (
        newLabelsByPoints(mesh.tets, mesh.points.size())
    );
    inplaceReorder(newTets, mesh.tets);
    inplaceReorder(newTets, mesh.neighbours);

    #pragma omp parallel for schedule(static)
    forAll(mesh.neighbours, t)
    {
        for (label& neighbour : mesh.neighbours[t])
        {
            neighbour = neighbour < 0 ? -1 : newTets[neighbour];
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
