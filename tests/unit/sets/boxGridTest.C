/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boxGrid.H"
#include "Random.H"
#include "HashSet.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A box around the origin, of a size between 1e-4 and 1
static boundBox randomBox(Random& random)
{
    const point low(2*random.sample01<vector>() - vector::one);
    const scalar size = Foam::pow(10, -4*random.sample01<scalar>());

    return boundBox(low, low + size*random.sample01<vector>());
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(boxGrid, findsTheBoxesThatTouch)
{
    Random random(5);
    std::vector<boundBox> boxes;
    boxGrid grid;
    for (label i = 0; i < 400; ++i)
    {
        boxes.push_back(randomBox(random));
        grid.insert(i, boxes[i]);
    }

    // Every third goes, and every ninth comes back elsewhere
    labelHashSet gone;
    for (label i = 0; i < 400; i += 3)
    {
        grid.erase(i, boxes[i]);
        gone.insert(i);
    }
    for (label i = 0; i < 400; i += 9)
    {
        boxes[i] = randomBox(random);
        grid.insert(i, boxes[i]);
        gone.erase(i);
    }

    label nTouching = 0;
    for (label n = 0; n < 400; ++n)
    {
        const boundBox box(n < 200 ? randomBox(random) : boxes[n]);
        labelHashSet expected;
        for (label i = 0; i < 400; ++i)
        {
            if (!gone.found(i) && boxes[i].overlaps(box))
            {
                expected.insert(i);
            }
        }

        labelHashSet found;
        grid.any(box, [&](const label i) { found.insert(i); return false; });
        EXPECT_EQ(found, expected);
        nTouching += expected.size();
    }
    EXPECT_GT(nTouching, 200);
}


TEST(boxGrid, endsWithTheFirstVisitThatIsTrue)
{
    boxGrid grid;
    const boundBox box(point::zero, point::one);
    grid.insert(1, box);
    grid.insert(2, box);
    label nVisits = 0;

    EXPECT_TRUE(grid.any(box, [&](const label) { return ++nVisits; }));
    EXPECT_EQ(nVisits, 1);
}


// ************************************************************************* //
