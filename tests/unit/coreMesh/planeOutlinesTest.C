/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planeOutlines.H"
#include "face.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(planeOutlines, bordersAreBesideFacesThatStay)
{
    // A row of three squares in a plane: gone, gone, staying; below the first
    // one a wall
    planeOutlines outlines(2);
    outlines.addGone(0, face({0, 1, 5, 4}));
    outlines.addGone(0, face({1, 2, 6, 5}));
    outlines.addStaying(face({2, 3, 7, 6}));
    outlines.addWall(face({1, 0, 8, 9}));

    List<edgeList> borders, limits;
    outlines.set(borders, limits);

    ASSERT_EQ(borders.size(), 2);
    EXPECT_FALSE(outlines.isEmpty(0));
    EXPECT_TRUE(outlines.isEmpty(1));
    EXPECT_TRUE(borders[1].empty() && limits[1].empty());

    // All of six edges but the border and the one of the wall
    ASSERT_EQ(borders[0].size(), 1);
    EXPECT_TRUE(borders[0][0] == edge(2, 6));
    EXPECT_EQ(limits[0].size(), 4);
    EXPECT_FALSE(limits[0].found(edge(0, 1)));
}


// ************************************************************************* //
