/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readWallSurface.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(orientWallSurface, outwardNormalsStayForFluidOutside)
{
    wallSurface wall(sphere(4));

    EXPECT_EQ(orientWallSurface(wall, true), 0);
    EXPECT_EQ(wall.faces, sphere(4).faces);
}


TEST(orientWallSurface, inwardNormalsAreTurnedForFluidOutside)
{
    wallSurface wall(reversed(lBlock(4)));

    EXPECT_EQ(orientWallSurface(wall, true), wall.faces.size());
    EXPECT_NEAR(testSurfaces::enclosedVolume(wall), 3, 1e-12);
}


TEST(orientWallSurface, normalsPointIntoTheFluidInside)
{
    wallSurface wall(quadSphere(4));

    EXPECT_EQ(orientWallSurface(wall, false), wall.faces.size());
    EXPECT_LT(testSurfaces::enclosedVolume(wall), 0);
    EXPECT_EQ(orientWallSurface(wall, false), 0);
}


TEST(orientWallSurface, placeFarFromTheOriginDoesNotMatter)
{
    wallSurface wall(translated(sphere(6, 0.01), vector(1000, 1000, 1000)));

    EXPECT_EQ(orientWallSurface(wall, true), 0);
}


TEST(orientWallSurface, componentInsideOutIsTurned)
{
    const wallSurface one(cube(2));
    wallSurface wall(merge(one, translated(reversed(one), vector(3, 0, 0))));

    EXPECT_EQ(orientWallSurface(wall, true), one.faces.size());
    EXPECT_NEAR(testSurfaces::enclosedVolume(wall), 2, 1e-12);
}


TEST(orientWallSurface, cavityIsTurnedAgainstItsShell)
{
    const wallSurface cavity(sphere(4, 0.5));
    const wallSurface island(quadCube(2, 0.1));
    wallSurface wall(merge(sphere(6), merge(cavity, island)));

    EXPECT_EQ(orientWallSurface(wall, true), cavity.faces.size());
    EXPECT_NEAR
    (
        testSurfaces::enclosedVolume(wall),
        testSurfaces::enclosedVolume(sphere(6))
      - testSurfaces::enclosedVolume(cavity) + 1e-3,
        1e-12
    );
}


TEST(orientWallSurface, surfaceWithDefectsStays)
{
    wallSurface open(reversed(cube(2)));
    open.faces.setSize(open.faces.size() - 1);
    EXPECT_EQ(orientWallSurface(open, true), 0);

    wallSurface flipped(cube(2));
    flipped.faces[0].flip();
    EXPECT_EQ(orientWallSurface(flipped, false), 0);

    wallSurface none;
    EXPECT_EQ(orientWallSurface(none, true), 0);
}


// ************************************************************************* //
