/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "reachGrid.H"
#include "Random.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static scalar distanceOf(const boundBox& a, const boundBox& b)
{
    scalar sum = 0;
    for (direction d = 0; d < 3; ++d)
    {
        const scalar above = a.min()[d] - b.max()[d];
        const scalar below = b.min()[d] - a.max()[d];
        sum += sqr(max(max(above, below), scalar(0)));
    }

    return ::sqrt(sum);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(reachGrid, isWithinOneCellOfTheDistance)
{
    Random random(5);

    for (const scalar size : {0.0, 0.02, 0.3})
    {
        const scalar distance = 0.1;
        std::vector<boundBox> boxes;
        for (label i = 0; i < 20; ++i)
        {
            const point low(random.sample01<vector>());
            boxes.emplace_back(low, low + size*random.sample01<vector>());
        }
        const reachGrid grid(boxes, distance);
        label nFar = 0;

        for (label i = 0; i < 2000; ++i)
        {
            const point low(1.4*random.sample01<vector>() - 0.2*vector::one);
            const boundBox box(low, low + 0.02*random.sample01<vector>());
            scalar nearest = GREAT;
            for (const boundBox& other : boxes)
            {
                nearest = min(nearest, distanceOf(box, other));
            }

            // Two cells of an eighth of the distance, along their diagonals
            if (nearest <= distance)
            {
                EXPECT_TRUE(grid.mayReach(box));
            }
            else if (nearest > distance*(1 + 0.25*::sqrt(3.0)))
            {
                EXPECT_FALSE(grid.mayReach(box));
                ++nFar;
            }
        }
        EXPECT_GT(nFar, 50);
    }
}


TEST(reachGrid, reachesNothingWithoutBoxes)
{
    EXPECT_FALSE
    (
        reachGrid({}, 1).mayReach(boundBox(point::zero, point::one))
    );
}

// ************************************************************************* //
