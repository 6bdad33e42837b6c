/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "backgroundMesh.H"
#include "improveTets.H"
#include "splitTets.H"
#include "testSurfaces.H"
#include "tetrahedralize.H"
#include "unitConversion.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The unit cube of n^3 cubes, filled; its boundary is far
static farFieldMesh filledCube(const label n)
{
    const wallSurface cube(testSurfaces::cube(n));

    tetDomain domain;
    domain.points = cube.points;
    domain.facets = cube.faces;
    tetMesh filled(tetrahedralize(domain));

    farFieldMesh mesh;
    mesh.points = filled.points;
    mesh.tets = filled.tets;
    mesh.nBoundaryPoints = cube.points.size();
    mesh.boundaryTriangles = cube.faces;
    mesh.neighbours = tetNeighbours(mesh.tets, mesh.points.size());

    return mesh;
}


static scalar volumeOf(const farFieldMesh& mesh)
{
    scalar volume = 0;

    for (const tetCell& tet : mesh.tets)
    {
        EXPECT_GT(tet.tet(mesh.points).mag(), 0);
        volume += tet.tet(mesh.points).mag();
    }

    return volume;
}


//- Most faces that a tetrahedron has on the boundary, and faces there of all
static labelPair boundaryFaces(const farFieldMesh& mesh)
{
    labelPair most(0, 0);

    const List<FixedList<label, 4>> neighbours
    (
        tetNeighbours(mesh.tets, mesh.points.size())
    );
    for (const FixedList<label, 4>& beyond : neighbours)
    {
        label n = 0;
        for (const label t : beyond)
        {
            n += t < 0;
        }
        most.first() = max(most.first(), n);
        most.second() += n;
    }

    return most;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(splitCornerCells, leavesOneFaceOnTheBoundary)
{
    farFieldMesh mesh(filledCube(3));
    EXPECT_GT(boundaryFaces(mesh).first(), 1);

    splitCornerCells(mesh);
    EXPECT_EQ(boundaryFaces(mesh), labelPair(1, 12*9));
    EXPECT_NEAR(volumeOf(mesh), 1, 1e-12);
}


TEST(movePoorPoints, makesFacesMoreOrthogonal)
{
    // A point between the ends of a double pyramid, off its middle
    farFieldMesh mesh;
    mesh.points = pointField
    ({
        point(1, 0, 0), point(0, 1, 0), point(-1, 0, 0), point(0, -1, 0),
        point(0, 0, 1), point(0, 0, -1), point(0.55, 0.4, 0)
    });
    mesh.nBoundaryPoints = 6;
    for (label k = 0; k < 4; ++k)
    {
        mesh.tets.append(tetCell(k, (k + 1) % 4, 4, 6));
        mesh.tets.append(tetCell((k + 1) % 4, k, 5, 6));
    }
    for (tetCell& tet : mesh.tets)
    {
        if (tet.tet(mesh.points).mag() < 0)
        {
            Swap(tet[0], tet[1]);
        }
    }
    mesh.neighbours = tetNeighbours(mesh.tets, mesh.points.size());

    const pointField before(mesh.points);
    movePoorPoints(pointField(), degToRad(30), mesh);

    EXPECT_LT(mag(mesh.points[6]), 0.2*mag(before[6]));
    EXPECT_NEAR(volumeOf(mesh), 4.0/3, 1e-12);

    for (label p = 0; p < 6; ++p)
    {
        EXPECT_EQ(mesh.points[p], before[p]);
    }
}


TEST(splitTets, splitsAtEdgesAndFacesAlikeFromBothSides)
{
    farFieldMesh mesh(filledCube(2));
    const label n = mesh.points.size();

    // Every edge and face that is not on the boundary, of every third cell
    simplexSet simplices;
    forAll(mesh.tets, t)
    {
        if (t % 3 == 0)
        {
            for (label i = 0; i < 4; ++i)
            {
                const triFace f(mesh.tets[t].face(i));

                if (mesh.neighbours[t][i] >= 0)
                {
                    simplices.append(sortedSimplex(f[0], f[1], f[2]));
                }
            }
        }
    }
    simplices.sort();
    EXPECT_FALSE(simplices.empty());

    for (const simplex& s : simplices.simplices())
    {
        mesh.points.append(centreOf(s, mesh.points));
    }
    splitTets(simplices, n, mesh.tets);

    EXPECT_NEAR(volumeOf(mesh), 1, 1e-12);
    EXPECT_EQ(boundaryFaces(mesh).second(), 12*4);
}


// ************************************************************************* //
