/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "commonWall.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(commonWall, cornersOfOneCellOnBothSidesAreAPolygon)
{
    // Corners 1, 3, 7 are around a point; one side has 7 apart
    commonPolygons polygons(3);
    polygons.join(1, 3, 1);
    polygons.join(3, 7, 1);
    polygons.join(3, 1, 1);
    polygons.divide();

    EXPECT_EQ(polygons.polygon(3), 1);
    EXPECT_EQ(polygons.polygon(1), 1);
    EXPECT_EQ(polygons.polygon(7), 7);
    EXPECT_EQ(commonPolygons::triangle(7), 2);
}


TEST(commonWall, withoutAMeshBehindOneSideDecides)
{
    commonPolygons polygons(2);
    polygons.join(0, 4, 2);
    polygons.divide();

    EXPECT_EQ(polygons.polygon(4), 0);
}


TEST(commonWall, wholeTrianglesStayWhole)
{
    commonPolygons polygons(2);
    EXPECT_TRUE(polygons.keep(1));
    EXPECT_FALSE(polygons.keep(1));
    polygons.join(0, 1, 2);
    polygons.clear();
    polygons.divide();

    EXPECT_TRUE(polygons.isWhole(1));
    EXPECT_EQ(polygons.polygon(1), 1);
}


TEST(commonWall, cornersHaveTheOrderOfTheirLabels)
{
    commonTriangles wall;
    wall.faces = labelList({4, 5});
    wall.points = labelList({30, 10, 20});
    const face f({2, 0, 1});

    EXPECT_EQ(wall.corner(1, f, 0), 3*5 + 1);
    EXPECT_EQ(wall.corner(1, f, 1), 3*5 + 2);
    EXPECT_EQ(wall.corner(1, f, 2), 3*5);
    EXPECT_TRUE(wall.edgeBetween(0, 2) == edge(20, 30));
}


// ************************************************************************* //
