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
    for (const word key : {"qConcave", "qConvex", "tau"})
    {
        for (const scalar q : {-0.1, 10.1})
        {
            dictionary dict;
            dict.add(key, q);
            const string message(messageOf("gradientPower", dict));
            EXPECT_TRUE(contains(message, key.c_str()));
        }
    }
}


TEST(gradientPowerTensor, zeroIsTheIsotropicField)
{
    dictionary dict;
    dict.add("qConcave", 0);
    dict.add("qConvex", 0);
    dict.add("tau", 1);
    const scalarField standard(cotangentWeights(shell().mesh));
    const scalarField weights(weightsOf(shell(), "gradientPower", dict));

    EXPECT_LT(max(mag(weights - standard)), 1e-12*max(standard));
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


// ************************************************************************* //
