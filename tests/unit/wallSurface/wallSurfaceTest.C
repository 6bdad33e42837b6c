/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "testSurfaces.H"
#include "triSurface.H"
#include "wallSurface.H"

#include <gtest/gtest.h>

#include <set>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(wallSurface, normalsHaveUnitLengthAndPointOut)
{
    const wallSurface wall(quadSphere(5));
    const vectorField normals(wall.faceNormals());

    forAll(normals, i)
    {
        EXPECT_NEAR(mag(normals[i]), 1, 1e-14);
        EXPECT_GT(normals[i] & wall.faces[i].centre(wall.points), 0.9);
    }
}


TEST(wallSurface, degenerateFaceHasNoNormal)
{
    wallSurface wall(cube(1));
    wall.faces[0][2] = wall.faces[0][1];

    EXPECT_EQ(wall.faceNormals()[0], vector::zero);
}


TEST(wallSurface, edgesAreThereOnceWithTheirFaces)
{
    const wallSurface wall(quadCube(3));
    const wallAddressing a(makeWallAddressing(wall));

    // Euler: V - E + F = 2
    EXPECT_EQ(a.edges.size(), wall.points.size() + wall.faces.size() - 2);

    std::set<std::pair<label, label>> seen;

    forAll(a.edges, i)
    {
        const edge& e = a.edges[i];
        const label low = min(e.first(), e.second());
        const label high = max(e.first(), e.second());
        EXPECT_TRUE(seen.insert({low, high}).second);

        // The first face runs along the edge, the second against it
        EXPECT_EQ(wall.faces[a.edgeFaces[i].first()].edgeDirection(e), 1);
        EXPECT_EQ(wall.faces[a.edgeFaces[i].second()].edgeDirection(e), -1);
    }
}


TEST(wallSurface, openEdgeHasOneFace)
{
    wallSurface wall(cube(1));
    wall.faces.setSize(11);

    const wallAddressing a(makeWallAddressing(wall));
    label nOpen = 0;

    for (const labelPair& faces : a.edgeFaces)
    {
        nOpen += (faces.second() < 0);
    }

    EXPECT_EQ(nOpen, 3);
}


TEST(wallSurface, fansAreOrderedByRotation)
{
    for (const wallSurface& wall : {sphere(4), quadSphere(3), lBlock(4)})
    {
        const wallAddressing a(makeWallAddressing(wall));

        forAll(wall.points, p)
        {
            const labelList& faces = a.pointFaces[p];
            const labelList& points = a.pointPoints[p];
            ASSERT_GE(faces.size(), 3);
            ASSERT_EQ(faces.size(), points.size());

            forAll(faces, i)
            {
                // Counter-clockwise, face i goes from edge i to edge i + 1
                const face& f = wall.faces[faces[i]];
                EXPECT_EQ(f.nextLabel(f.find(p)), points[i]);
                EXPECT_EQ(f.prevLabel(f.find(p)), points[points.fcIndex(i)]);
            }
        }
    }
}


TEST(wallSurface, fansBeginAtTheSamePlaceHoweverPointsAreNumbered)
{
    const wallSurface wall(lBlock(4));
    const wallSurface other(renumbered(wall, 5));
    const wallAddressing a(makeWallAddressing(wall));
    const wallAddressing b(makeWallAddressing(other));

    forAll(wall.points, p)
    {
        const label q = other.points.find(wall.points[p]);

        ASSERT_GE(q, 0);
        EXPECT_EQ
        (
            wall.points[a.pointPoints[p][0]], other.points[b.pointPoints[q][0]]
        );
    }
}


TEST(wallSurface, fansHoldEveryCornerOnce)
{
    const wallSurface wall(torus(12, 8, 2, 0.5));
    const wallAddressing a(makeWallAddressing(wall));
    label nCorners = 0;

    for (const labelList& faces : a.pointFaces)
    {
        nCorners += std::set<label>(faces.begin(), faces.end()).size();
    }

    EXPECT_EQ(nCorners, 3*wall.faces.size());
}


TEST(wallSurface, enclosesItsVolume)
{
    const vector far(100, -200, 300);

    for (const wallSurface& wall : {lBlock(3), quadCube(3, 2), sphere(6)})
    {
        const scalar volume = testSurfaces::enclosedVolume(wall);

        EXPECT_NEAR(Foam::enclosedVolume(wall), volume, 1e-12);
        EXPECT_NEAR(Foam::enclosedVolume(reversed(wall)), -volume, 1e-12);
        EXPECT_NEAR(Foam::enclosedVolume(translated(wall, far)), volume, 1e-9);
    }
}


TEST(wallSurface, triSurfaceHasItsTriangles)
{
    const wallSurface wall(quadCube(2));
    const triSurface surface(toTriSurface(wall));

    EXPECT_EQ(surface.size(), 2*wall.faces.size());
    EXPECT_EQ(surface.points(), wall.points);
    EXPECT_EQ(surface[1][0], wall.faces[0][0]);
    EXPECT_EQ(surface[1][1], wall.faces[0][2]);
    EXPECT_EQ(surface[1][2], wall.faces[0][3]);
}


TEST(wallSurface, polygonsAreCutAsFans)
{
    wallSurface wall;
    wall.points = pointField(5, point(Zero));
    wall.faces = faceList
    ({
        face(labelList({0, 1, 2, 3, 4})),
        face(labelList({2, 1, 0}))
    });

    labelList triangleFace;
    const faceList triangles(wallTriangles(wall, triangleFace));

    ASSERT_EQ(triangles.size(), 4);
    EXPECT_EQ(triangles[0], face(labelList({0, 1, 2})));
    EXPECT_EQ(triangles[1], face(labelList({0, 2, 3})));
    EXPECT_EQ(triangles[2], face(labelList({0, 3, 4})));
    EXPECT_EQ(triangles[3], face(labelList({2, 1, 0})));
    EXPECT_EQ(triangleFace, labelList({0, 0, 0, 1}));
}


// ************************************************************************* //
