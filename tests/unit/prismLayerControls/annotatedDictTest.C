/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "backgroundMesh.H"
#include "diffusionTensor.H"
#include "IFstream.H"
#include "minimalControls.H"
#include "OSspecific.H"

#include <sstream>
#include <vector>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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
static symmTensorField tensorsOf(const dictionary& coeffs)
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

    return model->tensors(mesh, field);
}


//- Dictionaries of which each has a sub-dictionary with an unknown key
static std::vector<std::string> withUnknownKeys()
{
    const std::string other("zzz 1;");
    const auto inLayers = [](const std::string& entries)
    {
        return "layers { nSurfaceLayers 1; thickness 1; " + entries + " }";
    };
    const std::string yPlus
    (
        "layers { nSurfaceLayers 1; yPlus { " + other + " } }"
    );

    return
    {
        other,
        "surface { " + other + " }",
        "surface { file a; sidePlanes { ground { " + other + " } } }",
        "surface { file a; patches { inlet { " + other + " } } }",
        surface + "layers { " + other + " }",
        surface + yPlus,
        surface + "layers { nSurfaceLayers 1; yPlus { from { " + other
      + " } } }",
        surface + inLayers("patches { wing { " + other + " } }"),
        surface
      + inLayers("regions { wake { geometry {} " + other + " } }"),
        surface + inLayers("fields { " + other + " }"),
        surface + inLayers("fields { thickness { " + other + " } }"),
        "surface { file a; remesh { " + other + " } }",
        "surface { file a; remesh { patches { wing { " + other + " } } } }",
        "surface { file a; remesh { regions { nose { geometry {} " + other
      + " } } } }",
        "surface { file a; remesh { sharpEdges { " + other + " } } }",
        surface + layers + "envelope { " + other + " }",
        surface + layers + "backgroundMesh { " + other + " }",
        surface + layers + "field { " + other + " }",
        surface + layers
      + "field { tensor anisotropic; anisotropicCoeffs { " + other + " } }",
        surface + layers + "farField { " + other + " }",
        surface + layers
      + "farField { boundary { type box; " + other + " } }",
        surface + layers
      + "farField { boundary { type sphere; origin (0 0 0); radius 1;"
        " patches { inlet { " + other + " } } } }",
        surface + layers
      + "farField { regions { wake { geometry {} " + other + " } } }"
    };
}

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(annotatedDict, hasTheDefaults)
{
    expectEqual
    (
        readPrismLayerControls(annotated()),
        readControls(surface + layers)
    );
}


TEST(annotatedDict, hasEveryKey)
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

    for (const std::string& wrong : withUnknownKeys())
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


TEST(annotatedDict, coefficientsAreTheDefaults)
{
    const dictionary coeffs
    (
        annotated().subDict("field").subDict("anisotropicCoeffs")
    );
    EXPECT_EQ(tensorsOf(coeffs), tensorsOf(dictionary()));

    // Each of them counts
    for (const word key : {"beta", "delta"})
    {
        dictionary other(coeffs);
        other.set(key, 0.5*coeffs.get<scalar>(key));
        EXPECT_NE(tensorsOf(other), tensorsOf(coeffs));
    }
}


// ************************************************************************* //
