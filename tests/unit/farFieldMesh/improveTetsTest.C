/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "backgroundMesh.H"
#include "improveTets.H"
#include "smallFarFields.H"
#include "tetEditor.H"
#include "unitConversion.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <omp.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The largest non-orthogonality [deg] of the faces inside
static scalar worstAngle(const farFieldTets& mesh)
{
    scalar worst = 0;
    const List<FixedList<label, 4>> neighbours
    (
        tetNeighbours(mesh.tets, mesh.points.size())
    );

    forAll(mesh.tets, t)
    {
        for (label i = 0; i < 4; ++i)
        {
            const label neighbour = neighbours[t][i];

            if (neighbour >= 0)
            {
                const vector area
                (
                    triFace(mesh.tets[t].face(i)).areaNormal(mesh.points)
                );
                const vector between
                (
                    mesh.tets[neighbour].tet(mesh.points).centre()
                  - mesh.tets[t].tet(mesh.points).centre()
                );
                const scalar cosine
                (
                    (area & between)/(mag(area)*mag(between))
                );
                worst = max(worst, radToDeg(::acos(cosine)));
            }
        }
    }

    return worst;
}


static scalar volumeOf(const farFieldTets& mesh)
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
static labelPair boundaryFaces(const farFieldTets& mesh)
{
    labelPair most(0, 0);

    const List<FixedList<label, 4>> neighbours
    (
        tetNeighbours(mesh.tets, mesh.points.size())
    );
    for (const FixedList<label, 4>& ofTet : neighbours)
    {
        label n = 0;
        for (const label t : ofTet)
        {
            n += t < 0;
        }
        most.first() = max(most.first(), n);
        most.second() += n;
    }

    return most;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(removeFlatCells, patchGetsTheOtherDiagonal)
{
    // A pyramid on a square that is flat but for rounding. The patch has one
    // diagonal of the square, the cells below the apex have the other.
    farFieldTets mesh;
    mesh.points = pointField
    ({{0, 0, 0}, {1, 0, 0}, {1, 1, -1e-17}, {0, 1, 0}, {0.5, 0.5, 1}});
    mesh.tets = tetCellList
    ({tetCell(0, 1, 2, 3), tetCell(0, 1, 3, 4), tetCell(1, 2, 3, 4)});
    mesh.nBoundaryPoints = 5;
    mesh.boundaryTriangles = faceList
    ({
        face({0, 1, 2}), face({0, 2, 3}), face({0, 4, 1}), face({1, 4, 2}),
        face({2, 4, 3}), face({3, 4, 0})
    });
    mesh.patchIDs = labelList({0, 0, 1, 1, 1, 1});
    turnPositive(mesh);
    EXPECT_TRUE(isFlat(mesh.points, mesh.tets[0]));

    removeFlatCells(mesh);
    EXPECT_EQ(mesh.tets.size(), 2);
    EXPECT_EQ(boundaryFaces(mesh).second(), 6);
    EXPECT_NEAR(volumeOf(mesh), 1.0/3, 1e-12);
    for (const label i : {0, 1})
    {
        const triFace f(mesh.boundaryTriangles[i]);
        EXPECT_TRUE(f.found(1) && f.found(3));
        EXPECT_GT(f.areaNormal(mesh.points).z(), 0);
    }
}


TEST(removeFlatCells, keepsFlatCellsBetweenTwoPatches)
{
    farFieldTets mesh;
    mesh.points = pointField({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1e-17}});
    mesh.tets = tetCellList({tetCell(0, 1, 2, 3)});
    mesh.nBoundaryPoints = 4;
    mesh.boundaryTriangles = faceList({face({0, 1, 2}), face({1, 3, 2})});
    mesh.patchIDs = labelList({0, 1});

    removeFlatCells(mesh);
    EXPECT_EQ(mesh.tets.size(), 1);
}


TEST(removeFlatCells, keepsFlatCellsOnAWall)
{
    // The patch would get the triangle of the wall
    farFieldTets mesh;
    mesh.points = pointField({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1e-17}});
    mesh.tets = tetCellList({tetCell(0, 1, 2, 3)});
    mesh.nBoundaryPoints = 4;
    mesh.boundaryTriangles = faceList({face({0, 1, 2}), face({1, 3, 2})});
    mesh.patchIDs = labelList({0, 0});
    mesh.outerTriangles = faceList({face({0, 1, 3})});

    removeFlatCells(mesh);
    EXPECT_EQ(mesh.tets.size(), 1);
}


TEST(splitCornerCells, leavesOneFaceOnTheBoundary)
{
    farFieldTets mesh(filledCube(3));
    EXPECT_GT(boundaryFaces(mesh).first(), 1);

    splitCornerCells(mesh);
    EXPECT_EQ(boundaryFaces(mesh), labelPair(1, 12*9));
    EXPECT_NEAR(volumeOf(mesh), 1, 1e-12);
}


TEST(splitCornerCells, keepsTheLayersWhereTheyEndOnTheBoundary)
{
    // Two tetrahedra with a common face. The layers are below both, whose other
    // faces are on the boundary, and so are all points.
    farFieldTets mesh;
    mesh.points = pointField
    ({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}});
    mesh.tets = tetCellList({tetCell(0, 1, 2, 3), tetCell(1, 2, 3, 4)});
    mesh.nBoundaryPoints = 5;
    mesh.outerTriangles = faceList({face({0, 1, 2}), face({2, 1, 4})});
    mesh.boundaryTriangles = faceList
    ({
        face({0, 2, 3}), face({0, 3, 1}), face({1, 3, 4}), face({3, 2, 4})
    });
    turnPositive(mesh);

    splitCornerCells(mesh);
    EXPECT_GT(mesh.tets.size(), 2);
    EXPECT_EQ(boundaryFaces(mesh), labelPair(1, 6));
    EXPECT_NEAR(volumeOf(mesh), 0.5, 1e-12);
}


