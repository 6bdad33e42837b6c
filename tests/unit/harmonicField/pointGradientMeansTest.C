/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "harmonicField.H"
#include "testStages.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using testSurfaces::cubeMesh;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(pointGradientMeans, sizesAreThoseOfTheGradientsWhereTheyAgree)
{
    const backgroundMesh mesh(cubeMesh(5));
    const scalarField field(mesh.points & vector(2, -3, 0.7));
    const gradientMeans means(pointGradientMeans(mesh, field));

    forAll(means.sizes, p)
    {
        EXPECT_NEAR(means.sizes[p], mag(vector(2, -3, 0.7)), 1e-9);
        EXPECT_NEAR(mag(means.gradients[p]), means.sizes[p], 1e-9);
    }
}


TEST(pointGradientMeans, gradientsCancelAtAFold)
{
    const backgroundMesh mesh(cubeMesh(5));
    scalarField field(mesh.points.size());
    forAll(field, p)
    {
        field[p] = mag(mesh.points[p].x() - 0.5);
    }
    const gradientMeans means(pointGradientMeans(mesh, field));
    const scalarField agreement(mag(means.gradients)/means.sizes);

    EXPECT_LE(max(agreement), 1 + 1e-9);
    EXPECT_LT(min(agreement), 0.5);

    forAll(agreement, p)
    {
        if (field[p] > 0.49)
        {
            EXPECT_NEAR(agreement[p], 1, 1e-9);
        }
    }
}


// ************************************************************************* //
