/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "minimalControls.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const std::string fromRun
(
    "yPlus { target 1; from { case \"../run\"; } } "
);


static layerControls layersOf(const std::string& entries)
{
    return readControls
    (
        surface + "layers { nSurfaceLayers 20; " + entries + " }"
    ).layers;
}


static std::string errorIn(const std::string& entries)
{
    return thrownMessage([&]() { layersOf(entries); });
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(yPlusRun, isReadInPlaceOfAFirstHeight)
{
    const layerControls controls(layersOf(fromRun));

    EXPECT_TRUE(controls.fromRun.isGiven());
    EXPECT_EQ(controls.fromRun.target, 1);
    EXPECT_EQ(controls.fromRun.folder, "../run");
    EXPECT_TRUE(controls.fromRun.isLatest);
    EXPECT_EQ(controls.heights.firstLayerThickness, 0);

    EXPECT_FALSE(layersOf("firstLayerThickness 1;").fromRun.isGiven());
    EXPECT_EQ(layersOf(fromRun + "thickness 0.1;").heights.thickness, 0.1);
}


TEST(yPlusRun, timeIsANumberOrLatest)
{
    const auto runOf = [](const std::string& time)
    {
        return layersOf
        (
            "yPlus { target 1; from { case a; time " + time + "; } }"
        ).fromRun;
    };

    EXPECT_TRUE(runOf("latest").isLatest);
    EXPECT_FALSE(runOf("0.25").isLatest);
    EXPECT_EQ(runOf("0.25").time, 0.25);
    expectWords
    (
        thrownMessage([&]() { runOf("last"); }), {"time is last", "latest"}
    );
}


TEST(yPlusRun, entriesMustFit)
{
    expectWords
    (
        errorIn("yPlus { target 1; from { case \"\"; } }"), {"case is empty"}
    );
    expectWords
    (
        errorIn("yPlus { target 0; from { case a; } }"),
        {"target is 0", "0.001 to 10000"}
    );
    expectWords
    (
        errorIn("yPlus { target 1; U 1; from { case a; } }"),
        {"Unknown key U", "target, from"}
    );
    expectWords
    (
        errorIn(fromRun + "firstLayerThickness 1;"),
        {"Both yPlus and firstLayerThickness"}
    );
    expectWords
    (
        errorIn(fromRun + "relativeSizes yes;"), {"relativeSizes"}
    );
    expectWords
    (
        errorIn(fromRun + "fields { firstLayerThickness { file a; } }"),
        {"yPlus.from", "fields.firstLayerThickness"}
    );
}


TEST(yPlusRun, layersAreNotDeterminedTwice)
{
    expectWords
    (
        errorIn(fromRun + "thickness 0.1; expansionRatio 1.2;"),
        {"twice", "yPlus.from", "thickness, expansionRatio"}
    );
    expectWords
    (
        errorIn
        (
            fromRun + "expansionRatio 1.2; fields { thickness { file a; } }"
        ),
        {"twice", "yPlus.from"}
    );
}


TEST(yPlusRun, isForAllOfTheWall)
{
    expectWords
    (
        errorIn
        (
            "firstLayerThickness 1; patches { wing { " + fromRun + " } }"
        ),
        {"applies to the whole wall", "from wing to layers.yPlus"}
    );
}


// ************************************************************************* //
