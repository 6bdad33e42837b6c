/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "isolatedProcess.H"
#include "temporaryFiles.H"

#include <chrono>
#include <cstdlib>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

class runProgramTest
:
    public temporaryFiles
{
protected:

    programEnd endOf
    (
        const std::vector<std::string>& command,
        const double seconds = 60
    ) const
    {
        return runProgram
        (
            command, {"HPM_TEST=set here"}, folder_, "log", seconds
        );
    }
};

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_F(runProgramTest, argumentsAreNotForAShell)
{
    EXPECT_EQ
    (
        endOf({"printf", "%s|", "a b", "$(c)", "'\"; d"}),
        programEnd::complete
    );
    EXPECT_EQ(contentsOf("log"), "a b|$(c)|'\"; d|");
}


TEST_F(runProgramTest, runsInTheFolder)
{
    EXPECT_EQ(endOf({"pwd", "-P"}), programEnd::complete);
    EXPECT_EQ(contentsOf("log"), folder_ + "\n");
}


TEST_F(runProgramTest, environmentIsSetForTheProgram)
{
    EXPECT_EQ(endOf({"printenv", "HPM_TEST"}), programEnd::complete);
    EXPECT_EQ(contentsOf("log"), "set here\n");
    EXPECT_EQ(std::getenv("HPM_TEST"), nullptr);
}


TEST_F(runProgramTest, errorsOfTheProgramAreInTheLog)
{
    EXPECT_EQ(endOf({"ls", "/none such"}), programEnd::failed);
    EXPECT_NE(contentsOf("log").find("/none such"), std::string::npos);
}


TEST_F(runProgramTest, stdinIsEmpty)
{
    EXPECT_EQ(endOf({"cat"}), programEnd::complete);
    EXPECT_EQ(contentsOf("log"), "");
}


TEST_F(runProgramTest, missingProgram)
{
    EXPECT_EQ(endOf({"no such program"}), programEnd::missing);
}


TEST_F(runProgramTest, signalIsAFailure)
{
    EXPECT_EQ(endOf({"sh", "-c", "kill -SEGV $$"}), programEnd::failed);
}


TEST_F(runProgramTest, allIsKilledAtTheTimeLimit)
{
    typedef std::chrono::steady_clock clock;
    const clock::time_point start = clock::now();

    // A process that outlived its parent would touch the file
    const char* script = "(sleep 0.6; touch late) & sleep 30";
    EXPECT_EQ(endOf({"sh", "-c", script}, 0.2), programEnd::tooLong);
    EXPECT_LT(clock::now() - start, std::chrono::seconds(15));

    runProgram({"sleep", "1"}, {}, folder_, "log", 60);
    EXPECT_FALSE(has("late"));
}


// ************************************************************************* //
