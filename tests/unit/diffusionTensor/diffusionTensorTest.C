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
    EXPECT_TRUE(contains(message, "anisotropic, gradientPower, isotropic"));
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


TEST(diffusionTensor, tensorsArePositiveDefinite)
{
    for (const word model : {"isotropic", "anisotropic", "gradientPower"})
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


TEST(anisotropicTensor, extremesStayFinite)
{
    for (const scalar beta : {-4.0, -1.0, 0.0})
    {
        for (const scalar delta : {0.05, 100.0})
        {
            const dictionary dict(coeffs(beta, delta));

            for (const scalar w : weightsOf(shell(), "anisotropic", dict))
            {
                EXPECT_TRUE(std::isfinite(w));
            }
        }
    }
}


TEST(anisotropicTensor, noFactorIsTheIsotropicField)
{
    const scalarField standard(cotangentWeights(shell().mesh));
    const scalarField weights
    (
        weightsOf(shell(), "anisotropic", coeffs(0, 0.3))
    );

    EXPECT_LT(max(mag(weights - standard)), 1e-12*max(standard));
}


TEST(anisotropicTensor, equalsTheTensorOfEdgesInAllDirections)
{
    // Of a field with a known slope: the sum of eq. 11 over many directions,
    // which is diagonal
    solved steep(shell());
    steep.mesh.gaps = 1;
    const scalar delta = 0.3, maxSlope = 1;
    const label n = 400;

    const auto sumOfDirections = [&](const scalar slope)
    {
        vector sum(Zero);
        for (label i = 0; i < n; ++i)
        {
            // The mean of u u^T around the axis
            const scalar c = (i + 0.5)/n;
            sum += std::exp(slope*c)/n
               *vector(0.5*(1 - sqr(c)), 0.5*(1 - sqr(c)), sqr(c));
        }

        return sum;
    };
    const scalar flat = sumOfDirections(1).z();

    for (const scalar slope : {0.001, 0.05, 0.5, 1.0, 2.0})
    {
        steep.field = steep.mesh.points & vector(0, 0, slope);
        const symmTensor K
        (
            tensorsOf(steep, "anisotropic", coeffs(-1, delta))[0]
        );
        const vector T(sumOfDirections(min(slope, maxSlope)));

        EXPECT_NEAR(K.xx()/std::exp(2*(T.x() - flat)/delta), 1, 1e-3);
        EXPECT_NEAR(K.yy()/std::exp(2*(T.y() - flat)/delta), 1, 1e-3);
        EXPECT_NEAR(K.zz()/std::exp(2*(T.z() - flat)/delta), 1, 1e-3);
        EXPECT_NEAR(mag(K.xy()) + mag(K.xz()) + mag(K.yz()), 0, 1e-12);
    }
}


TEST(anisotropicTensor, conductsMostAlongTheSlope)
{
    const symmTensorField tensors(tensorsOf(shell(), "anisotropic"));
    const backgroundMesh& mesh = shell().mesh;

    for (label p = 0; p < mesh.nWallPoints; ++p)
    {
        const vector n(normalised(mesh.points[p]));
        EXPECT_GT(n & tensors[p] & n, tr(tensors[p])/3);
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
