/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismLayerMesh.H"
#include "testLayers.H"
#include "testStages.H"
#include "testSurfaces.H"
#include "threadTeam.H"
#include "wallPointsError.H"

#include <gtest/gtest.h>

#include <atomic>

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

using namespace Foam;

TEST(failuresInTeam, aStageThatThrowsEndsAllProcesses)
{
    const wallSurface wall(testSurfaces::lBlock(4));
    prismLayerControls controls;
    controls.layers = testSurfaces::layersOf(4, 0.1);
    const label n = 3;

    for
    (
        const word& stage
      : wordList
        ({
            "wallVisibility", "layerSpacing", "layerFront", "wallClearance",
            "offsetEnvelope", "layerColumns", "prismLayers", "prismQuality"
        })
    )
    {
        // The master alone makes what is before shares, and the only field
        const wordHashSet ofMaster
        ({
            "wallVisibility", "layerSpacing", "layerFront", "offsetEnvelope"
        });
        const label nThrow = ofMaster.found(stage) ? 1 : n;

        for (label rank = 0; rank < nThrow; ++rank)
        {
            std::atomic<label> nEnded(0);

            threadTeam::run(n, [&](const threadTeam& team)
            {
                const auto begin = [&](const word& begun)
                {
                    if (begun == stage && team.rank() == rank)
                    {
                        throw std::runtime_error("in " + stage);
                    }
                };
                const stageObserver observer{begin, [](const string&) {}};

                try
                {
                    team.guard([&]()
                    {
                        return makePrismLayerMesh
                        (
                            wall, controls, localHeights(), observer, false,
                            team
                        );
                    });
                }
                catch (const std::runtime_error& e)
                {
                    nEnded += std::string(e.what()) == "in " + stage;
                }
            });
            EXPECT_EQ(nEnded, n) << stage << " on process " << rank;
        }
    }
}


//- The places of the points are known on the master
TEST(failuresInTeam, pointsWithoutLayersEndAllProcesses)
{
    // The fluid is in no more than rounding between two of the faces
    const vectorField directions
    ({
        {1, 0, 0}, {1e-12, 1, 1}, {0, 1, -2}, {-1e-12, 1, 1}, {-1, 0, 0},
        {0, -1, 0}
    });
    const wallSurface wall(testSurfaces::fan(directions));
    prismLayerControls controls;
    controls.layers = testSurfaces::layersOf(4, 0.1);
    const label n = 3;
    std::atomic<label> nPlaces(0), nEnded(0);

    threadTeam::run(n, [&](const threadTeam& team)
    {
        const stageObserver observer{[](const word&) {}, [](const string&) {}};

        try
        {
            team.guard([&]()
            {
                return makePrismLayerMesh
                (
                    wall, controls, localHeights(), observer, false, team
                );
            });
        }
        catch (const wallPointsError&)
        {
            ++nPlaces;
        }
        catch (const teamError&)
        {
            ++nEnded;
        }
    });
    EXPECT_EQ(nPlaces, 1);
    EXPECT_EQ(nEnded, n - 1);
}


// ************************************************************************* //
