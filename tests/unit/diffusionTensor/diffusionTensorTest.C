/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tensorsOnShell.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(diffusionTensor, unknownModelListsTheValidOnes)
{
    const string message(messageOf("anisotropik", dictionary()));

    EXPECT_TRUE(contains(message, "anisotropik"));
    EXPECT_TRUE(contains(message, "(anisotropic gradientPower isotropic)"));
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
    EXPECT_EQ(weightsOf(shell(), "isotropic"), cotangentWeights(shell().mesh));
}


TEST(anisotropicTensor, weightsArePositiveAndBounded)
{
    // The eigenvalues of two tensors of trace 1 are at most 2
    const scalarField standard(cotangentWeights(shell().mesh));
    const scalarField weights
    (
        weightsOf(shell(), "anisotropic", coeffs(-1, 0.3))
    );

    forAll(weights, e)
    {
        EXPECT_GE(weights[e], max(standard[e], 0.0));
        EXPECT_LE(weights[e], std::exp(2/0.3)*max(standard[e], 0.0));
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
                EXPECT_TRUE(std::isfinite(w) && w >= 0);
            }
        }
    }
}


TEST(anisotropicTensor, largeDeltaLeavesTheStandardWeights)
{
    const scalarField standard(cotangentWeights(shell().mesh));
    const scalarField weights
    (
        weightsOf(shell(), "anisotropic", coeffs(-1, 100))
    );

    forAll(weights, e)
    {
        EXPECT_NEAR(weights[e], max(standard[e], 0.0), 0.03*mag(standard[e]));
    }
}


TEST(anisotropicTensor, isThatOfEdgesInAllDirections)
{
    // Of a field with a known slope: the sum of eq. 11 over many directions
    solved steep(shell());
    steep.mesh.gaps = 1;
    for (const scalar slope : {0.05, 0.5, 1.0, 2.0})
    {
        steep.field = slope*(steep.mesh.points & vector(0, 0, 1));
        const symmTensor t(tensorsOf(steep, "anisotropic")[0]);

        symmTensor sum(Zero);
        const label n = 400;
        for (label i = 0; i < n; ++i)
        {
            const scalar c = (i + 0.5)/n;
            const scalar weight =
                std::exp(1/max(slope*c, 0.1) - 10);

            // The mean of u u^T around the axis
            sum += weight*symmTensor
            (
                0.5*(1 - sqr(c)), 0, 0, 0.5*(1 - sqr(c)), 0, sqr(c)
            );
        }
        sum /= tr(sum);

        EXPECT_NEAR(mag(t - sum), 0, 2e-3);
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
              - 1e3*weightsOf(shell(), "anisotropic")
            )
        ),
        1e-6*max(weightsOf(shell(), "anisotropic"))
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
              - weightsOf(shell(), "anisotropic")
            )
        ),
        1e-9*max(weightsOf(shell(), "anisotropic"))
    );
}


// ************************************************************************* //
