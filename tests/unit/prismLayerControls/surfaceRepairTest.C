/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "minimalControls.H"

using namespace Foam;

typedef surfaceRepairControls::method method;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static surfaceRepairControls repairOf(const std::string& entries)
{
    return readControls("surface { file a.stl; " + entries + " }" + layers)
        .surface.repair;
}


static std::string errorOfRepair(const std::string& entries)
{
    return thrownMessage([&]() { repairOf(entries); });
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(surfaceRepair, isNoneByDefault)
{
    EXPECT_EQ(repairOf("").repair, method::none);
    EXPECT_EQ(repairOf("repair none;").repair, method::none);
}


TEST(surfaceRepair, entriesAreRead)
{
    const surfaceRepairControls stitch
    (
        repairOf("repair stitch; stitchCoeffs { gap 1e-3; hole 0.2; }")
    );
    EXPECT_EQ(stitch.repair, method::stitch);
    EXPECT_EQ(stitch.gap, 1e-3);
    EXPECT_EQ(stitch.hole, 0.2);

    const surfaceRepairControls wrap
    (
        repairOf
        (
            "repair wrap;"
            " wrapCoeffs { size 0.1; offset 0.01; seeds ((1 2 3)); }"
        )
    );
    EXPECT_EQ(wrap.repair, method::wrap);
    EXPECT_EQ(wrap.size, 0.1);
    EXPECT_EQ(wrap.offset, 0.01);
    EXPECT_EQ(wrap.seeds, pointField(1, point(1, 2, 3)));
}


TEST(surfaceRepair, wrongEntriesAreErrors)
{
    expectWords(errorOfRepair("repair glue;"), {"glue", "stitch", "wrap"});
    expectWords
    (
        errorOfRepair("repair wrap; wrapCoeffs { sise 1; }"), {"sise", "size"}
    );
    expectWords
    (
        errorOfRepair("repair wrap; wrapCoeffs { size 0; }"), {"size", "0"}
    );
    expectWords
    (
        errorOfRepair("repair stitch; stitchCoeffs { hole -1; }"), {"hole"}
    );
}


// ************************************************************************* //
