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


TEST(surfaceRemesh, lengthsByPlaceAreRead)
{
    const surfaceRemeshControls controls
    (
        remeshOf
        (
            "remesh { featureAngle 40; minEdge 0.001;"
            " patches { \"wing.*\" { maxEdge 0.01; } tail { maxEdge 0.02; } }"
            " regions { nose { geometry { type a; } mode distance;"
            " distance 0.3; maxEdge 0.005; } }"
            " sharpEdges { angle 120; maxEdge 0.002; } edgePerGap 2; }"
        )
    );

    ASSERT_EQ(controls.patches.size(), 2);
    EXPECT_TRUE(controls.patches[0].patches.match("wingTip"));
    EXPECT_EQ(controls.patches[0].maxEdge, 0.01);
    EXPECT_EQ(controls.patches[1].maxEdge, 0.02);
    ASSERT_EQ(controls.regions.size(), 1);
    EXPECT_EQ(controls.regions[0].name, "nose");
    EXPECT_EQ(controls.regions[0].distance, 0.3);
    EXPECT_EQ(controls.regions[0].maxEdge, 0.005);
    EXPECT_EQ(controls.sharpAngle, 120);
    EXPECT_EQ(controls.sharpMaxEdge, 0.002);
    EXPECT_EQ(controls.edgePerGap, 2);
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
    expectWords(errorOf("patches { wing {} }"), {"maxEdge", "wing", "missing"});
    expectWords
    (
        errorOf("minEdge 0.1; patches { wing { maxEdge 0.05; } }"),
        {"maxEdge", "0.05", "0.1"}
    );
    expectWords
    (
        errorOf("regions { nose { maxEdge 1; } }"), {"geometry", "missing"}
    );
    expectWords
    (
        errorOf("featureAngle 50; sharpEdges { angle 40; maxEdge 1; }"),
        {"angle", "40", "50", "180"}
    );
    expectWords(errorOf("sharpEdges { angle 90; }"), {"maxEdge", "missing"});
    expectWords(errorOf("edgePerGap 0;"), {"edgePerGap", "0.1", "100"});
}


// ************************************************************************* //
