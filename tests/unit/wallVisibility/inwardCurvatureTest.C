/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "inwardCurvature.H"
#include "testSurfaces.H"
#include "wallContext.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

using namespace Foam;

TEST(inwardCurvature, isOneOverTheRadiusInsideASphere)
{
    wallSurface cavity(testSurfaces::sphere(40));
    for (face& f : cavity.faces)
    {
        f.flip();
    }
    const wallContext context(cavity);

    // Where triangles change their size smooth normals lag behind
    scalarField sorted(context.curvature);
    sort(sorted);
    EXPECT_NEAR(sorted[sorted.size()/2], 1, 0.1);
    EXPECT_GT(sorted.first(), 0.3);
    EXPECT_LT(sorted.last(), 2);
}


TEST(inwardCurvature, isNoneOnAConvexBody)
{
    EXPECT_EQ(max(wallContext(testSurfaces::sphere(8)).curvature), 0);
    EXPECT_EQ(max(wallContext(testSurfaces::cube(6)).curvature), 0);
}


// ************************************************************************* //
