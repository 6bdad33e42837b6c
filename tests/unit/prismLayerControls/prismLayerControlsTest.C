/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "minimalControls.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(prismLayerControls, minimalDictionaryHasTheDefaults)
{
    prismLayerControls defaults;
    defaults.surface.files = fileNameList(1, "body.obj");
    defaults.layers.heights.nSurfaceLayers = 20;
    defaults.layers.heights.firstLayerThickness = 1e-4;

    expectEqual(readControls(surface + layers), defaults);
}


TEST(prismLayerControls, everyEntryIsRead)
{
    const prismLayerControls controls
    (
        readControls
        (
            "FoamFile { version 2.0; format ascii; class dictionary;"
            " object harmonicPrismMeshDict; }"
            "surface { file a.stl; fluid inside; scale 0.001;"
            " mergeTolerance 1e-6; }"
            "layers { nSurfaceLayers 5; thickness 31; expansionRatio 2;"
            " maxStretch 3; transitionRatio 1.5;"
            " patches { \"wing.*\" { expansionRatio 1; }"
            " tail { nSurfaceLayers 5; } } }"
            "envelope { scale 1.5; }"
            "backgroundMesh { radiusEdgeRatio 2; }"
            "field { tensor isotropic; solver iteration; tolerance 1e-8;"
            " isotropicCoeffs {} anisotropicCoeffs { beta -2; } }"
            "farField { type none; }"
        )
    );

    EXPECT_EQ(controls.surface.files, fileNameList(1, "a.stl"));
    EXPECT_FALSE(controls.surface.fluidOutside);
    EXPECT_EQ(controls.surface.scale, 0.001);
    EXPECT_EQ(controls.surface.mergeTolerance, 1e-6);
    EXPECT_EQ(controls.layers.heights.nSurfaceLayers, 5);
    EXPECT_EQ(controls.layers.heights.thickness, 31);
    EXPECT_EQ(controls.layers.heights.expansionRatio, 2);
    EXPECT_EQ(controls.layers.maxStretch, 3);
    EXPECT_EQ(controls.layers.transitionRatio, 1.5);
    EXPECT_EQ(controls.envelope.scale, 1.5);
    EXPECT_EQ(controls.backgroundMesh.radiusEdgeRatio, 2);
    EXPECT_EQ(controls.field.tensor, "isotropic");
    EXPECT_EQ(controls.field.solver, fieldSolver::iteration);
    EXPECT_EQ(controls.field.tolerance, 1e-8);

    ASSERT_EQ(controls.layers.patches.size(), 2);
    EXPECT_TRUE(controls.layers.patches[0].patches.isPattern());
    EXPECT_TRUE(controls.layers.patches[0].patches.match("wingLeft"));
    EXPECT_EQ(controls.layers.patches[0].heights.expansionRatio, 1);
    EXPECT_EQ(controls.layers.patches[1].patches, "tail");
    EXPECT_EQ(controls.layers.patches[1].heights.expansionRatio, 0);
    EXPECT_EQ(controls.layers.patches[1].heights.nSurfaceLayers, 5);
}


TEST(prismLayerControls, coefficientsOfTheTensorAreKept)
{
    const prismLayerControls controls
    (
        readControls
        (
            surface + layers
          + "field { tensor anisotropic;"
            " anisotropicCoeffs { beta -2; delta 1; } }"
        )
    );

    EXPECT_EQ(controls.field.tensorCoeffs.get<scalar>("beta"), -2);
    EXPECT_EQ(controls.field.tensorCoeffs.get<scalar>("delta"), 1);
}


TEST(prismLayerControls, tensorDependsOnTheMarchingDistances)
{
    const auto tensorOf = [](const std::string& distances)
    {
        return readControls
        (
            surface + "layers { nSurfaceLayers 2; thickness 1;"
            " marchingDistances " + distances + "; }"
        ).field.tensor;
    };

    EXPECT_EQ(tensorOf("requested"), "isotropic");
    EXPECT_EQ(tensorOf("levelSets"), "anisotropic");
}


