/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "minimalControls.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static surfaceRemeshControls remeshOf(const std::string& entries)
{
    return readControls("surface { file a.stl; " + entries + " }" + layers)
        .surface.remesh;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(surfaceRemesh, isOffUnlessThereIsADictionary)
{
    EXPECT_FALSE(remeshOf("").active);
    EXPECT_TRUE(remeshOf("remesh {}").active);
    EXPECT_EQ(remeshOf("remesh {}").maxEdge, 0);
}


TEST(surfaceRemesh, entriesAreRead)
{
    const surfaceRemeshControls controls
    (
        remeshOf
        (
            "remesh { maxEdge 0.05; minEdge 0.005; deviation 2e-4;"
            " featureAngle 40; growthRate 1.3; }"
        )
    );

    EXPECT_EQ(controls.maxEdge, 0.05);
    EXPECT_EQ(controls.minEdge, 0.005);
    EXPECT_EQ(controls.deviation, 2e-4);
    EXPECT_EQ(controls.featureAngle, 40);
    EXPECT_EQ(controls.growthRate, 1.3);
}


TEST(surfaceRemesh, errorsNameKeyAndBounds)
{
    const auto errorOf = [](const std::string& entries)
    {
        return thrownMessage([&]() { remeshOf("remesh { " + entries + " }"); });
    };

    expectWords(errorOf("maxEdge -1;"), {"maxEdge", "-1"});
    expectWords(errorOf("maxEdge 0.1; minEdge 0.2;"), {"minEdge", "0.1"});
    expectWords(errorOf("deviation 0;"), {"deviation"});
    expectWords(errorOf("featureAngle 120;"), {"featureAngle", "90"});
    expectWords(errorOf("growthRate 1;"), {"growthRate", "1.01"});
    expectWords(errorOf("size 1;"), {"size", "maxEdge"});
}


// ************************************************************************* //
