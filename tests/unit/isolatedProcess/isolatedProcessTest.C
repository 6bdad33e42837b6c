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
#include <vector>

#include <sys/stat.h>

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- How a piece of work ends, when one number is read on
static processEnd endOf(const std::function<void(std::FILE*)>& work)
{
    return isolatedProcess
    (
        work,
        [](std::FILE* in)
        {
            int i = 0;
            return std::fread(&i, sizeof(i), 1, in) == 1 && i == 42;
        },
        1
    );
}


static bool completes(const std::function<void(std::FILE*)>& work)
{
    return endOf(work) == processEnd::complete;
}


static bool fails(const std::function<void(std::FILE*)>& work)
{
    return endOf(work) == processEnd::failed;
}


static void write42(std::FILE* out)
{
    const int i = 42;
    std::fwrite(&i, sizeof(i), 1, out);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(isolatedProcess, writtenDataIsRead)
{
    EXPECT_TRUE(completes(write42));
}


TEST(isolatedProcess, moreThanAPipeHolds)
{
    std::vector<int> sent(1000000), received(sent.size());
    std::iota(sent.begin(), sent.end(), 0);

    EXPECT_EQ
    (
        isolatedProcess
        (
            [&](std::FILE* out)
            {
                std::fwrite(sent.data(), sizeof(int), sent.size(), out);
            },
            [&](std::FILE* in)
            {
                return received.size() == std::fread
                (
                    received.data(), sizeof(int), received.size(), in
                );
            },
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
        endOf([](std::FILE*) { for (volatile int i = 0; ; i = !i) {} }),
        processEnd::tooLong
    );
}


TEST(isolatedProcess, childChangesNothingHere)
{
    int i = 1;
    EXPECT_TRUE(completes([&](std::FILE* out) { i = 2; write42(out); }));
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
    const auto countOne = [&](std::FILE* out)
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
            fails([&](std::FILE* out) { write42(out); std::raise(sig); })
        );
    }
}


TEST(isolatedProcess, exceptionsAreFailures)
{
    EXPECT_TRUE
    (
        fails
        (
            [](std::FILE* out)
            {
                write42(out);
                throw std::runtime_error("no result");
            }
        )
    );
    EXPECT_TRUE(fails([](std::FILE*) { throw 1; }));
}


TEST(isolatedProcess, fatalErrorsAreFailures)
{
    EXPECT_TRUE
    (
        fails
        (
            [](std::FILE* out)
            {
                write42(out);
                FatalErrorInFunction << "no result" << exit(FatalError);
            }
        )
    );
}


TEST(isolatedProcess, exitIsAFailure)
{
    EXPECT_TRUE(fails([](std::FILE* out) { write42(out); std::_Exit(3); }));
    EXPECT_TRUE(fails([](std::FILE*) { std::_Exit(0); }));
}


TEST(isolatedProcess, readerThatRefusesIsAFailure)
{
    // It leaves a child behind that has more to write
    EXPECT_EQ
    (
        isolatedProcess
        (
            [](std::FILE* out)
            {
                for (int i = 0; i < 1000000; ++i)
                {
                    write42(out);
                }
            },
            [](std::FILE*) { return false; },
            60
        ),
        processEnd::failed
    );
}


//- Whether work completes while so many other processes are read from
static bool completesBeside
(
    const int nOthers,
    const std::function<void(std::FILE*)>& work
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
        [&](std::FILE*)
        {
            inner = completesBeside(nOthers - 1, work);
            return true;
        }
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
                [](std::FILE* out)
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
        [](std::FILE* out)
        {
            const int own = nPipes();
            std::fwrite(&own, sizeof(own), 1, out);
        },
        [&](std::FILE* in)
        {
            whileReading();
            return std::fread(&n, sizeof(n), 1, in) == 1;
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
