/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnTeam.H"
#include "threadTeam.H"
#include "testLayers.H"
#include "testSurfaces.H"
#include "HashSet.H"

#include <gtest/gtest.h>

#include <atomic>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- Call work(team) for the shares of a sphere
static void onShares
(
    const label n,
    const std::function<void(const columnTeam&, const frontShare&)>& work
)
{
    const layerFront front(testSurfaces::frontOf(testSurfaces::sphere(6), 0));
    const labelList owners(ownersByRange(front.wallPoints.size(), n));

    threadTeam::run(n, [&](const threadTeam& processes)
    {
        const frontShare share
        (
            shareOf(front, owners, n, processes.rank())
        );
        work(columnTeam(share, processes), share);
    });
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(columnTeam, valuesOfOwnersGoToCopies)
{
    onShares(3, [](const columnTeam& team, const frontShare& share)
    {
        labelList values(share.columns.whole.size(), -1);
        forAll(values, c)
        {
            values[c] = share.columns.isOwn[c] ? 7*share.columns.whole[c] : -1;
        }
        team.columns.update(values);

        forAll(values, c)
        {
            EXPECT_EQ(values[c], 7*share.columns.whole[c]);
        }
    });
}


TEST(columnTeam, someValuesOfOwnersGoToCopies)
{
    onShares(3, [](const columnTeam& team, const frontShare& share)
    {
        Map<scalar> values;
        forAll(share.columns.whole, c)
        {
            if (share.columns.isOwn[c] && share.columns.whole[c] % 2)
            {
                values.insert(c, share.columns.whole[c]);
            }
        }
        const Map<scalar> ofCopies(team.columns.ofOwners(values));

        forAll(share.columns.whole, c)
        {
            const bool has =
                !share.columns.isOwn[c] && share.columns.whole[c] % 2;
            EXPECT_EQ(ofCopies.found(c), has);
            EXPECT_EQ(ofCopies.lookup(c, 0), has ? share.columns.whole[c] : 0);
        }
    });
}


TEST(columnTeam, setsAreUnited)
{
    onShares(4, [](const columnTeam& team, const frontShare& share)
    {
        // Only processes that do not own them have columns in their sets
        boolList set(share.columns.whole.size());
        forAll(set, c)
        {
            set[c] = !share.columns.isOwn[c] && share.columns.whole[c] % 3 == 0;
        }
        team.columns.unite(set);

        labelHashSet sent;
        for (const labelList& toOther : share.columns.sent)
        {
            sent.insert(toOther);
        }
        forAll(set, c)
        {
            const bool isShared = !share.columns.isOwn[c] || sent.found(c);
            EXPECT_EQ(set[c], isShared && share.columns.whole[c] % 3 == 0);
        }
    });
}


TEST(columnTeam, sumsAndQuestionsAreForAll)
{
    onShares(3, [](const columnTeam& team, const frontShare&)
    {
        EXPECT_EQ(team.sum(team.rank() + 1), 6);
        EXPECT_TRUE(team.any(team.rank() == 1));
        EXPECT_FALSE(team.any(false));
        EXPECT_EQ(team.gather(labelList(2, team.rank())),
            labelList({0, 0, 1, 1, 2, 2}));
    });
}


TEST(columnTeam, aFailureEndsAllWithOneReason)
{
    for (const bool inQuestion : {false, true})
    {
        std::atomic<label> nEnded(0);

        threadTeam::run(4, [&](const threadTeam& team)
        {
            std::string reason;

            try
            {
                if (team.rank() > 1)
                {
                    throw std::runtime_error("of " + name(team.rank()));
                }
                if (inQuestion)
                {
                    team.any(true);
                }
                else
                {
                    team.gather(labelList(3, team.rank()));
                }
            }
            catch (const teamError& e)
            {
                reason = e.what();
            }
            catch (const std::runtime_error& e)
            {
                reason = team.fail(e.what());
            }

            nEnded += reason == "of 2";
        });
        EXPECT_EQ(nEnded, 4);
    }
}


// ************************************************************************* //
