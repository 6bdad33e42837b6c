/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "disjointSets.H"
#include "labelPair.H"
#include "Random.H"

#include <gtest/gtest.h>

#include <numeric>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(disjointSets, beginAsSingleMembers)
{
    disjointSets sets(5);

    for (label i = 0; i < 5; ++i)
    {
        EXPECT_EQ(sets.find(i), i);
    }
}


TEST(disjointSets, stepsAroundACircleMakeResidueClasses)
{
    // Steps of s around a circle of n visit the multiples of gcd(n, s)
    const label n = 60;

    for (const label step : {1, 18, 25, 30, 59})
    {
        disjointSets sets(n);

        for (label i = n - 1; i >= 0; --i)
        {
            sets.join(i, (i + step) % n);
        }

        for (label i = 0; i < n; ++i)
        {
            EXPECT_EQ(sets.find(i), i % std::gcd(n, step));
        }
    }
}


TEST(disjointSets, orderOfJoinsDoesNotMatter)
{
    Random random(3);
    const label n = 200;
    disjointSets forward(n), backward(n);
    List<labelPair> pairs(120);

    for (labelPair& pair : pairs)
    {
        pair.first() = random.position<label>(0, n - 1);
        pair.second() = random.position<label>(0, n - 1);
        forward.join(pair.first(), pair.second());
    }
    forAllReverse(pairs, i)
    {
        backward.join(pairs[i].second(), pairs[i].first());
    }

    for (label i = 0; i < n; ++i)
    {
        EXPECT_EQ(forward.find(i), backward.find(i));
        EXPECT_LE(forward.find(i), i);
    }
}


// ************************************************************************* //
