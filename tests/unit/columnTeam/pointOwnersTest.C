/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "frontShare.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- By process, the numbers of all and of hard points
static List<std::pair<label, label>> numbers
(
    const pointOwners& owners,
    const boolList& isHard,
    const label n
)
{
    List<std::pair<label, label>> result(n, std::pair<label, label>(0, 0));
    forAll(isHard, p)
    {
        ++result[owners(p)].first;
        result[owners(p)].second += isHard[p];
    }

    return result;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(pointOwners, areThoseOfTheList)
{
    const labelList list({2, 2, 0, 0, 0, 1, 2, 1});
    const pointOwners owners(list);

    forAll(list, p)
    {
        EXPECT_EQ(owners(p), list[p]);
    }
    EXPECT_EQ(owners.starts(), labelList({0, 2, 5, 6, 7}));
}


TEST(pointOwners, evenPointsAreInOneRangeEach)
{
    for (const label n : {1, 2, 3, 8})
    {
        const pointOwners owners
        (
            balancedOwners(boolList(1000, false), n)
        );
        EXPECT_EQ(owners.processes(), identity(n));
    }
}


TEST(pointOwners, hardPointsAreDividedAsAllAre)
{
    // All hard points are in the last third, or at both ends
    boolList atEnd(3000, false), atEnds(3000, false);
    for (label p = 2000; p < 3000; ++p)
    {
        atEnd[p] = p % 5 == 0;
        atEnds[(p + 600) % 3000] = p % 5 == 0;
    }

    for (const boolList& isHard : {atEnd, atEnds})
    {
        for (const label n : {2, 3, 4, 7})
        {
            const pointOwners owners(balancedOwners(isHard, n));
            for (const auto& ofProcess : numbers(owners, isHard, n))
            {
                EXPECT_NEAR(ofProcess.first, 3000.0/n, 2);
                EXPECT_NEAR(ofProcess.second, 200.0/n, 0.1*200/n + 1);
            }
        }
    }
}


TEST(pointOwners, moreProcessesThanPoints)
{
    for (const label nPoints : {1, 3, 7})
    {
        const pointOwners owners(balancedOwners(boolList(nPoints, true), 8));
        EXPECT_EQ(owners(0), 0);
        for (label p = 0; p < nPoints; ++p)
        {
            EXPECT_LT(owners(p), 8);
        }
    }
}


// ************************************************************************* //
