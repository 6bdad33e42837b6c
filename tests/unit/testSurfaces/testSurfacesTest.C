/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "saddles.H"
#include "mathematicalConstants.H"

#include <gtest/gtest.h>

#include <algorithm>

using namespace Foam;
using namespace Foam::testSurfaces;
using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- In degrees
static scalar smallestAngle(const wallSurface& wall)
{
    scalar smallest = 180;

    for (const face& f : wall.faces)
    {
        forAll(f, i)
        {
            const point& p = wall.points[f[i]];
            const vector a(wall.points[f[f.fcIndex(i)]] - p);
            const vector b(wall.points[f[f.rcIndex(i)]] - p);
            smallest =
                min(smallest, Foam::acos((a & b)/mag(a)/mag(b))*180/pi);
        }
    }

    return smallest;
}

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(testSurfaces, areClosed)
{
    EXPECT_TRUE(isClosed(quadCube(3)));
    EXPECT_TRUE(isClosed(cube(3, 2)));
    EXPECT_TRUE(isClosed(quadSphere(4, 1)));
    EXPECT_TRUE(isClosed(sphere(4, 1)));
    EXPECT_TRUE(isClosed(torus(12, 8, 2, 0.5)));
    EXPECT_TRUE(isClosed(lBlock(6)));
    EXPECT_TRUE(isClosed(wedgeBlock(6, 30)));
    EXPECT_TRUE(isClosed(slitBlock(6, 0.1)));
}


TEST(testSurfaces, encloseTheirVolume)
{
    EXPECT_NEAR(testSurfaces::enclosedVolume(quadCube(3, 2)), 8, 1e-12);
    EXPECT_NEAR(testSurfaces::enclosedVolume(cube(3, 2)), 8, 1e-12);
    EXPECT_NEAR(testSurfaces::enclosedVolume(lBlock(5)), 3, 1e-12);
    EXPECT_NEAR
    (
        testSurfaces::enclosedVolume(wedgeBlock(5, 60)),
        4 - Foam::sqrt(1.0/3),
        1e-12
    );
    EXPECT_NEAR(testSurfaces::enclosedVolume(slitBlock(5, 0.1)), 3.9, 1e-12);

    // Inscribed: the error of chords is O(1/n^2)
    EXPECT_NEAR(testSurfaces::enclosedVolume(sphere(20, 1)), 4*pi/3, 0.02);
    EXPECT_NEAR
    (
        testSurfaces::enclosedVolume(torus(60, 40, 2, 0.5)), pi*pi, 0.1
    );
}


TEST(testSurfaces, haveTheirTopology)
{
    EXPECT_EQ(eulerCharacteristic(cube(3)), 2);
    EXPECT_EQ(eulerCharacteristic(sphere(3)), 2);
    EXPECT_EQ(eulerCharacteristic(lBlock(4)), 2);
    EXPECT_EQ(eulerCharacteristic(torus(12, 8, 2, 0.5)), 0);
    EXPECT_EQ
    (
        eulerCharacteristic
        (
            merge(cube(3), translated(cube(3), vector(2, 0, 0)))
        ),
        4
    );
}


TEST(testSurfaces, haveNoSlivers)
{
    EXPECT_GT(smallestAngle(sphere(8)), 30);
    EXPECT_GT(smallestAngle(lBlock(7)), 20);
    EXPECT_GT(smallestAngle(slitBlock(8, 0.125)), 20);
    EXPECT_GT(smallestAngle(wedgeBlock(8, 45)), 15);
}


TEST(testSurfaces, mergeKeepsPatches)
{
    wallSurface other(cube(1));
    other.patchNames[0] = "other";

    const wallSurface both(merge(cube(1), merge(cube(1), other)));

    EXPECT_EQ(both.patchNames, wordList({"wall", "other"}));
    EXPECT_EQ(both.patchIDs[23], 0);
    EXPECT_EQ(both.patchIDs[24], 1);
}


TEST(testSurfaces, screwsOfCubes)
{
    // Paths of three edges of a cube, each in another direction: six begin at
    // each of its corners, and each has two ends
    const List<saddle> all(screws());

    ASSERT_EQ(all.size(), 24);
    for (const saddle& s : all)
    {
        EXPECT_TRUE(isClosed(s.wall)) << s.name;
        EXPECT_NEAR(testSurfaces::enclosedVolume(s.wall), 4, 1e-14) << s.name;
        EXPECT_EQ(eulerCharacteristic(s.wall), 2) << s.name;
    }
}


TEST(testSurfaces, bladeOnAnEdge)
{
    const wallSurface wall(bladeOnEdge(0.25));

    EXPECT_TRUE(isClosed(wall));
    EXPECT_NEAR(testSurfaces::enclosedVolume(wall), 2.5, 1e-14);
    EXPECT_EQ(eulerCharacteristic(wall), 2);
}


// ************************************************************************* //
