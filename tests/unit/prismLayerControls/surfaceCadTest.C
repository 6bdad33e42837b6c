/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "minimalControls.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static surfaceCadControls cadOf(const std::string& entries)
{
    return readControls
    (
        "surface { file a.step; cad { " + entries + " } }" + layers
    ).surface.cad;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(surfaceCad, entriesAreRead)
{
    const surfaceCadControls controls
    (
        cadOf("maxEdge 0.05; nPerCircle 20; maxSeconds 30;")
    );

    EXPECT_EQ(controls.maxEdge, 0.05);
    EXPECT_EQ(controls.nPerCircle, 20);
    EXPECT_EQ(controls.maxSeconds, 30);
    EXPECT_EQ(cadOf("").nPerCircle, surfaceCadControls().nPerCircle);
}


TEST(surfaceCad, errorsNameKeyAndBounds)
{
    const auto errorOf = [](const std::string& entries)
    {
        return thrownMessage([&]() { cadOf(entries); });
    };

    expectWords(errorOf("maxEdge -1;"), {"maxEdge", "-1"});
    expectWords(errorOf("nPerCircle 3;"), {"nPerCircle", "4", "100"});
    expectWords(errorOf("maxSeconds 0;"), {"maxSeconds", "1"});
    expectWords(errorOf("size 1;"), {"size", "maxEdge"});
}


// ************************************************************************* //
