/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerSpacing.H"
#include "readControls.H"
#include "thrownMessage.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- h1 = 0.001, alpha = 1.25, n = 10 and what follows from these
static constexpr label n = 10;
static constexpr scalar h1 = 0.001;
static constexpr scalar alpha = 1.25;


static std::string entryOf(const char* key, const scalar value)
{
    char text[100];
    std::snprintf(text, sizeof(text), "%s %.17g; ", key, value);

    return text;
}


static std::string firstEntry()
{
    return entryOf("firstLayerThickness", h1);
}


static std::string finalEntry()
{
    return entryOf("finalLayerThickness", h1*std::pow(alpha, n - 1));
}


static std::string totalEntry()
{
    return entryOf("thickness", totalThickness(n, h1, alpha));
}


static std::string ratioEntry()
{
    return entryOf("expansionRatio", alpha);
}


static heightEntries readHeights
(
    const std::string& text,
    const bool relativeSizes = false
)
{
    heightEntries given;
    given.relativeSizes = relativeSizes;
    controlEntries::read(dictionaryOf(text), [&](controlEntries& entries)
    {
        declare(entries, given);
    });

    return given;
}


//- What entries make of heights, and the general ones of none
static heightSeries read
(
    const std::string& text,
    const label nLayers = n,
    const heightSeries& before = heightSeries()
)
{
    const dictionary dict(dictionaryOf(text));
    heightEntries given(readHeights(text));
    given.nSurfaceLayers = nLayers;
    heightSeries result;

    atEntriesOf(dict, [&]() { result = changedHeights(before, given, 1); });

    return result;
}


static std::string heightsError
(
    const std::string& text,
    const label nLayers = n
)
{
    return thrownMessage([&]() { read(text, nLayers); });
}


static void expectThickness
(
    const heightSeries& thickness,
    const scalar first,
    const scalar ratio
)
{
    EXPECT_NEAR(thickness.firstLayerThickness/first, 1, 1e-10);
    EXPECT_NEAR(thickness.expansionRatio, ratio, 1e-10);
}

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(readLayerHeights, anyPairDeterminesTheLayers)
{
    expectThickness(read(firstEntry() + finalEntry()), h1, alpha);
    expectThickness(read(firstEntry() + totalEntry()), h1, alpha);
    expectThickness(read(firstEntry() + ratioEntry()), h1, alpha);
    expectThickness(read(finalEntry() + totalEntry()), h1, alpha);
    expectThickness(read(finalEntry() + ratioEntry()), h1, alpha);
    expectThickness(read(totalEntry() + ratioEntry()), h1, alpha);
}


TEST(readLayerHeights, layersMayBecomeThinner)
{
    expectThickness
    (
        read("firstLayerThickness 16; finalLayerThickness 1;", 5), 16, 0.5
    );
}


TEST(readLayerHeights, ratioHasADefault)
{
    const scalar ratio = heightSeries().expansionRatio;

    expectThickness(read(firstEntry()), h1, ratio);
    EXPECT_NEAR
    (
        totalThickness(n, read("thickness 2;").firstLayerThickness, ratio),
        2,
        1e-12
    );
    EXPECT_NEAR
    (
        read("finalLayerThickness 2;").firstLayerThickness
       *std::pow(ratio, n - 1),
        2,
        1e-12
    );
}


TEST(readLayerHeights, saysWhatIsTooMuch)
{
    expectWords
    (
        heightsError(firstEntry() + finalEntry() + ratioEntry()),
        {
            "determined twice",
            "firstLayerThickness, finalLayerThickness, expansionRatio"
        }
    );
    expectWords
    (
        heightsError(firstEntry() + "yPlus { target 1; U 1; nu 1e-6; L 1; }"),
        {"Both yPlus and firstLayerThickness"}
    );
}


TEST(readLayerHeights, determinedRatioIsBounded)
{
    expectWords
    (
        heightsError("firstLayerThickness 1e-6; finalLayerThickness 1;"),
        {"expansionRatio", "determined by", "finalLayerThickness", "0.5 to 3"}
    );
    expectWords
    (
        heightsError("firstLayerThickness 1e-6; thickness 1;"),
        {"expansionRatio", "0.5 to 3"}
    );
}


TEST(readLayerHeights, determinedThicknessIsBounded)
{
    expectWords
    (
        heightsError("firstLayerThickness 1; expansionRatio 3;", 500),
        {"thickness", "determined by", "1e+06"}
    );
    expectWords
    (
        heightsError("finalLayerThickness 1; expansionRatio 3;", 500),
        {"firstLayerThickness", "determined by", "1e-12"}
    );
}


TEST(readLayerHeights, heightsBeyondNumbersAreRefused)
{
    expectWords
    (
        heightsError("firstLayerThickness 1; expansionRatio 3;", 1000),
        {"1000 layers", "expansionRatio is 3", "out of all bounds"}
    );
}


