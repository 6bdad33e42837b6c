/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "backgroundMesh.H"
#include "diffusionTensor.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "prismLayerControls.H"
#include "readLayerThickness.H"
#include "thrownMessage.H"

#include <sstream>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const std::string surface("surface { file \"body.obj\"; }\n");
static const std::string layers
(
    "layers { nSurfaceLayers 20; firstLayerThickness 1e-4; }\n"
);


static prismLayerControls read(const std::string& text)
{
    return readPrismLayerControls(dictionaryOf(text));
}


static std::string errorOf(const std::string& text)
{
    return thrownMessage([&]() { read(text); });
}


//- Of layers with one more entry
static std::string errorOfLayers(const std::string& entry)
{
    return errorOf
    (
        surface
      + "layers { nSurfaceLayers 20; firstLayerThickness 1e-4; " + entry
      + " }"
    );
}


static dictionary annotated()
{
    return dictionary
    (
        IFstream
        (
            getEnv("HARMONIC_PRISM_MESH")
           /"etc/caseDicts/annotated/harmonicPrismMeshDict"
        )()
    );
}


//- What the anisotropic model makes of a tetrahedron
static scalarField weightsOf(const dictionary& coeffs)
{
    backgroundMesh mesh;
    mesh.points = pointField
    ({
        point(0, 0, 0), point(1, 0, 0), point(0, 2, 0), point(0, 0, 3)
    });
    mesh.tets = List<tetCell>(1, tetCell(0, 1, 2, 3));
    mesh.gaps = scalarField(4, 2.0);
    setAddressing(mesh);

    const auto model = diffusionTensor::New("anisotropic", coeffs);
    const scalarField field({1, 0.9, 0.2, 0});

    return model->edgeWeights(mesh, model->tensors(mesh, field));
}


static void expectEqual
(
    const prismLayerControls& a,
    const prismLayerControls& b
)
{
    EXPECT_EQ(a.surface.file, b.surface.file);
    EXPECT_EQ(a.surface.fluidOutside, b.surface.fluidOutside);
    EXPECT_EQ(a.surface.scale, b.surface.scale);
    EXPECT_EQ(a.surface.mergeTolerance, b.surface.mergeTolerance);
    EXPECT_EQ(a.layers.nSurfaceLayers, b.layers.nSurfaceLayers);
    EXPECT_EQ
    (
        a.layers.thickness.firstLayerThickness,
        b.layers.thickness.firstLayerThickness
    );
    EXPECT_EQ
    (
        a.layers.thickness.expansionRatio,
        b.layers.thickness.expansionRatio
    );
    EXPECT_EQ(a.layers.patches.size(), b.layers.patches.size());
    EXPECT_EQ(a.layers.maxStretch, b.layers.maxStretch);
    EXPECT_EQ(a.envelope.scale, b.envelope.scale);
    EXPECT_EQ
    (
        a.backgroundMesh.radiusEdgeRatio,
        b.backgroundMesh.radiusEdgeRatio
    );
    EXPECT_EQ(a.field.tensor, b.field.tensor);
    EXPECT_EQ(a.field.solver, b.field.solver);
    EXPECT_EQ(a.field.tolerance, b.field.tolerance);
    EXPECT_EQ(a.farFieldType, b.farFieldType);
}

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(prismLayerControls, minimalDictionaryHasTheDefaults)
{
    prismLayerControls defaults;
    defaults.surface.file = "body.obj";
    defaults.layers.nSurfaceLayers = 20;
    defaults.layers.thickness.firstLayerThickness = 1e-4;

    expectEqual(read(surface + layers), defaults);
}


TEST(prismLayerControls, annotatedDictionaryHasTheDefaults)
{
    expectEqual(readPrismLayerControls(annotated()), read(surface + layers));
}


TEST(prismLayerControls, annotatedDictionaryHasEveryKey)
{
    // The reader lists its keys where it meets an unknown one
    IFstream is
    (
        getEnv("HARMONIC_PRISM_MESH")
       /"etc/caseDicts/annotated/harmonicPrismMeshDict"
    );
    std::string text, line;
    while (std::getline(is.stdStream(), line))
    {
        text += line + '\n';
    }

    const auto keysOf = [](const std::string& message)
    {
        const std::string before("Valid keys: ");
        const auto start = message.find(before);
        EXPECT_NE(start, std::string::npos) << message;

        wordList keys;
        std::istringstream list(message.substr(start + before.size()));
        for (std::string key; list >> key; )
        {
            keys.append(word::validate(key.substr(0, key.find(','))));
        }

        return keys;
    };

    const std::string other("zzz 1;");
    const std::string yPlus
    (
        "layers { nSurfaceLayers 1; yPlus { " + other + " } }"
    );

    for
    (
        const std::string& wrong :
        {
            other,
            "surface { " + other + " }",
            surface + "layers { " + other + " }",
            surface + yPlus,
            surface + layers + "envelope { " + other + " }",
            surface + layers + "backgroundMesh { " + other + " }",
            surface + layers + "field { " + other + " }",
            surface + layers
          + "field { anisotropicCoeffs { " + other + " } }",
            surface + layers + "farField { " + other + " }"
        }
    )
    {
        for (const word& key : keysOf(errorOf(wrong)))
        {
            // The Laplace equation has no coefficients
            if (key != "isotropicCoeffs")
            {
                EXPECT_TRUE
                (
                    text.find(' ' + key) != std::string::npos
                 || text.find('\n' + key) != std::string::npos
                 || text.find("//" + key) != std::string::npos
                ) << key;
            }
        }
    }
}


