/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "removeSlivers.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(removeSlivers, flipsAreNotTakenBack)
{
    // Low triangles on a step between large ones
    wallSurface surface;
    surface.points = pointField
    ({
        {0, 0, 0}, {-0.1473, -0.1830, 0.0858}, {-0.6030, -0.1830, 0.4169},
        {-0.1656, -0.1710, 0.1694}, {-0.2286, -0.1219, 0.4725},
        {-0.2253, -0.1316, 0.4418}, {0.5056, 0.0529, -0.3612},
        {-2.5459, 6.6491, 2.6181}, {-1, -4, -4}
    });
    surface.faces = faceList
    ({
        face({0, 7, 2}), face({0, 2, 1}), face({0, 6, 7}), face({0, 5, 4}),
        face({0, 3, 5}), face({0, 1, 3}), face({0, 4, 6}), face({1, 2, 3}),
        face({3, 2, 5}), face({5, 2, 4}), face({2, 7, 8}), face({7, 6, 8}),
        face({6, 4, 8}), face({4, 2, 8})
    });

    EXPECT_GT(removeSlivers(0.08, surface), 0);
    EXPECT_EQ(removeSlivers(0.08, surface), 0);
}


// ************************************************************************* //
