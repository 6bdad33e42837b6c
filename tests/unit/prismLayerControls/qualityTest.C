/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "minimalControls.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static qualityControls qualityOf(const std::string& entries)
{
    return readControls(surface + layers + "quality { " + entries + " }")
        .quality;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(readQuality, defaultsAreThoseOfMeshQualityDict)
{
    const qualityControls controls(readControls(surface + layers).quality);

    EXPECT_EQ(controls.maxNonOrtho, 70);
    EXPECT_EQ(controls.maxInternalSkewness, 4);
    EXPECT_EQ(controls.minFaceWeight, 0.05);
    EXPECT_EQ(controls.minVolRatio, 0.01);
    EXPECT_EQ(controls.minTetQuality, 1e-15);
    EXPECT_EQ(controls.priority, qualityControls::priorities::quality);
}


TEST(readQuality, everyEntryIsRead)
{
    const qualityControls controls
    (
        qualityOf
        (
            "maxNonOrtho 65; maxInternalSkewness 3; minFaceWeight 0.02;"
            " minVolRatio 0.02; minTetQuality -1e30; priority thickness;"
        )
    );

    EXPECT_EQ(controls.maxNonOrtho, 65);
    EXPECT_EQ(controls.maxInternalSkewness, 3);
    EXPECT_EQ(controls.minFaceWeight, 0.02);
    EXPECT_EQ(controls.minVolRatio, 0.02);
    EXPECT_EQ(controls.minTetQuality, -1e30);
    EXPECT_EQ(controls.priority, qualityControls::priorities::thickness);
}


TEST(readQuality, errorsNameKeyAndBounds)
{
    const auto errorOf = [](const std::string& entries)
    {
        return thrownMessage([&]() { qualityOf(entries); });
    };

    expectWords(errorOf("maxNonOrtho 20;"), {"maxNonOrtho", "20", "30", "90"});
    expectWords(errorOf("maxInternalSkewness 0.5;"), {"maxInternalSkewness"});
    expectWords(errorOf("minFaceWeight 0.6;"), {"minFaceWeight", "0.5"});
    expectWords(errorOf("minVolRatio 2;"), {"minVolRatio"});
    expectWords(errorOf("minTetQuality 2;"), {"minTetQuality"});
    expectWords(errorOf("priority layers;"), {"priority", "thickness"});
    expectWords(errorOf("maxNonOrthogonality 70;"), {"maxNonOrtho"});
}


// ************************************************************************* //
