/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "testSurfaces.H"
#include "mathematicalConstants.H"
#include "labelPair.H"

#include <gtest/gtest.h>

#include <algorithm>

using namespace Foam;
using namespace Foam::testSurfaces;
using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Every side of a face is met once in the other direction, by another face
static bool isClosed(const wallSurface& wall)
{
    DynamicList<labelPair> forward, backward;

    for (const face& f : wall.faces)
    {
        forAll(f, i)
        {
            forward.append(labelPair(f[i], f[f.fcIndex(i)]));
            backward.append(labelPair(f[f.fcIndex(i)], f[i]));
        }
    }

    std::sort(forward.begin(), forward.end());
    std::sort(backward.begin(), backward.end());

    return
        forward == backward
     && std::adjacent_find(forward.begin(), forward.end()) == forward.end();
}


//- Euler characteristic
static label euler(const wallSurface& wall)
{
    label nSides = 0;

    for (const face& f : wall.faces)
    {
        nSides += f.size();
    }

    return wall.points.size() - nSides/2 + wall.faces.size();
}


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
    EXPECT_NEAR(enclosedVolume(quadCube(3, 2)), 8, 1e-12);
    EXPECT_NEAR(enclosedVolume(cube(3, 2)), 8, 1e-12);
    EXPECT_NEAR(enclosedVolume(lBlock(5)), 3, 1e-12);
    EXPECT_NEAR
    (
        enclosedVolume(wedgeBlock(5, 60)),
        4 - Foam::sqrt(1.0/3),
        1e-12
    );
    EXPECT_NEAR(enclosedVolume(slitBlock(5, 0.1)), 3.9, 1e-12);

    // Inscribed: the error of chords is O(1/n^2)
    EXPECT_NEAR(enclosedVolume(sphere(20, 1)), 4*pi/3, 0.02);
    EXPECT_NEAR(enclosedVolume(torus(60, 40, 2, 0.5)), pi*pi, 0.1);
}


TEST(testSurfaces, haveTheirTopology)
{
    EXPECT_EQ(euler(cube(3)), 2);
    EXPECT_EQ(euler(sphere(3)), 2);
    EXPECT_EQ(euler(lBlock(4)), 2);
    EXPECT_EQ(euler(torus(12, 8, 2, 0.5)), 0);
    EXPECT_EQ(euler(merge(cube(3), translated(cube(3), vector(2, 0, 0)))), 4);
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


// ************************************************************************* //