TEST(improveTets, movesAPoint)
{
    // A point near to an end of a slender double pyramid
    farFieldTets mesh;
    mesh.points = pointField
    ({
        point(0.3, 0, 0), point(0, 0.3, 0), point(-0.3, 0, 0),
        point(0, -0.3, 0), point(0, 0, 1), point(0, 0, -1), point(0, 0, 0.9)
    });
    mesh.nBoundaryPoints = 6;
    for (label k = 0; k < 4; ++k)
    {
        mesh.tets.append(tetCell(k, (k + 1) % 4, 4, 6));
        mesh.tets.append(tetCell((k + 1) % 4, k, 5, 6));
    }
    turnPositive(mesh);

    EXPECT_GT(worstAngle(mesh), 75);

    const pointField before(mesh.points);
    improveTets(neighbourCells(), mesh);

    EXPECT_LT(worstAngle(mesh), 67);
    EXPECT_NEAR(volumeOf(mesh), 0.12, 1e-12);

    for (label p = 0; p < 6; ++p)
    {
        EXPECT_EQ(mesh.points[p], before[p]);
    }
}


TEST(improveTets, removesAnEdge)
{
    // Three tetrahedra around an edge; their triangle is better without it
    farFieldTets mesh;
    mesh.points = pointField
    ({
        point(0.3, 0.9, -0.5), point(-0.4, -0.2, 0.3),
        point(0.9, -0.6, 0.6), point(1, -0.5, 0.9), point(-0.8, 0.6, -0.4)
    });
    mesh.nBoundaryPoints = 5;
    mesh.tets = tetCellList
    ({
        tetCell(0, 1, 2, 3), tetCell(0, 1, 3, 4), tetCell(0, 1, 4, 2)
    });
    turnPositive(mesh);
    EXPECT_GT(worstAngle(mesh), 80);

    const scalar volume = volumeOf(mesh);
    improveTets(neighbourCells(), mesh);

    EXPECT_EQ(mesh.points.size(), 5);
    EXPECT_EQ(mesh.tets.size(), 2);
    EXPECT_LT(worstAngle(mesh), 20);
    EXPECT_NEAR(volumeOf(mesh), volume, 1e-12);
}


TEST(improveTets, addsPoints)
{
    farFieldTets mesh(filledCube(4));
    const label nPoints = mesh.points.size();
    EXPECT_GT(worstAngle(mesh), 75);

    improveTets(neighbourCells(), mesh);

    EXPECT_GT(mesh.points.size(), nPoints);
    EXPECT_LT(worstAngle(mesh), 67);
    EXPECT_NEAR(volumeOf(mesh), 1, 1e-12);
    EXPECT_EQ
    (
        mesh.neighbours, tetNeighbours(mesh.tets, mesh.points.size())
    );

    // What is good is left alone
    const farFieldTets before(mesh);
    improveTets(neighbourCells(), mesh);
    EXPECT_EQ(mesh.points, before.points);
    EXPECT_EQ(mesh.tets, before.tets);
}


TEST(improveTets, isTheSameOnAnyNumberOfThreads)
{
    const farFieldTets before(filledCube(8));
    const label nThreads = omp_get_max_threads();
    farFieldTets first(before);
    omp_set_num_threads(1);
    improveTets(neighbourCells(), first);
    EXPECT_NE(first.tets, before.tets);

    for (const label n : {2, 3, 5, 8})
    {
        farFieldTets mesh(before);
        omp_set_num_threads(n);
        improveTets(neighbourCells(), mesh);
        EXPECT_EQ(mesh.points, first.points) << n;
        EXPECT_EQ(mesh.tets, first.tets) << n;
        EXPECT_EQ(mesh.neighbours, first.neighbours) << n;
    }

    omp_set_num_threads(nThreads);
}


TEST(splitTets, splitsAtEdgesAndFacesAlikeFromBothSides)
{
    farFieldTets mesh(filledCube(2));
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
    splitTets(simplices, mesh.points, n, mesh.tets);

    EXPECT_NEAR(volumeOf(mesh), 1, 1e-12);
    EXPECT_EQ(boundaryFaces(mesh).second(), 12*4);
}


TEST(splitTets, splitsAtTheShortestEdgeFirst)
{
    // Edges 0-1 and 0-2 meet in point 0. After a split at 0-1 the part with
    // point 0 has a new edge from the middle of 0-1 to 2; the other order has
    // one from the middle of 0-2 to 1.
    const auto joins = [](const scalar x, const label newPoint, const label p)
    {
        const pointField points
        ({
            point(0, 0, 0), point(x, 0, 0), point(0, 1, 0), point(0, 0, 1),
            point(x/2, 0, 0), point(0, 0.5, 0)
        });
        simplexSet simplices;
        simplices.append(sortedSimplex(-1, 0, 1));
        simplices.append(sortedSimplex(-1, 0, 2));
        simplices.sort();

        tetCellList tets(1, tetCell(0, 1, 2, 3));
        splitTets(simplices, points, 4, tets);

        return std::any_of(tets.begin(), tets.end(), [&](const tetCell& tet)
        {
            return tet.found(newPoint) && tet.found(p);
        });
    };

    EXPECT_TRUE(joins(0.9, 4, 2));
    EXPECT_FALSE(joins(0.9, 5, 1));
    EXPECT_TRUE(joins(1.1, 5, 1));
    EXPECT_FALSE(joins(1.1, 4, 2));
}


// ************************************************************************* //