TEST(prismLayerControls, annotatedCoefficientsAreTheDefaults)
{
    const dictionary coeffs
    (
        annotated().subDict("field").subDict("anisotropicCoeffs")
    );
    EXPECT_EQ(weightsOf(coeffs), weightsOf(dictionary()));

    // Each of them counts
    for (const word& key : {"beta", "delta"})
    {
        dictionary other(coeffs);
        other.set(key, 0.5*coeffs.get<scalar>(key));
        EXPECT_NE(weightsOf(other), weightsOf(coeffs));
    }
}


TEST(prismLayerControls, everyEntryIsRead)
{
    const prismLayerControls controls
    (
        read
        (
            "FoamFile { version 2.0; format ascii; class dictionary;"
            " object harmonicPrismMeshDict; }"
            "surface { file a.stl; fluid inside; scale 0.001;"
            " mergeTolerance 1e-6; }"
            "layers { nSurfaceLayers 5; thickness 31; expansionRatio 2;"
            " maxStretch 3; patches { \"wing.*\" { expansionRatio 1; }"
            " tail { nSurfaceLayers 5; } } }"
            "envelope { scale 1.5; }"
            "backgroundMesh { radiusEdgeRatio 2; }"
            "field { tensor isotropic; solver iteration; tolerance 1e-8;"
            " isotropicCoeffs {} anisotropicCoeffs { beta -2; } }"
            "farField { type none; }"
        )
    );

    EXPECT_EQ(controls.surface.file, "a.stl");
    EXPECT_FALSE(controls.surface.fluidOutside);
    EXPECT_EQ(controls.surface.scale, 0.001);
    EXPECT_EQ(controls.surface.mergeTolerance, 1e-6);
    EXPECT_EQ(controls.layers.nSurfaceLayers, 5);
    EXPECT_NEAR(controls.layers.thickness.firstLayerThickness, 1, 1e-12);
    EXPECT_EQ(controls.layers.thickness.expansionRatio, 2);
    EXPECT_EQ(controls.layers.maxStretch, 3);
    EXPECT_EQ(controls.envelope.scale, 1.5);
    EXPECT_EQ(controls.backgroundMesh.radiusEdgeRatio, 2);
    EXPECT_EQ(controls.field.tensor, "isotropic");
    EXPECT_EQ(controls.field.solver, "iteration");
    EXPECT_EQ(controls.field.tolerance, 1e-8);

    ASSERT_EQ(controls.layers.patches.size(), 2);
    EXPECT_TRUE(controls.layers.patches[0].patches.isPattern());
    EXPECT_TRUE(controls.layers.patches[0].patches.match("wingLeft"));
    EXPECT_EQ(controls.layers.patches[0].thickness.expansionRatio, 1);
    EXPECT_EQ(controls.layers.patches[1].patches, "tail");
    EXPECT_EQ(controls.layers.patches[1].thickness.expansionRatio, 2);
}


TEST(prismLayerControls, coefficientsOfTheTensorAreKept)
{
    const prismLayerControls controls
    (
        read
        (
            surface + layers
          + "field { anisotropicCoeffs { beta -2; delta 1; } }"
        )
    );

    EXPECT_EQ(controls.field.tensorCoeffs.get<scalar>("beta"), -2);
    EXPECT_EQ(controls.field.tensorCoeffs.get<scalar>("delta"), 1);
}


TEST(prismLayerControls, coefficientsAreChecked)
{
    expectWords
    (
        errorOf
        (
            surface + layers + "field { anisotropicCoeffs { beta 1; } }"
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
        {"fluid is around", "outside, inside"}
    );
    expectWords(errorOfLayers("maxStretch 0.5;"), {"maxStretch is 0.5"});
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
        errorOf(surface + layers + "farField { type tet; }"),
        {"type is tet", "not available", "Valid values: none"}
    );
}


TEST(prismLayerControls, numbersOfLayersDoNotDifferBetweenPatches)
{
    expectWords
    (
        errorOfLayers("patches { symmetry { nSurfaceLayers 0; } }"),
        {"symmetry", "nSurfaceLayers", "is 0", "not available yet", "20"}
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
