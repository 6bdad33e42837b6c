/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "layerSpacing.H"
#include "readLayerThickness.H"
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


static layerThickness read(const std::string& text, const label nLayers = n)
{
    return readLayerThickness(dictionaryOf(text), nLayers);
}


static std::string errorOf(const std::string& text, const label nLayers = n)
{
    return thrownMessage([&]() { read(text, nLayers); });
}


static void expectThickness
(
    const layerThickness& thickness,
    const scalar first,
    const scalar ratio
)
{
    EXPECT_NEAR(thickness.firstLayerThickness/first, 1, 1e-10);
    EXPECT_NEAR(thickness.expansionRatio, ratio, 1e-10);
}

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(readLayerThickness, anyPairDeterminesTheLayers)
{
    expectThickness(read(firstEntry() + finalEntry()), h1, alpha);
    expectThickness(read(firstEntry() + totalEntry()), h1, alpha);
    expectThickness(read(firstEntry() + ratioEntry()), h1, alpha);
    expectThickness(read(finalEntry() + totalEntry()), h1, alpha);
    expectThickness(read(finalEntry() + ratioEntry()), h1, alpha);
    expectThickness(read(totalEntry() + ratioEntry()), h1, alpha);
}


TEST(readLayerThickness, layersMayBecomeThinner)
{
    expectThickness
    (
        read("firstLayerThickness 16; finalLayerThickness 1;", 5), 16, 0.5
    );
}


TEST(readLayerThickness, ratioHasADefault)
{
    const scalar ratio = layerThickness().expansionRatio;

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


TEST(readLayerThickness, saysWhatIsMissing)
{
    expectWords
    (
        errorOf(ratioEntry()),
        {"missing", "given: expansionRatio", "firstLayerThickness", "yPlus"}
    );
    expectWords(errorOf(""), {"missing", "given: none"});
}


TEST(readLayerThickness, saysWhatIsTooMuch)
{
    expectWords
    (
        errorOf(firstEntry() + finalEntry() + ratioEntry()),
        {
            "determined twice",
            "firstLayerThickness, finalLayerThickness, expansionRatio"
        }
    );
    expectWords
    (
        errorOf(firstEntry() + "yPlus { target 1; U 1; nu 1e-6; L 1; }"),
        {"Both yPlus and firstLayerThickness"}
    );
}


TEST(readLayerThickness, determinedRatioIsBounded)
{
    expectWords
    (
        errorOf("firstLayerThickness 1e-6; finalLayerThickness 1;"),
        {"expansionRatio", "determined by", "finalLayerThickness", "0.5 to 3"}
    );
    expectWords
    (
        errorOf("firstLayerThickness 1e-6; thickness 1;"),
        {"expansionRatio", "0.5 to 3"}
    );
}


TEST(readLayerThickness, determinedThicknessIsBounded)
{
    expectWords
    (
        errorOf("firstLayerThickness 1; expansionRatio 3;", 500),
        {"thickness", "determined by", "1e+06"}
    );
    expectWords
    (
        errorOf("finalLayerThickness 1; expansionRatio 3;", 500),
        {"firstLayerThickness", "determined by", "1e-12"}
    );
}


TEST(readLayerThickness, heightsBeyondNumbersAreRefused)
{
    expectWords
    (
        errorOf("firstLayerThickness 1; expansionRatio 3;", 1000),
        {"1000 layers", "expansionRatio 3", "out of all bounds"}
    );
}


TEST(readLayerThickness, thicknessMustHoldTheLayer)
{
    expectWords
    (
        errorOf("firstLayerThickness 1; thickness 0.5;"),
        {"thickness is 0.5", "more than 1"}
    );
    expectWords
    (
        errorOf("finalLayerThickness 1; thickness 1;"),
        {"thickness is 1", "more than 1"}
    );
}


TEST(readLayerThickness, oneLayerHasOneThickness)
{
    expectThickness(read("thickness 0.5;", 1), 0.5, 1.2);
    expectThickness
    (
        read("firstLayerThickness 0.5; thickness 0.5;", 1), 0.5, 1.2
    );
    expectWords
    (
        errorOf("firstLayerThickness 0.5; thickness 0.6;", 1),
        {"One layer has one thickness", "0.5", "0.6"}
    );
}


TEST(readLayerThickness, yPlusIsThatOfAFlatPlate)
{
    // Water at 1 m/s, Re = 1e6
    const scalar skinFriction = 0.026/std::pow(1e6, 1.0/7);
    const scalar y = 1e-6/std::sqrt(skinFriction/2);
    const std::string text("yPlus { target 1; U 1; nu 1e-6; L 1; }");

    expectThickness(read(text), 2*y, 1.2);
    expectThickness(read(text + ratioEntry()), 2*y, alpha);
    EXPECT_NEAR(flatPlateThickness(30, 1, 1e-6, 1), 60*y, 1e-15);
}


TEST(readLayerThickness, yPlusNeedsAllItsEntries)
{
    expectWords
    (
        errorOf("yPlus { target 1; U 1; nu 1e-6; }"),
        {"entry L of yPlus", "missing"}
    );
    expectWords
    (
        errorOf("yPlus { target 1; U 1; nu 1e-6; L 1; rho 1; }"),
        {"Unknown key rho", "target, U, nu, L"}
    );
    expectWords
    (
        errorOf("yPlus { target 1; U -1; nu 1e-6; L 1; }"),
        {"U is -1"}
    );
}


TEST(readLayerThickness, patchInheritsWhatItDoesNotSay)
{
    layerThickness general;
    general.firstLayerThickness = h1;
    general.expansionRatio = alpha;

    const auto readPatch = [&](const std::string& text)
    {
        return readLayerThickness(dictionaryOf(text), n, general);
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


// ************************************************************************* //
