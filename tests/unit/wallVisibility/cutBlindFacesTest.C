/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallVisibility.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static labelList emptyCones(const wallSurface& wall)
{
    return makeWallVisibility(wall, makeWallAddressing(wall)).emptyCones();
}


//- A hexahedron of which point 0 is pulled out of the planes of its faces
static wallSurface warpedBlock()
{
    wallSurface block;
    block.points = pointField
    ({
        point(0.726, 0.1388, 0.8899),
        point(0, 0.02873, 0.9228), point(0.4901, 0.02873, 1.337),
        point(0.4901, 0.1145, 0.9228), point(0, 0.02873, 1.337),
        point(0, 0.1145, 0.9228), point(0.4901, 0.1145, 1.337),
        point(0, 0.1145, 1.337)
    });
    block.faces = faceList
    ({
        face({1, 4, 2, 0}), face({1, 0, 3, 5}), face({0, 2, 6, 3}),
        face({1, 5, 7, 4}), face({2, 4, 7, 6}), face({3, 6, 7, 5})
    });
    block.patchIDs = labelList(6, label(0));
    block.patchNames = wordList({"wall"});

    return block;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(cutBlindFaces, planeFacesStay)
{
    wallSurface wall(testSurfaces::quadCube(3));
    EXPECT_EQ(cutBlindFaces(wall), 0);
    EXPECT_EQ(wall.faces, testSurfaces::quadCube(3).faces);
}


TEST(cutBlindFaces, cornersOfWarpedFacesGetDirections)
{
    wallSurface wall(warpedBlock());
    ASSERT_EQ(emptyCones(wall), labelList(1, label(0)));

    // Those at the corner; the triangles follow the others
    EXPECT_EQ(cutBlindFaces(wall), 3);
    EXPECT_EQ(wall.faces.size(), 9);
    EXPECT_EQ(wall.faces[0], warpedBlock().faces[3]);
    EXPECT_TRUE(emptyCones(wall).empty());
    EXPECT_EQ(cutBlindFaces(wall), 0);
}


// ************************************************************************* //
