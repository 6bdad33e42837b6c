/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "scaledJacobian.H"
#include "testLayers.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- One layer on a regular triangle, sheared so that its scaled Jacobian is that
//  of the triangle times cosine
static prismLayers sheared(const scalar cosine)
{
    prismLayers layers(testSurfaces::onePolygon(3, {0, 1}));
    const vector side(::sqrt(1 - sqr(cosine)), 0, cosine);

    for (label c = 0; c < 3; ++c)
    {
        layers.points[layers.index(c, 1)] = layers(c, 0) + side;
    }

    return layers;
}


//- sin(60 degrees)
static const scalar ofTriangle = 0.5*::sqrt(3.0);


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(worstJacobian, equalsTheFormulaOfAShear)
{
    for (const scalar cosine : {1.0, 0.5, 0.1, -0.3})
    {
        EXPECT_NEAR
        (
            worstJacobian(sheared(cosine), 0), ofTriangle*cosine, 1e-12
        );
    }
}


TEST(attainableJacobians, equalThoseOfUprightColumns)
{
    const layerFront front(testSurfaces::frontOf(testSurfaces::cube(2), 0));
    const prismLayers low(testSurfaces::frontLayers(front, {0, 1e-6}));
    const scalarField attainable
    (
        attainableJacobians(front.surface, front.visibility)
    );

    forAll(attainable, facei)
    {
        EXPECT_NEAR(worstJacobian(low, facei), attainable[facei], 1e-5);
    }
}


TEST(jacobianPenalty, equalsTheFormula)
{
    for (const scalar cosine : {1.0, 0.5, 0.1, -0.3, -1.0})
    {
        for (const scalar good : {0.2, 0.8})
        {
            const scalar s = ofTriangle*cosine/good;

            EXPECT_NEAR
            (
                jacobianPenalty(sheared(cosine), 0, good),
                s >= 1 ? 0 : s >= 0 ? 1 - s : 1 - s/(1 - s),
                1e-11
            );
        }
    }
}


TEST(jacobianPenalty, isBelowTwo)
{
    EXPECT_LT(jacobianPenalty(sheared(-1), 0, 1e-3), 2);
}


TEST(jacobianPenalty, isMoreThanEnoughOrExact)
{
    for (const scalar cosine : {0.9, 0.5, 0.1, -0.3})
    {
        const scalar exact = jacobianPenalty(sheared(cosine), 0, 0.8);

        for (const scalar enough : {0.01, 0.3, 0.9, 1.2, 1.9})
        {
            const scalar penalty =
                jacobianPenalty(sheared(cosine), 0, 0.8, enough);

            if (exact > enough)
            {
                EXPECT_GT(penalty, enough*(1 - 1e-12));
            }
            else
            {
                EXPECT_EQ(penalty, exact);
            }
        }
    }
}


TEST(jacobianPenalty, looksAtTheLayersFromTheLowestUp)
{
    prismLayers layers(testSurfaces::onePolygon(3, {0, 1, 2}));
    for (label c = 0; c < 3; ++c)
    {
        layers.points[layers.index(c, 1)] += vector(3, 0, 0);
        layers.points[layers.index(c, 2)] += vector(3, 0, 0);
    }

    EXPECT_GT(jacobianPenalty(layers, 0, 0.8, GREAT, 1), 0.3);
    EXPECT_EQ(jacobianPenalty(layers, 0, 0.8, GREAT, 2), 0);
}


TEST(jacobianViolation, countsTheSixCornersOfAPrism)
{
    for (const scalar cosine : {1.0, 0.5, 0.1, -0.3})
    {
        for (const scalar target : {0.2, 0.8})
        {
            const prismLayers layers(sheared(cosine));

            EXPECT_NEAR
            (
                jacobianViolation(layers, layers.faces[0], 1, target),
                ::sqrt(6.0)*max(target - ofTriangle*cosine, 0.0),
                1e-12
            );
        }
    }
}


// ************************************************************************* //
