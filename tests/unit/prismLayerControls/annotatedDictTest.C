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


static std::string textOf(const std::string& name)
{
    IFstream is(getEnv("HARMONIC_PRISM_MESH")/name);
    std::ostringstream text;
    text << is.stdStream().rdbuf();

    return text.str();
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


TEST(annotatedDict, hasEveryKeyAndRange)
{
    const std::string text
    (
        textOf("etc/caseDicts/annotated/harmonicPrismMeshDict")
    );
    const auto has = [&](const std::string& part)
    {
        return text.find(part) != std::string::npos;
    };
    for (const entryText& e : prismLayerEntries())
    {
        const std::string key(e.name.substr(e.name.rfind('.') + 1));
        // The Laplace equation has no coefficients
        EXPECT_TRUE
        (
            key == "isotropicCoeffs" || has(' ' + key) || has('\n' + key)
         || has("//" + key)
        ) << e.name;
        if (e.range[0] == '[')
        {
            // Words may follow
            const std::string range(e.range.substr(0, e.range.find(']') + 1));
            EXPECT_TRUE(has(range)) << e.name << " in " << range;
        }
    }
}


TEST(annotatedDict, tableOfThePageHasAllEntries)
{
    std::ostringstream table;
    for (const entryText& e : prismLayerEntries())
    {
        table << "| `" << e.name << "` | " << e.standard << " | " << e.range
            << " | " << e.text << " |\n";
    }
    EXPECT_NE(textOf("doc/dictionary.md").find(table.str()), std::string::npos)
        << "The table of doc/dictionary.md must be\n" << table.str();
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
