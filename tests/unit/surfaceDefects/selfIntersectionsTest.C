/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "brokenSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

typedef wallDefect::kind kind;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(selfIntersections, overlappingBodiesIntersect)
{
    const wallSurface wall
    (
        merge(cube(1), translated(cube(1), vector(0.5, 0.6, 0.7)))
    );
    const wallDefect defect(defectOf(wall, kind::selfIntersection));

    EXPECT_GT(defect.count, 0);
    EXPECT_EQ(findWallDefects(wall).size(), 1);
}


TEST(selfIntersections, touchingBodiesIntersect)
{
    // Face on face, point on point
    for (const vector& by : {vector(1, 0, 0), vector(1, 1, 1)})
    {
        const wallSurface wall(merge(cube(1), translated(cube(1), by)));
        EXPECT_GT(defectOf(wall, kind::selfIntersection).count, 0);
    }
}


TEST(selfIntersections, coincidentBodiesIntersect)
{
    const wallSurface wall(merge(sphere(3), sphere(3)));

    EXPECT_GE
    (
        defectOf(wall, kind::selfIntersection).count,
        wall.faces.size()/2
    );
}


TEST(selfIntersections, nearestBodiesDoNotIntersect)
{
    // One unit in the last place apart
    const scalar apart = 1 + 2.3e-16;

    EXPECT_TRUE
    (
        isValid(merge(cube(2), translated(cube(2), vector(apart, 0, 0))))
    );
}


TEST(selfIntersections, foldedNeighboursIntersect)
{
    EXPECT_EQ(defectOf(hinge(0.4, 0.5, 0), kind::selfIntersection).count, 1);
    EXPECT_EQ(defectOf(hinge(0.5, 1e-9, 0), kind::selfIntersection).count, 1);

    EXPECT_EQ(defectOf(hinge(0.4, -0.5, 0), kind::selfIntersection).count, 0);
    EXPECT_EQ
    (
        defectOf(hinge(0.4, 0.5, 1e-12), kind::selfIntersection).count,
        0
    );
}


TEST(selfIntersections, facesThatCutBeyondACommonPointIntersect)
{
    wallSurface wall(hinge(0.5, -1, 0));
    wall.points.append(point(0.5, 0.2, -1));
    wall.points.append(point(0.5, 0.2, 1));
    wall.faces = faceList({triangleOf(0, 1, 2), triangleOf(0, 4, 5)});

    EXPECT_EQ(defectOf(wall, kind::selfIntersection).count, 1);

    // The same on the other side of the common point
    wall.points[4].x() = wall.points[5].x() = -0.5;
    EXPECT_EQ(defectOf(wall, kind::selfIntersection).count, 0);
}


TEST(selfIntersections, polygonFoldedOntoItselfIntersects)
{
    wallSurface wall;
    wall.points = pointField
    ({
        point(0, 0, 0), point(2, -1, 0), point(2, 1, 0), point(-0.5, 0.5, 0)
    });
    wall.faces = faceList(1, face(labelList({0, 1, 2, 3})));
    wall.patchIDs = labelList(1, Zero);
    EXPECT_EQ(defectOf(wall, kind::selfIntersection).count, 0);

    // Re-entrant, so that the fan from the first point folds
    wall.points[3] = point(1.9, 0, 0);
    EXPECT_EQ(defectOf(wall, kind::selfIntersection).count, 1);
}


TEST(selfIntersections, pairOfWarpedQuadsCountsOnce)
{
    const wallSurface wall
    (
        merge(quadCube(1), translated(quadCube(1), vector(0.5, 0.6, 0.7)))
    );
    const label nPairs = defectOf(wall, kind::selfIntersection).count;

    // Three sides of one cube each meet two or three of the other
    EXPECT_EQ(nPairs, 6);
}


// ************************************************************************* //
