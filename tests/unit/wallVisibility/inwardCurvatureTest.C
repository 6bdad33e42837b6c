/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pointKind.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static scalarField curvatureOf(const wallSurface& wall)
{
    const wallAddressing addressing(makeWallAddressing(wall));
    const wallVisibility visibility(makeWallVisibility(wall, addressing));

    return inwardCurvature
    (
        wall, addressing, visibility,
        kindsOfPoints(wall, addressing, visibility)
    );
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(inwardCurvature, isOneOverTheRadiusInsideASphere)
{
    wallSurface cavity(testSurfaces::sphere(40));
    for (face& f : cavity.faces)
    {
        f.flip();
    }

    // Where triangles change their size smooth normals lag behind
    scalarField sorted(curvatureOf(cavity));
    sort(sorted);
    EXPECT_NEAR(sorted[sorted.size()/2], 1, 0.1);
    EXPECT_GT(sorted.first(), 0.3);
    EXPECT_LT(sorted.last(), 2);
}


TEST(inwardCurvature, isNoneOnAConvexBody)
{
    EXPECT_EQ(max(curvatureOf(testSurfaces::sphere(8))), 0);
    EXPECT_EQ(max(curvatureOf(testSurfaces::cube(6))), 0);
}


// ************************************************************************* //
