/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "openSurfaces.H"
#include "stitchSurface.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(soundSurface, closedSurfaceIsSoundAndOpenOneIsNot)
{
    EXPECT_TRUE(isSoundUpTo({}, 1e-9, cube(2)));
    EXPECT_FALSE(isSoundUpTo({}, 1e-9, halfCube(2)));
}


TEST(soundSurface, borderMustBeOnThePlanes)
{
    EXPECT_TRUE(isSoundUpTo(halfPlanes(), 1e-9, halfCube(2)));
    EXPECT_FALSE(isSoundUpTo(halfPlanes(), 1e-9, quarterCube(2)));
}


TEST(soundSurface, nothingMayBeBeyondAPlane)
{
    const wallSurface whole(translated(cube(2), vector(0, 0, -0.5)));
    const sidePatch plane(halfPlanes()[0]);

    EXPECT_TRUE(isBeyond(plane, 0.1, whole));
    EXPECT_FALSE(isBeyond(plane, 0.6, whole));
    EXPECT_FALSE(isSoundUpTo(halfPlanes(), 0.1, whole));
}


// ************************************************************************* //
