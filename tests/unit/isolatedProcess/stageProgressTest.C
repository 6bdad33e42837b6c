/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "isolatedProcess.H"
#include "stageProgress.H"

#include <chrono>
#include <gtest/gtest.h>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Notes what it hears, for as long as it lives
struct heardSteps
{
    std::vector<std::string> all;

    explicit heardSteps(const double interval = 1)
    {
        const auto note = [this](const progressStep& step)
        {
            all.push_back
            (
                step.what + std::to_string(step.done) + '/'
              + std::to_string(step.total)
            );
        };
        listenToProgress(note, interval);
    }

    ~heardSteps() { listenToProgress({}); }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(stageProgress, isHeardOnceInAnInterval)
{
    const double interval = 0.1;
    heardSteps heard(interval);
    const auto start = std::chrono::steady_clock::now();
    double seconds = 0;

    for (label n = 1; seconds < 3*interval; ++n)
    {
        tellProgress("step ", n, 7);
        seconds = std::chrono::duration<double>
        (
            std::chrono::steady_clock::now() - start
        ).count();
    }

    ASSERT_GE(heard.all.size(), 2u);
    EXPECT_LE(heard.all.size(), 1 + seconds/interval);
    EXPECT_EQ(heard.all.front(), "step 1/7");
}


TEST(stageProgress, isHeardByOneThreadAtATime)
{
    int nInside = 0;
    int most = 0;
    label nHeard = 0;
    listenToProgress([&](const progressStep&)
    {
        most = std::max(most, ++nInside);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        --nInside;
        ++nHeard;
    });

    std::vector<std::thread> threads;
    for (label i = 0; i < 4; ++i)
    {
        threads.emplace_back([]
        {
            for (label k = 0; k < 1000; ++k)
            {
                tellProgress("step");
            }
        });
    }
    for (std::thread& thread : threads)
    {
        thread.join();
    }
    listenToProgress({});

    EXPECT_EQ(most, 1);
    EXPECT_GE(nHeard, 1);
}


TEST(stageProgress, goesOnWhileAnotherProcessWorks)
{
    heardSteps heard(0.1);
    tellProgress("waiting ");
    const auto work = [](pipeWriter& out)
    {
        // Nobody hears this process
        tellProgress("child ");
        ::usleep(250000);
        out('x');
        out.flush();
        ::usleep(250000);
    };
    char byte = 0;
    const auto read = [&](pipeReader& in) { in(byte); };

    EXPECT_EQ(isolatedProcess(work, read), processEnd::complete);
    EXPECT_EQ(byte, 'x');
    listenToProgress({});
    ASSERT_GE(heard.all.size(), 3u);
    for (const std::string& step : heard.all)
    {
        EXPECT_EQ(step, "waiting 0/0");
    }
}


TEST(stageProgress, threadsCountTogether)
{
    heardSteps heard;
    progressCounter counter("point ", 1024);

    std::vector<std::thread> threads;
    for (label i = 0; i < 4; ++i)
    {
        threads.emplace_back([&]
        {
            for (label k = 0; k < 64; ++k)
            {
                counter.countOne();
            }
        });
    }
    for (std::thread& thread : threads)
    {
        thread.join();
    }

    ASSERT_EQ(heard.all.size(), 1u);
    EXPECT_EQ(heard.all.front(), "point 256/1024");
}


TEST(stageProgress, nobodyNeedsToListen)
{
    listenToProgress({});
    EXPECT_NO_THROW(tellProgress("step", 1, 2));
}


// ************************************************************************* //
