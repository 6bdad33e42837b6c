/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "markedGrid.H"
#include "Random.H"

#include <gtest/gtest.h>

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- Boxes in a unit cube, of up to a size
static std::vector<boundBox> randomBoxes
(
    Random& random,
    const label n,
    const scalar size
)
{
    std::vector<boundBox> boxes;
    for (label i = 0; i < n; ++i)
    {
        const point low(random.sample01<vector>());
        boxes.emplace_back(low, low + size*random.sample01<vector>());
    }

    return boxes;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(markedGrid, missesNoBoxThatTouches)
{
    Random random(3);

    for (const scalar size : {0.0, 1e-3, 0.1, 2.0})
    {
        const std::vector<boundBox> boxes(randomBoxes(random, 50, size));
        const markedGrid grid(boxes);
        label nTouching = 0;

        for (const boundBox& box : randomBoxes(random, 500, 0.3))
        {
            const bool touches = std::any_of
            (
                boxes.begin(), boxes.end(),
                [&](const boundBox& other) { return other.overlaps(box); }
            );
            nTouching += touches;
            EXPECT_TRUE(!touches || grid.mayTouch(box)) << size;
        }
        for (const boundBox& box : boxes)
        {
            EXPECT_TRUE(grid.mayTouch(box));
        }

        EXPECT_GT(nTouching, 0);
    }
}


TEST(markedGrid, leavesOutMostOfTheOthers)
{
    Random random(4);
    const markedGrid grid(randomBoxes(random, 50, 0.02));
    const std::vector<boundBox> others(randomBoxes(random, 1000, 0.02));
    const label n = std::count_if
    (
        others.begin(), others.end(),
        [&](const boundBox& box) { return grid.mayTouch(box); }
    );

    EXPECT_LT(n, 100);
}


TEST(markedGrid, hasNothingWithoutBoxesAndKeepsFlatOnes)
{
    const std::vector<boundBox> none;
    EXPECT_FALSE(markedGrid(none).mayTouch(boundBox(point::zero, point::one)));

    // All in a plane
    const std::vector<boundBox> flat
    ({
        boundBox(point(0, 0, 1), point(1, 1, 1)),
        boundBox(point(5, 0, 1), point(6, 1, 1))
    });
    const markedGrid grid(flat);
    EXPECT_TRUE(grid.mayTouch(boundBox(point(1, 1, 0), point(2, 2, 1))));
    EXPECT_FALSE(grid.mayTouch(boundBox(point(1, 1, 0), point(2, 2, 0.9))));
    EXPECT_FALSE(grid.mayTouch(boundBox(point(2.5, 0, 1), point(3, 1, 1))));
}


// ************************************************************************* //