TEST(readLayerHeights, thicknessMustHoldTheLayer)
{
    expectWords
    (
        heightsError("firstLayerThickness 1; thickness 0.5;"),
        {"thickness is 0.5", "more than 1"}
    );
    expectWords
    (
        heightsError("finalLayerThickness 1; thickness 1;"),
        {"thickness is 1", "more than 1"}
    );
}


TEST(readLayerHeights, oneLayerHasOneThickness)
{
    expectThickness(read("thickness 0.5;", 1), 0.5, 1.2);
    expectThickness
    (
        read("firstLayerThickness 0.5; thickness 0.5;", 1), 0.5, 1.2
    );
    expectWords
    (
        heightsError("firstLayerThickness 0.5; thickness 0.6;", 1),
        {"One layer has one thickness", "0.5", "0.6"}
    );
}


TEST(readLayerHeights, yPlusIsThatOfAFlatPlate)
{
    // Water at 1 m/s, Re = 1e6
    const scalar skinFriction = 0.026/std::pow(1e6, 1.0/7);
    const scalar y = 1e-6/std::sqrt(skinFriction/2);
    const std::string text("yPlus { target 1; U 1; nu 1e-6; L 1; }");

    expectThickness(read(text), 2*y, 1.2);
    expectThickness(read(text + ratioEntry()), 2*y, alpha);
    EXPECT_NEAR(flatPlateThickness(30, 1, 1e-6, 1), 60*y, 1e-15);
}


TEST(readLayerHeights, yPlusNeedsAllItsEntries)
{
    expectWords
    (
        heightsError("yPlus { target 1; U 1; nu 1e-6; }"),
        {"entry L of yPlus", "missing"}
    );
    expectWords
    (
        heightsError("yPlus { target 1; U 1; nu 1e-6; L 1; rho 1; }"),
        {"Unknown key rho", "target, U, nu, L"}
    );
    expectWords
    (
        heightsError("yPlus { target 1; U -1; nu 1e-6; L 1; }"),
        {"U is -1"}
    );
}


TEST(readLayerHeights, patchInheritsWhatItDoesNotSay)
{
    heightSeries general;
    general.firstLayerThickness = h1;
    general.expansionRatio = alpha;

    const auto readPatch = [&](const std::string& text)
    {
        return read(text, n, general);
    };

    expectThickness(readPatch(""), h1, alpha);
    expectThickness(readPatch("firstLayerThickness 1;"), 1, alpha);
    expectThickness(readPatch("expansionRatio 1.1;"), h1, 1.1);
    expectThickness(readPatch(totalEntry()), h1, alpha);
    expectThickness
    (
        readPatch("firstLayerThickness 1; expansionRatio 1.1;"), 1, 1.1
    );
}


TEST(readLayerHeights, relativeSizesAreMultiplesOfTheUnit)
{
    heightEntries given
    (
        readHeights
        (
            "relativeSizes yes; finalLayerThickness 0.5; expansionRatio 1.1;"
        )
    );
    given.nSurfaceLayers = n;

    EXPECT_TRUE(given.relativeSizes);
    expectThickness
    (
        changedHeights(heightSeries(), given, 0.02),
        0.01/std::pow(1.1, n - 1),
        1.1
    );

    // Metres on top of them, and alpha alone, have no unit
    heightSeries before;
    before.n = n;
    before.firstLayerThickness = h1;
    before.expansionRatio = alpha;
    heightEntries ratioAlone;
    ratioAlone.relativeSizes = true;
    ratioAlone.expansionRatio = 1.1;

    expectThickness(changedHeights(before, ratioAlone, 0.02), h1, 1.1);
}


TEST(readLayerHeights, yPlusIsNotRelative)
{
    expectWords
    (
        heightsError
        (
            "relativeSizes yes; yPlus { target 1; U 1; nu 1e-6; L 1; }"
        ),
        {"yPlus gives a height in metres", "relativeSizes"}
    );
}


TEST(readLayerHeights, partsInheritRelativeSizes)
{
    EXPECT_TRUE(readHeights("", true).relativeSizes);
    EXPECT_FALSE(readHeights("relativeSizes no;", true).relativeSizes);
}


TEST(readLayerHeights, reynoldsNumberIsKept)
{
    const heightEntries given
    (
        readHeights("yPlus { target 30; U 50; nu 1.5e-5; L 4; }")
    );

    EXPECT_EQ(given.yPlus, 30);
    EXPECT_NEAR(given.Re/(200/1.5e-5), 1, 1e-14);
    EXPECT_EQ(given.firstLayerThickness, flatPlateThickness(30, 50, 1.5e-5, 4));
}


// ************************************************************************* //
