/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshFiles.H"
#include "temporaryFiles.H"
#include "thrownMessage.H"
#include "Time.H"

#include <csignal>
#include <omp.h>
#include <stdexcept>
#include <sys/resource.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- Files of a case are written by three threads
class writeBlocksTest
:
    public temporaryFiles
{
    label nThreads_ = 0;

protected:

    autoPtr<Time> time_;

    void SetUp() override
    {
        temporaryFiles::SetUp();
        nThreads_ = omp_get_max_threads();
        omp_set_num_threads(3);
        infoDetailLevel = 0;
        dictionary control;
        control.add("deltaT", 1);
        control.add("writeInterval", 1);
        time_.reset
        (
            new Time
            (
                control, folder_, "case", "system", "constant", false, false
            )
        );
    }

    void TearDown() override
    {
        time_.clear();
        omp_set_num_threads(nThreads_);
        temporaryFiles::TearDown();
    }

    blockFile file
    (
        const word& name,
        const label nBlocks,
        const std::function<std::string(label)>& bytes
    ) const
    {
        return blockFile
        {
            IOobject
            (
                name, time_->constant(), time_(),
                IOobject::NO_READ, IOobject::NO_WRITE, false
            ),
            "text", nBlocks, bytes
        };
    }
};


//- Files of this process have at most so many bytes in this scope
class fileLimit
{
    rlimit before_;

public:

    explicit fileLimit(const rlim_t nBytes)
    {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limit(before_);
        limit.rlim_cur = nBytes;
        setrlimit(RLIMIT_FSIZE, &limit);
    }

    ~fileLimit()
    {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, SIG_DFL);
    }
};


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_F(writeBlocksTest, blocksAreInTheirOrder)
{
    const auto number = [](const label i) { return std::to_string(i) + ' '; };
    writeBlocks({file("few", 3, number), file("many", 500, number)});

    std::string expected;
    for (label i = 0; i < 500; ++i)
    {
        expected += number(i);
    }
    const std::string text(contentsOf("case/constant/many"));
    EXPECT_NE(text.find("class       text;"), std::string::npos);
    EXPECT_NE(text.find("//\n\n" + expected + "\n\n// *"), std::string::npos);
    EXPECT_NE
    (
        contentsOf("case/constant/few").find("\n0 1 2 \n"), std::string::npos
    );
}


TEST_F(writeBlocksTest, oneErrorIfAllFilesAreTooLong)
{
    const auto much = [](label) { return std::string(20000, 'x'); };
    const fileLimit limit(50000);

    for (label k = 0; k < 300; ++k)
    {
        const std::string message
        (
            thrownMessage<error>
            (
                [&]()
                {
                    writeBlocks
                    ({
                        file("a", 9, much), file("b", 9, much),
                        file("c", 9, much)
                    });
                }
            )
        );
        ASSERT_NE(message.find("/case/constant/"), std::string::npos);
        ASSERT_EQ(message.rfind("Cannot write"), message.find("Cannot write"));
    }
}


TEST_F(writeBlocksTest, oneErrorIfAFileCannotBeOpened)
{
    temporaryFiles::file("case", "no folder");

    const std::string message
    (
        thrownMessage<error>
        (
            [&]()
            {
                writeBlocks({file("a", 1, [](label) { return "b"; })});
            }
        )
    );
    EXPECT_NE(message.find("/case/constant"), std::string::npos);
}


TEST_F(writeBlocksTest, errorsOfBlocksArePassedOn)
{
    const auto fails = [](const label i)
    {
        if (i % 7 == 5)
        {
            throw std::out_of_range("no block");
        }

        return std::string("block");
    };

    EXPECT_THROW
    (
        writeBlocks({file("a", 100, fails), file("b", 100, fails)}),
        std::out_of_range
    );
}


// ************************************************************************* //
