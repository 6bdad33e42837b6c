/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "criticalPoints.H"
#include "harmonicField.H"
#include "testStages.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using testSurfaces::shellMesh;
using testSurfaces::tubeMesh;

static scalarField solvedField
(
    const backgroundMesh& mesh,
    const scalarField& weights
)
{
    fieldControls controls;
    controls.tolerance = 1e-12;

    return makeHarmonicField(mesh, weights, controls);
}


//- Root mean square difference from the exact field between spheres of radius
//  1 and 2
static scalar shellError(const label n)
{
    const backgroundMesh mesh(shellMesh(n, 1, 2));
    const scalarField field(solvedField(mesh, cotangentWeights(mesh)));
    scalar sumSqr = 0;
    label nFree = 0;

    forAll(field, p)
    {
        if (mesh.free[p])
        {
            sumSqr += sqr(field[p] - (2/mag(mesh.points[p]) - 1));
            ++nFree;
        }
    }

    return Foam::sqrt(sumSqr/nFree);
}


//- The same between cylinders, of radius 1 and 2
static scalar tubeError(const label n)
{
    const backgroundMesh mesh(tubeMesh(n, 1, 2));
    const scalarField field(solvedField(mesh, cotangentWeights(mesh)));
    scalar sumSqr = 0;
    label nFree = 0;

    forAll(field, p)
    {
        if (mesh.free[p])
        {
            const point& x = mesh.points[p];
            const scalar radius = std::hypot(x.x(), x.y());
            sumSqr += sqr(field[p] - (1 - std::log(radius)/std::log(2.0)));
            ++nFree;
        }
    }

    return Foam::sqrt(sumSqr/nFree);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(closedForms, betweenSpheresConvergesInSecondOrder)
{
    const scalar coarse = shellError(8);
    const scalar fine = shellError(16);

    EXPECT_LT(fine, 0.01);

    // 4 in the limit
    EXPECT_GT(coarse/fine, 3);
}


TEST(closedForms, betweenCylindersConvergesInSecondOrder)
{
    const scalar coarse = tubeError(4);
    const scalar fine = tubeError(8);

    EXPECT_LT(fine, 0.002);
    EXPECT_GT(std::log2(coarse/fine), 1.8);
}


TEST(closedForms, isotropicHasNoCriticalPointBetweenCylinders)
{
    const backgroundMesh mesh(tubeMesh(6, 1, 2));
    const scalarField weights(cotangentWeights(mesh));

    // Few and small: the principle needs none that is negative
    EXPECT_GT(min(weights), -0.1*max(weights));

    const scalarField field(solvedField(mesh, weights));
    EXPECT_TRUE(findCriticalPoints(mesh, field).none());
    EXPECT_GE(min(field), 0);
    EXPECT_LE(max(field), 1);
}


// ************************************************************************* //
