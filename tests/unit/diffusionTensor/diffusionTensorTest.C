/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "diffusionTensor.H"
#include "harmonicField.H"
#include "testStages.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- A mesh and the isotropic field on it
struct solved
{
    backgroundMesh mesh;
    scalarField field;
};


static const solved& shell()
{
    static const backgroundMesh mesh(testSurfaces::shellMesh(8, 1, 1.5));
    static const solved s
    {
        mesh,
        makeHarmonicField(mesh, cotangentWeights(mesh), fieldControls())
    };

    return s;
}


static dictionary coeffs(const scalar beta, const scalar delta)
{
    dictionary dict;
    dict.add("beta", beta);
    dict.add("delta", delta);

    return dict;
}


static symmTensorField tensorsOf
(
    const solved& s,
    const word& model,
    const dictionary& dict = dictionary()
)
{
    return diffusionTensor::New(model, dict)->tensors(s.mesh, s.field);
}


static scalarField weightsOf
(
    const solved& s,
    const word& model,
    const dictionary& dict = dictionary()
)
{
    const auto tensor(diffusionTensor::New(model, dict));

    return tensor->edgeWeights(s.mesh, tensor->tensors(s.mesh, s.field));
}


//- The message of the error that New gives
static string messageOf(const word& model, const dictionary& dict)
{
    try
    {
        diffusionTensor::New(model, dict);
    }
    catch (const Foam::IOerror& err)
    {
        return err.message();
    }

    return "none";
}


static bool contains(const string& text, const char* part)
{
    return text.find(part) != std::string::npos;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(diffusionTensor, unknownModelListsTheValidOnes)
{
    const string message(messageOf("anisotropik", dictionary()));

    EXPECT_TRUE(contains(message, "anisotropik"));
    EXPECT_TRUE(contains(message, "(anisotropic isotropic)"));
}


TEST(diffusionTensor, unknownCoefficientIsRefused)
{
    dictionary dict;
    dict.add("betta", -1);

    EXPECT_TRUE(contains(messageOf("anisotropic", dict), "betta"));
    EXPECT_TRUE(contains(messageOf("isotropic", dict), "betta"));
}


TEST(diffusionTensor, coefficientsAreBounded)
{
    EXPECT_TRUE(contains(messageOf("anisotropic", coeffs(1, 0.3)), "beta"));
    EXPECT_TRUE(contains(messageOf("anisotropic", coeffs(-5, 0.3)), "beta"));
    EXPECT_TRUE(contains(messageOf("anisotropic", coeffs(-1, 0)), "delta"));
    EXPECT_TRUE(contains(messageOf("anisotropic", coeffs(-1, 1e9)), "delta"));
    EXPECT_EQ(messageOf("anisotropic", coeffs(-4, 0.05)), "none");
    EXPECT_EQ(messageOf("anisotropic", coeffs(0, 100)), "none");
}


TEST(diffusionTensor, tensorsHaveTraceOne)
{
    for (const word model : {"isotropic", "anisotropic"})
    {
        for (const symmTensor& t : tensorsOf(shell(), model))
        {
            EXPECT_NEAR(tr(t), 1, 1e-12);
        }
    }
}


TEST(diffusionTensor, tensorsArePositiveDefinite)
{
    for (const word model : {"isotropic", "anisotropic"})
    {
        for (const symmTensor& t : tensorsOf(shell(), model))
        {
            // Leading minors
            EXPECT_GT(t.xx(), 0);
            EXPECT_GT(t.xx()*t.yy() - sqr(t.xy()), 0);
            EXPECT_GT(det(t), 0);
        }
    }
}


TEST(isotropicTensor, weightsAreTheCotangents)
{
    EXPECT_EQ
    (
        weightsOf(shell(), "isotropic"), cotangentWeights(shell().mesh)
    );
}


TEST(anisotropicTensor, weightsArePositiveAndBounded)
{
    // The eigenvalues of two tensors of trace 1 are at most 2
    for (const scalar w : weightsOf(shell(), "anisotropic", coeffs(-1, 0.3)))
    {
        EXPECT_GE(w, 1);
        EXPECT_LE(w, std::exp(2/0.3));
    }
}


TEST(anisotropicTensor, extremesStayFinite)
{
    for (const scalar beta : {-4.0, -3.0, 0.0})
    {
        for (const scalar delta : {0.05, 100.0})
        {
            const dictionary dict(coeffs(beta, delta));

            for (const symmTensor& t : tensorsOf(shell(), "anisotropic", dict))
            {
                EXPECT_NEAR(tr(t), 1, 1e-12);
            }
            for (const scalar w : weightsOf(shell(), "anisotropic", dict))
            {
                EXPECT_GE(w, 1 - 1e-12);
                EXPECT_LE(w, std::exp(2/delta)*(1 + 1e-12));
            }
        }
    }
}


TEST(anisotropicTensor, largeDeltaMakesWeightsEqual)
{
    for (const scalar w : weightsOf(shell(), "anisotropic", coeffs(-1, 100)))
    {
        EXPECT_NEAR(w, 1, std::exp(0.02) - 1);
    }
}


TEST(anisotropicTensor, diffusesMostAcrossTheSlope)
{
    // lambda is largest for edges along which the field does not change
    const symmTensorField tensors(tensorsOf(shell(), "anisotropic"));
    const backgroundMesh& mesh = shell().mesh;

    for (label p = 0; p < mesh.nWallPoints; ++p)
    {
        const vector n(normalised(mesh.points[p]));
        EXPECT_LT(n & tensors[p] & n, 1.0/3);
    }
}


TEST(anisotropicTensor, sizeOfTheMeshDoesNotMatter)
{
    solved large(shell());
    large.mesh.points *= 1e3;
    large.mesh.gaps *= 1e3;

    EXPECT_LT
    (
        max
        (
            mag
            (
                tensorsOf(large, "anisotropic")
              - tensorsOf(shell(), "anisotropic")
            )
        ),
        1e-10
    );
    EXPECT_LT
    (
        max
        (
            mag
            (
                weightsOf(large, "anisotropic")
               /weightsOf(shell(), "anisotropic") - 1
            )
        ),
        1e-10
    );
}


TEST(anisotropicTensor, turnsWithTheMesh)
{
    const tensor R(testSurfaces::rotation());
    solved turned(shell());
    for (point& x : turned.mesh.points)
    {
        x = R & x;
    }

    const symmTensorField before(tensorsOf(shell(), "anisotropic"));
    const symmTensorField after(tensorsOf(turned, "anisotropic"));

    forAll(before, p)
    {
        EXPECT_NEAR
        (
            mag((R & tensor(before[p]) & R.T()) - tensor(after[p])), 0, 1e-10
        );
    }
    EXPECT_LT
    (
        max
        (
            mag
            (
                weightsOf(turned, "anisotropic")
               /weightsOf(shell(), "anisotropic") - 1
            )
        ),
        1e-9
    );
}


// ************************************************************************* //
