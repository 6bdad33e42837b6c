/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "isolatedProcess.H"
#include "error.H"

#include <csignal>
#include <cstdlib>
#include <numeric>
#include <omp.h>
#include <stdexcept>

#include <sys/stat.h>

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- How a piece of work ends, when one number is read on
static processEnd endOf(const std::function<void(pipeWriter&)>& work)
{
    return isolatedProcess
    (
        work,
        [](pipeReader& in)
        {
            int i = 0;
            in(i);
            EXPECT_EQ(i, 42);
        },
        1
    );
}


static bool completes(const std::function<void(pipeWriter&)>& work)
{
    return endOf(work) == processEnd::complete;
}


static bool fails(const std::function<void(pipeWriter&)>& work)
{
    return endOf(work) == processEnd::failed;
}


static void write42(pipeWriter& out)
{
    out(42);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(isolatedProcess, writtenDataIsRead)
{
    EXPECT_TRUE(completes(write42));
}


TEST(isolatedProcess, moreThanAPipeHolds)
{
    List<int> sent(1000000), received;
    std::iota(sent.begin(), sent.end(), 0);

    EXPECT_EQ
    (
        isolatedProcess
        (
            [&](pipeWriter& out) { out(sent); },
            [&](pipeReader& in) { in(received); },
            60
        ),
        processEnd::complete
    );
    EXPECT_EQ(received, sent);
}


TEST(isolatedProcess, workWithoutEndTakesTooLong)
{
    EXPECT_EQ
    (
        endOf([](pipeWriter&) { for (volatile int i = 0; ; i = !i) {} }),
        processEnd::tooLong
    );
}


TEST(isolatedProcess, childChangesNothingHere)
{
    int i = 1;
    EXPECT_TRUE(completes([&](pipeWriter& out) { i = 2; write42(out); }));
    EXPECT_EQ(i, 1);
}


TEST(isolatedProcess, childHasOneThreadOfOpenMP)
{
    const auto count = []()
    {
        label n = 0;
        #pragma omp parallel reduction(+ : n)
        ++n;

        return n;
    };

    omp_set_num_threads(3);
    EXPECT_EQ(count(), 3);

    // On more threads the child would wait for ever
    const auto countOne = [&](pipeWriter& out)
    {
        if (count() == 1)
        {
            write42(out);
        }
    };
    EXPECT_TRUE(completes(countOne));
    omp_set_num_threads(omp_get_num_procs());
}


TEST(isolatedProcess, signalsAreFailures)
{
    for (const int sig : {SIGABRT, SIGSEGV, SIGFPE, SIGKILL})
    {
        EXPECT_TRUE
        (
            fails([&](pipeWriter& out) { write42(out); std::raise(sig); })
        );
    }
}


TEST(isolatedProcess, exceptionsAreFailures)
{
    EXPECT_TRUE
    (
        fails
        (
            [](pipeWriter& out)
            {
                write42(out);
                throw std::runtime_error("no result");
            }
        )
    );
    EXPECT_TRUE(fails([](pipeWriter&) { throw 1; }));
}


TEST(isolatedProcess, fatalErrorsAreFailures)
{
    EXPECT_TRUE
    (
        fails
        (
            [](pipeWriter& out)
            {
                write42(out);
                FatalErrorInFunction << "no result" << exit(FatalError);
            }
        )
    );
}


TEST(isolatedProcess, exitIsAFailure)
{
    EXPECT_TRUE(fails([](pipeWriter& out) { write42(out); std::_Exit(3); }));
    EXPECT_TRUE(fails([](pipeWriter&) { std::_Exit(0); }));
}


TEST(isolatedProcess, readerThatEndsEarlyLetsWorkFail)
{
    // It leaves a child behind that has more to write
    EXPECT_EQ
    (
        isolatedProcess
        (
            [](pipeWriter& out)
            {
                for (int i = 0; i < 1000000; ++i)
                {
                    write42(out);
                }
            },
            [](pipeReader&) {},
            60
        ),
        processEnd::failed
    );
}


//- Whether work completes while so many other processes are read from
static bool completesBeside
(
    const int nOthers,
    const std::function<void(pipeWriter&)>& work
)
{
    if (nOthers == 0)
    {
        return completes(work);
    }

    bool inner = false;
    isolatedProcess
    (
        write42,
        [&](pipeReader&) { inner = completesBeside(nOthers - 1, work); }
    );

    return inner;
}


TEST(isolatedProcess, childrenHaveChildren)
{
    // A child uses the numbers of the pipes again that it has closed
    for (int nOthers = 0; nOthers < 6; ++nOthers)
    {
        EXPECT_TRUE
        (
            completesBeside
            (
                nOthers,
                [](pipeWriter& out)
                {
                    if (completes(write42))
                    {
                        write42(out);
                    }
                }
            )
        ) << nOthers;
    }
}


//- How many pipes a process has open, of those beyond standard error
static int nPipes()
{
    int n = 0;

    for (int fd = 3; fd < 256; ++fd)
    {
        struct stat status;
        n += ::fstat(fd, &status) == 0 && S_ISFIFO(status.st_mode);
    }

    return n;
}


static int nPipesOfChild(const std::function<void()>& whileReading)
{
    int n = -1;

    isolatedProcess
    (
        [](pipeWriter& out) { out(nPipes()); },
        [&](pipeReader& in)
        {
            whileReading();
            in(n);
        }
    );

    return n;
}


TEST(isolatedProcess, childrenDoNotHaveThePipesOfOthers)
{
    int inside = -1;
    const int alone = nPipesOfChild([&]()
    {
        inside = nPipesOfChild([]() {});
    });

    EXPECT_GE(alone, 1);
    EXPECT_EQ(inside, alone);
}


// ************************************************************************* //
