/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "hexOctree.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

namespace
{

//- Two cubes along x, the first one in eight
hexOctree twoCubes()
{
    const boundBox box(point::zero, point(2, 1, 1));
    const auto divided = [](const boundBox& b, bool&)
    {
        return b.max().x() < 1.5 && b.span().x() > 0.75
          ? hexOctree::parts::eight : hexOctree::parts::none;
    };

    return hexOctree(box, labelVector(2, 1, 1), divided, 100);
}

} // End anonymous namespace


TEST(hexPoints, leavesShareTheirCorners)
{
    const hexOctree tree(twoCubes());
    hexPoints points(tree);

    // 27 of the parts, and four of the whole cube
    EXPECT_EQ(points.release().size(), 31);
}


TEST(hexPoints, sideOfALargeLeafHasTheCornersOfSmallOnes)
{
    const hexOctree tree(twoCubes());
    hexPoints points(tree);
    const label large = tree.find(labelVector(1, 0, 0), 0);
    const face beside(points.sideOf(large, 0));
    const face far(points.sideOf(large, 1));
    const pointField x(points.release());

    EXPECT_EQ(beside.size(), 8);
    EXPECT_EQ(far.size(), 4);

    // Seen from outside
    EXPECT_EQ(beside.areaNormal(x), vector(-1, 0, 0));
    EXPECT_EQ(far.areaNormal(x), vector(1, 0, 0));
}


// ************************************************************************* //
