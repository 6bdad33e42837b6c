/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "OSspecific.H"
#include "pluginVersion.H"

#include <fstream>
#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The rest of the first line of a file that starts with a text
static std::string after(const std::string& start, const std::string& name)
{
    std::ifstream file(getEnv("HARMONIC_PRISM_MESH") + "/" + name);

    for (std::string line; std::getline(file, line);)
    {
        if (!line.compare(0, start.size(), start))
        {
            return line.substr(start.size());
        }
    }

    return "no line " + start;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(pluginVersion, isThatOfTheFirstChanges)
{
    const std::string heading(after("## ", "CHANGELOG.md"));

    EXPECT_EQ(heading.substr(0, heading.find(',')), pluginVersion);
}


TEST(pluginVersion, isThatOfTheCitation)
{
    EXPECT_EQ(after("version: ", "CITATION.cff"), pluginVersion);
}


TEST(pluginVersion, isThatOfThePythonModule)
{
    EXPECT_EQ
    (
        after("version = ", "python/pyproject.toml"),
        std::string("\"") + pluginVersion + '"'
    );
}


TEST(pluginVersion, isPrintedIfItIsAskedFor)
{
    const char* asked[] = {"harmonicPrismMesh", "-overwrite", "-version"};
    const char* unasked[] = {"harmonicPrismMesh", "version", "-dict"};

    testing::internal::CaptureStdout();
    EXPECT_TRUE(versionIsAsked(3, asked));
    EXPECT_EQ
    (
        testing::internal::GetCapturedStdout().find
        (
            std::string("harmonicPrismMesh ") + pluginVersion + ", OpenFOAM v"
        ),
        0u
    );

    testing::internal::CaptureStdout();
    EXPECT_FALSE(versionIsAsked(3, unasked));
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}


// ************************************************************************* //