TEST(prismLayerControls, coefficientsAreChecked)
{
    expectWords
    (
        errorOf
        (
            surface + layers
          + "field { tensor anisotropic; anisotropicCoeffs { beta 1; } }"
        ),
        {"beta is 1", "-4 to 0"}
    );
}


TEST(prismLayerControls, mandatoryEntriesAreMissed)
{
    expectWords(errorOf(layers), {"surface", "missing"});
    expectWords(errorOf(surface), {"layers", "missing"});
    expectWords(errorOf("surface {}" + layers), {"file"});
    expectWords(errorOf("surface { file \"\"; }" + layers), {"file is empty"});
    expectWords
    (
        errorOf(surface + "layers { firstLayerThickness 1; }"),
        {"nSurfaceLayers", "missing"}
    );
    expectWords
    (
        errorOf(surface + "layers { nSurfaceLayers 1; }"),
        {"missing", "firstLayerThickness"}
    );
}


TEST(prismLayerControls, valuesOutOfBoundsAreRefused)
{
    expectWords
    (
        errorOf(surface + "layers { nSurfaceLayers 0; thickness 1; }"),
        {"nSurfaceLayers is 0", "1 to 1000"}
    );
    expectWords
    (
        errorOf("surface { file a; scale 0; }" + layers),
        {"scale is 0", "1e-09 to 1e+09"}
    );
    expectWords
    (
        errorOf("surface { file a; mergeTolerance 1; }" + layers),
        {"mergeTolerance is 1", "0 to 0.001"}
    );
    expectWords
    (
        errorOf("surface { file a; fluid around; }" + layers),
        {"fluid is around", "inside, outside"}
    );
    expectWords(errorOfLayers("maxStretch 0.5;"), {"maxStretch is 0.5"});
    expectWords
    (
        errorOfLayers("transitionRatio 1;"), {"transitionRatio is 1", "1.01"}
    );
    expectWords
    (
        errorOfLayers("expansionRatio 4;"),
        {"expansionRatio is 4", "0.5 to 3"}
    );
    expectWords
    (
        errorOf(surface + layers + "envelope { scale 0.9; }"),
        {"scale is 0.9", "1 to 10"}
    );
    expectWords
    (
        errorOf(surface + layers + "backgroundMesh { radiusEdgeRatio 0; }"),
        {"radiusEdgeRatio is 0", "1 to 10"}
    );
    expectWords
    (
        errorOf(surface + layers + "field { tolerance 1; }"),
        {"tolerance is 1", "1e-14 to 0.1"}
    );
}


TEST(prismLayerControls, unknownKeysAreRefused)
{
    expectWords
    (
        errorOf(surface + layers + "feild {}"),
        {"Unknown key feild", "did you mean field?", "backgroundMesh"}
    );
    expectWords
    (
        errorOfLayers("nSurfacelayer 3;"),
        {"Unknown key nSurfacelayer", "did you mean nSurfaceLayers?"}
    );
    expectWords
    (
        errorOfLayers("patches { wing { maxStretch 2; } }"),
        {"Unknown key maxStretch", "in wing", "firstLayerThickness"}
    );
    expectWords
    (
        errorOf(surface + layers + "field { anisotropicCoefs {} }"),
        {"did you mean anisotropicCoeffs?"}
    );
}


TEST(prismLayerControls, unknownModelsAreRefused)
{
    expectWords
    (
        errorOf(surface + layers + "field { tensor standard; }"),
        {"tensor is standard", "anisotropic", "isotropic"}
    );
    expectWords
    (
        errorOf(surface + layers + "field { solver direct; }"),
        {"solver is direct", "krylov, iteration"}
    );
    expectWords
    (
        errorOf(surface + layers + "farField { type snappy; }"),
        {"type is snappy", "not available", "Valid values: none, tet"}
    );
}


TEST(prismLayerControls, valueInPlaceOfADictionaryIsRefused)
{
    expectWords(errorOf("surface 5;" + layers), {"surface", "dictionary"});
    expectWords
    (
        errorOf(surface + layers + "field 5;"),
        {"field", "must be a dictionary"}
    );
    expectWords
    (
        errorOfLayers("patches { wing 5; }"),
        {"wing", "must be a dictionary"}
    );
}


// ************************************************************************* //
