/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallChanges.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- A flat quadrilateral whose third point is where it is told
static wallSurface quadWith(const point& third)
{
    wallSurface wall;
    wall.points = pointField({Zero, point(2, 0, 0), third, point(0, 2, 0)});
    wall.faces = faceList({face({0, 1, 2, 3})});
    wall.patchIDs = labelList({1});
    wall.patchNames = wordList({"a", "b"});

    return wall;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(cutReflexFaces, convexQuadrilateralStays)
{
    wallSurface wall(quadWith(point(1.5, 1.5, 0)));

    EXPECT_EQ(cutReflexFaces(wall), 0);
    EXPECT_EQ(wall.faces.size(), 1);
}


TEST(cutReflexFaces, reflexOneIsCutThroughItsReflexCorner)
{
    wallSurface wall(quadWith(point(0.5, 0.5, 0)));
    const vector area(wall.faces[0].areaNormal(wall.points));

    EXPECT_EQ(cutReflexFaces(wall), 1);
    ASSERT_EQ(wall.faces.size(), 2);
    EXPECT_EQ(wall.patchIDs, labelList({1, 1}));

    vector sum(Zero);
    for (const face& f : wall.faces)
    {
        EXPECT_TRUE(f.found(2));
        EXPECT_GT(f.areaNormal(wall.points) & area, 0);
        sum += f.areaNormal(wall.points);
    }
    EXPECT_NEAR(mag(sum - area), 0, 1e-15);
}


TEST(cutReflexFaces, straightCornerIsCut)
{
    wallSurface wall(quadWith(point(1, 1, 0)));

    EXPECT_EQ(cutReflexFaces(wall), 1);
    for (const face& f : wall.faces)
    {
        EXPECT_NEAR(f.mag(wall.points), 1, 1e-15);
    }
}


TEST(cutReflexFaces, warpedQuadrilateralStaysUntilItIsFolded)
{
    wallSurface warped(quadWith(point(2, 2, 1)));
    EXPECT_EQ(cutReflexFaces(warped), 0);

    wallSurface folded(quadWith(point(0.5, 0.5, 2)));
    EXPECT_EQ(cutReflexFaces(folded), 1);
    EXPECT_EQ(folded.faces.size(), 2);
}


//- A warped quadrilateral, and a triangle above it, whose tip is at a height.
//  The diagonal that the wall does not have is 0.5 above the one that it has.
static wallSurface warpedBelowTriangle(const scalar height)
{
    wallSurface wall;
    wall.points = pointField
    ({
        Zero, point(1, 0, 0.5), point(1, 1, 0), point(0, 1, 0.5),
        point(0.5, 0.5, height), point(0.6, 0.5, 2), point(0.5, 0.5, 2)
    });
    wall.faces = faceList({face({0, 1, 2, 3}), face({4, 5, 6})});
    wall.patchIDs = labelList({1, 0});
    wall.patchNames = wordList({"a", "b"});

    return wall;
}


TEST(cutCrowdedFaces, facesBetweenBothDiagonalsCutAsTheWallIs)
{
    wallSurface wall(warpedBelowTriangle(0.25));

    EXPECT_EQ(cutCrowdedFaces(wall), 1);
    ASSERT_EQ(wall.faces.size(), 3);
    EXPECT_EQ(wall.faces[1], face({0, 1, 2}));
    EXPECT_EQ(wall.faces[2], face({0, 2, 3}));
    EXPECT_EQ(wall.patchIDs, labelList({0, 1, 1}));
}


TEST(cutCrowdedFaces, facesBeyondBothDiagonalsCutNothing)
{
    wallSurface wall(warpedBelowTriangle(0.6));

    EXPECT_EQ(cutCrowdedFaces(wall), 0);
    EXPECT_EQ(wall.faces.size(), 2);
}

// ************************************************************************* //
