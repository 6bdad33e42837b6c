/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "minimalControls.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(readLayerControls, patchesWithoutLayersAreSides)
{
    const layerControls controls
    (
        readControls
        (
            surface + "layers { nSurfaceLayers 2; thickness 0.1; patches"
            " { \".*let\" { nSurfaceLayers 0; }"
            " symmetry { nSurfaceLayers 0; type symmetryPlane; }"
            " plate { type patch; } } }"
        ).layers
    );

    ASSERT_TRUE(controls.entryOf("inlet"));
    EXPECT_TRUE(controls.entryOf("inlet")->isSide);
    EXPECT_EQ(controls.entryOf("symmetry")->type, "symmetryPlane");
    EXPECT_FALSE(controls.entryOf("plate")->isSide);
    EXPECT_EQ(controls.entryOf("wall"), nullptr);

    expectWords
    (
        errorOfLayers
        (
            "patches { inlet { nSurfaceLayers 0; thickness 0.1; } }"
        ),
        {"inlet have no layers", "no heights", "Remove nSurfaceLayers 0"}
    );
    expectWords
    (
        errorOfLayers("patches { inlet { nSurfaceLayers -1; } }"),
        {"nSurfaceLayers is -1", "0 to 1000"}
    );
    expectWords
    (
        errorOfLayers("patches { inlet { type fog; } }"),
        {"type is fog", "symmetryPlane"}
    );
}


TEST(readLayerControls, heightsMustBeGiven)
{
    expectWords
    (
        errorOf(surface + "layers { nSurfaceLayers 2; expansionRatio 1.1; }"),
        {"missing", "given: expansionRatio", "firstLayerThickness", "yPlus"}
    );
    expectWords
    (
        errorOf(surface + "layers { nSurfaceLayers 2; }"),
        {"missing", "given: none"}
    );
}


TEST(readLayerControls, marchingDistances)
{
    const auto read = [](const std::string& text)
    {
        return readControls
        (
            surface + "layers { nSurfaceLayers 2; thickness 1; " + text + " }"
        ).layers.onLevelSets;
    };

    EXPECT_FALSE(read(""));
    EXPECT_FALSE(read("marchingDistances requested;"));
    EXPECT_TRUE(read("marchingDistances levelSets;"));
    expectWords
    (
        thrownMessage([&]() { read("marchingDistances exact;"); }),
        {"exact", "requested", "levelSets"}
    );
}


TEST(readLayerControls, marchingDirections)
{
    const auto read = [](const std::string& text)
    {
        return readControls
        (
            surface + "layers { nSurfaceLayers 2; thickness 1; " + text + " }"
        ).layers.alongField;
    };

    EXPECT_TRUE(read(""));
    EXPECT_TRUE(read("marchingDirections field;"));
    EXPECT_FALSE(read("marchingDirections axes;"));
    expectWords
    (
        thrownMessage([&]() { read("marchingDirections up;"); }),
        {"up", "field", "axes"}
    );
}


TEST(readLayerControls, automaticNumberOfLayers)
{
    const auto read = [](const std::string& text)
    {
        return readControls
        (
            surface + "layers { nSurfaceLayers auto; " + text + " }"
        ).layers;
    };
    const layerControls controls
    (
        read("firstLayerThickness 1e-3; finalAspect 0.5;")
    );

    EXPECT_TRUE(controls.automatic());
    EXPECT_EQ(controls.finalAspect, 0.5);

    expectWords
    (
        thrownMessage([&]() { read("thickness 1;"); }),
        {"nSurfaceLayers auto", "given: thickness"}
    );
    expectWords
    (
        thrownMessage([&]()
        {
            read("firstLayerThickness 1; patches { a { nSurfaceLayers 2; } }");
        }),
        {"nSurfaceLayers for a is 2", "auto"}
    );
    expectWords
    (
        thrownMessage([&]()
        {
            read("firstLayerThickness 1; fields { thickness { file f; } }");
        }),
        {"auto", "fields may have firstLayerThickness"}
    );
    expectWords
    (
        errorOfLayers("finalAspect 1;"),
        {"finalAspect is for nSurfaceLayers auto", "nSurfaceLayers is 20"}
    );
    expectWords
    (
        errorOf(surface + "layers { nSurfaceLayers many; thickness 1; }"),
        {"nSurfaceLayers is many", "auto"}
    );
}


TEST(readLayerControls, regions)
{
    const layerControls controls
    (
        readControls
        (
            surface
          + "layers { nSurfaceLayers 20; firstLayerThickness 1e-4; regions {"
            " wake { geometry { type searchableSphere; } mode distance;"
            " distance 0.1; firstLayerThickness 1e-5; }"
            " nose { geometry { type searchableBox; } nSurfaceLayers 7; } } }"
        ).layers
    );

    ASSERT_EQ(controls.regions.size(), 2);
    EXPECT_EQ(controls.regions[0].name, "wake");
    EXPECT_EQ(controls.regions[0].mode, layerRegion::modes::distance);
    EXPECT_EQ(controls.regions[0].distance, 0.1);
    EXPECT_EQ(controls.regions[0].heights.firstLayerThickness, 1e-5);
    EXPECT_EQ
    (
        controls.regions[0].geometry.get<word>("type"), "searchableSphere"
    );
    EXPECT_EQ(controls.regions[1].mode, layerRegion::modes::inside);
    EXPECT_EQ(controls.regions[1].heights.nSurfaceLayers, 7);
}


TEST(readLayerControls, regionsAreChecked)
{
    expectWords(errorOfLayers("regions { a {} }"), {"geometry", "missing"});
    expectWords
    (
        errorOfLayers("regions { a { geometry {} mode near; } }"),
        {"mode is near", "inside, outside, distance"}
    );
    expectWords
    (
        errorOfLayers("regions { a { geometry {} mode distance; } }"),
        {"region a", "mode distance without a distance"}
    );
    expectWords
    (
        errorOfLayers("regions { a { geometry {} distance 1; } }"),
        {"region a", "mode inside with a distance"}
    );
    expectWords
    (
        errorOfLayers
        (
            "regions { a { geometry {} firstLayerThickness 2; thickness 1; } }"
        ),
        {"thickness is 1", "more than 2"}
    );
}


TEST(readLayerControls, fieldsOfHeights)
{
    const layerControls controls
    (
        readControls
        (
            surface
          + "layers { nSurfaceLayers 20; firstLayerThickness 1e-4; fields {"
            " firstLayerThickness { file \"h.vtk\"; field h1; }"
            " thickness { file delta; } } }"
        ).layers
    );

    EXPECT_EQ(controls.firstLayerField.file, "h.vtk");
    EXPECT_EQ(controls.firstLayerField.field, "h1");
    EXPECT_EQ(controls.thicknessField.file, "delta");
    EXPECT_TRUE(controls.thicknessField.field.empty());

    expectWords
    (
        errorOfLayers("fields { expansionRatio { file f; } }"),
        {"Unknown key expansionRatio", "firstLayerThickness, thickness"}
    );
    expectWords
    (
        errorOfLayers("fields { thickness { file \"\"; } }"),
        {"file is empty"}
    );
}


TEST(readLayerControls, poorHeightsAreAllowedIfAsked)
{
    const std::string layers
    (
        surface + "layers { nSurfaceLayers 2; thickness 1;"
    );
    EXPECT_FALSE(readControls(layers + " }").layers.allowPoorHeights);
    EXPECT_TRUE
    (
        readControls(layers + " allowPoorHeights yes; }").layers
       .allowPoorHeights
    );
}


// ************************************************************************* //
