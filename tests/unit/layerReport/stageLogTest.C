/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "OStringStream.H"
#include "stageLog.H"

#include <algorithm>
#include <chrono>
#include <gtest/gtest.h>
#include <regex>
#include <thread>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The log of a stage that works for some seconds, and tells how far it is
static std::string logOf(const double seconds, const double interval)
{
    OStringStream os;
    {
        stageLog log(os, interval);
        log.begin("columns");

        const auto start = std::chrono::steady_clock::now();
        const std::chrono::duration<double> length(seconds);
        do
        {
            tellProgress("bending columns", 12, 100);
        }
        while (std::chrono::steady_clock::now() - start < length);

        log.end("100 columns\nretreated 3 times");
    }
    tellProgress("nobody hears this");

    return os.str();
}


static const std::string end
(
    "columns +100 columns  [0-9.e-]+ s\n    retreated 3 times\n"
);

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(stageLog, aShortStageIsOneLine)
{
    const std::string log(logOf(0, 1000));

    EXPECT_TRUE(std::regex_match(log, std::regex(end))) << log;
}


TEST(stageLog, aLongStageSaysHowFarItIs)
{
    const std::string log(logOf(0.5, 0.1));
    const std::string line("    bending columns 12 of 100, [0-9]+ s\n");

    // Its line is begun, left for the lines of progress, and begun again
    EXPECT_TRUE
    (
        std::regex_match(log, std::regex("columns +\n(" + line + ")+" + end))
    ) << log;
}


TEST(stageLog, aStageThatTellsNothingSaysThatItGoesOn)
{
    OStringStream os;
    stageLog log(os, 0.1);
    log.begin("columns");
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    log.end("100 columns\nretreated 3 times");

    EXPECT_TRUE
    (
        std::regex_match
        (
            os.str(), std::regex("columns +\n(    [0-9]+ s\n)+" + end)
        )
    ) << os.str();
}


TEST(stageLog, endsStagesWhileAnotherThreadTells)
{
    OStringStream os;
    stageLog log(os, 1e-5);
    for (label n = 0; n < 20000; ++n)
    {
        log.begin("columns");
        tellBound("smoothing", 5);
        log.end("quiet");
    }

    EXPECT_EQ(log.costs().size(), 20000);
}


TEST(stageLog, saysWhichLoopsEndedAtTheirBounds)
{
    OStringStream os;
    stageLog log(os);
    log.begin("columns");

    label n = 0;
    repeatUntilStable("smoothing", 5, [&]() { return ++n < 5; });
    EXPECT_EQ(n, 5);
    log.end("quiet");
    EXPECT_EQ(os.str().find("bound"), std::string::npos) << os.str();

    log.begin("columns");
    repeatUntilStable("smoothing", 4, [&]() { return ++n < 50; });
    EXPECT_EQ(n, 9);
    repeatUntilStable("smoothing", 4, [&]() { return ++n < 50; });
    repeatUntilStable("flipping", 7, [&]() { return true; });
    log.end("restless");
    EXPECT_NE
    (
        os.str().find
        (
            " s\n    loop 'flipping' ended at its bound of 7;"
            " loop 'smoothing' ended 2 times at its bound of 4\n"
        ),
        std::string::npos
    ) << os.str();

    EXPECT_TRUE(takeLoopsAtBound().empty());
}


TEST(stageLog, theIntervalIsKept)
{
    const std::string log(logOf(0.5, 0.2));
    const auto nLines = std::count(log.begin(), log.end(), '\n') - 3;

    EXPECT_GE(nLines, 1);
    EXPECT_LE(nLines, 2);
}


// ************************************************************************* //
