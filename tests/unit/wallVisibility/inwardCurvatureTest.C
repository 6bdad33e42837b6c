/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pointKind.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static scalarField curvatureOf
(
    const wallSurface& wall,
    const scalar thickness = 0
)
{
    const wallAddressing addressing(makeWallAddressing(wall));
    const wallVisibility visibility(makeWallVisibility(wall, addressing));

    return inwardCurvature
    (
        wall, addressing, visibility,
        kindsOfPoints(wall, addressing, visibility),
        scalarField(wall.points.size(), thickness)
    );
}


//- The largest curvature in a cube of n^3 whose floor and ceiling have folds
//  along y, a quarter of the side apart
static scalar curvatureInFoldedCavity(const label n, const scalar thickness)
{
    wallSurface cavity(testSurfaces::reversed(testSurfaces::cube(n)));
    for (point& p : cavity.points)
    {
        p.z() += 0.2*mag(std::remainder(p.x(), 0.5));
    }

    return max(curvatureOf(cavity, thickness));
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


TEST(inwardCurvature, ofFoldsIsTheSameWithFinerTriangles)
{
    const scalar thickness = 0.4;
    const scalar coarse = curvatureInFoldedCavity(24, thickness);
    EXPECT_GT(coarse, 0.5);
    EXPECT_NEAR(curvatureInFoldedCavity(64, thickness), coarse, 0.1*coarse);
    EXPECT_GT(curvatureInFoldedCavity(64, 0), 2*coarse);
}


TEST(inwardCurvature, isNoneOnAConvexBody)
{
    EXPECT_EQ(max(curvatureOf(testSurfaces::sphere(8))), 0);
    EXPECT_EQ(max(curvatureOf(testSurfaces::cube(6))), 0);
}


// ************************************************************************* //
