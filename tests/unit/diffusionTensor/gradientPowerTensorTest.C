/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tensorsOnShell.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(gradientPowerTensor, powerIsBounded)
{
    for (const scalar q : {-0.1, 10.1})
    {
        dictionary dict;
        dict.add("q", q);
        EXPECT_TRUE(contains(messageOf("gradientPower", dict), "q"));
    }
}


TEST(gradientPowerTensor, zeroIsTheIsotropicField)
{
    dictionary dict;
    dict.add("q", 0);
    const scalarField standard(cotangentWeights(shell().mesh));
    const scalarField weights(weightsOf(shell(), "gradientPower", dict));

    forAll(weights, e)
    {
        EXPECT_NEAR(weights[e], max(standard[e], 0.0), 1e-12);
    }
}


TEST(gradientPowerTensor, conductsMoreWhereTheFieldIsSteep)
{
    // Between spheres that is at the inner one, as 1/r^2
    const backgroundMesh& mesh = shell().mesh;
    const symmTensorField tensors(tensorsOf(shell(), "gradientPower"));
    scalar inner = GREAT, outer = 0;

    forAll(tensors, v)
    {
        if (mag(mesh.points[v]) < 1.05)
        {
            inner = min(inner, tr(tensors[v]));
        }
        else if (mag(mesh.points[v]) > 1.45)
        {
            outer = max(outer, tr(tensors[v]));
        }
    }

    EXPECT_GT(inner, outer);
}


TEST(gradientPowerTensor, oneMakesLevelSetsOfASphereEquidistant)
{
    // H where the radius is 3/2, between spheres of 1 and 2: 1/3 of the
    // harmonic field, 1/2 of the distance
    const backgroundMesh mesh(testSurfaces::shellMesh(12, 1, 2));
    const scalarField isotropic
    (
        makeHarmonicField(mesh, cotangentWeights(mesh), fieldControls())
    );
    dictionary dict;
    dict.add("q", 1);
    const auto model(diffusionTensor::New("gradientPower", dict));
    const scalarField field
    (
        makeHarmonicField
        (
            mesh,
            model->edgeWeights(mesh, model->tensors(mesh, isotropic)),
            fieldControls()
        )
    );

    scalar sum = 0, sumIsotropic = 0;
    label n = 0;
    forAll(field, v)
    {
        if (mesh.free[v] && mag(mag(mesh.points[v]) - 1.5) < 0.01)
        {
            sum += field[v];
            sumIsotropic += isotropic[v];
            ++n;
        }
    }
    ASSERT_GT(n, 0);
    EXPECT_NEAR(sumIsotropic/n, 1.0/3, 0.01);
    EXPECT_NEAR(sum/n, 0.5, 0.04);
}


// ************************************************************************* //
