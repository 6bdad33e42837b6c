/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "harmonicField.H"
#include "Random.H"
#include "testStages.H"

#include <limits>

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using testSurfaces::cubeMesh;
using testSurfaces::shellMesh;

static const std::initializer_list<fieldSolver> solvers =
{
    fieldSolver::krylov, fieldSolver::iteration
};


static fieldControls controlsOf
(
    const fieldSolver solver,
    const scalar tolerance
)
{
    fieldControls controls;
    controls.solver = solver;
    controls.tolerance = tolerance;

    return controls;
}


static scalarField solve
(
    const backgroundMesh& mesh,
    const scalarField& weights,
    const scalar tolerance = 1e-12
)
{
    return makeHarmonicField
    (
        mesh, weights, controlsOf(fieldSolver::krylov, tolerance)
    );
}


static scalarField randomWeights(const backgroundMesh& mesh)
{
    Random random(13);
    scalarField weights(mesh.edges.size());

    for (scalar& w : weights)
    {
        w = std::exp(4*random.sample01<scalar>() - 2);
    }

    return weights;
}


//- Values between -1 and 1 at free points, 0 at the others
static scalarField perturbation(const backgroundMesh& mesh)
{
    Random random(14);
    scalarField values(mesh.points.size(), 0);

    forAll(values, p)
    {
        if (mesh.free[p])
        {
            values[p] = 2*random.sample01<scalar>() - 1;
        }
    }

    return values;
}


static scalarField linearField(const backgroundMesh& mesh)
{
    return (mesh.points & vector(2, -3, 0.7)) + 0.4;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(cotangentWeights, balanceALinearField)
{
    const backgroundMesh mesh(cubeMesh(5));
    const scalarField weights(cotangentWeights(mesh));
    const scalarField field(linearField(mesh));
    scalarField residual(mesh.points.size(), 0);
    scalarField scale(mesh.points.size(), 0);

    forAll(mesh.edges, e)
    {
        const label a = mesh.edges[e].start(), b = mesh.edges[e].end();
        residual[a] += weights[e]*(field[b] - field[a]);
        residual[b] += weights[e]*(field[a] - field[b]);
        scale[a] += mag(weights[e]);
        scale[b] += mag(weights[e]);
    }

    forAll(residual, p)
    {
        if (mesh.free[p])
        {
            EXPECT_NEAR(residual[p]/scale[p], 0, 1e-12);
        }
    }
}


TEST(cotangentWeights, energyIsThatOfTheGradient)
{
    // Over the unit cube it is the square of the slope
    const backgroundMesh mesh(cubeMesh(5));

    EXPECT_NEAR
    (
        harmonicEnergy(mesh, cotangentWeights(mesh), linearField(mesh)),
        magSqr(vector(2, -3, 0.7)),
        1e-10
    );
}


TEST(cotangentWeights, growWithTheSizeOfTheMesh)
{
    const backgroundMesh mesh(cubeMesh(3));
    backgroundMesh large(mesh);
    large.points *= 1e3;

    const scalarField weights(cotangentWeights(mesh));
    EXPECT_LT
    (
        max(mag(1e-3*cotangentWeights(large) - weights)), 1e-9*max(weights)
    );
}


TEST(makeHarmonicField, valuesOnTheBoundary)
{
    const backgroundMesh mesh(shellMesh(6, 1, 2));
    const scalarField field(solve(mesh, cotangentWeights(mesh)));

    forAll(field, p)
    {
        if (!mesh.free[p])
        {
            EXPECT_EQ(field[p], mesh.onWall(p) ? 1 : 0);
        }
    }
}


TEST(makeHarmonicField, noExtremumInside)
{
    const backgroundMesh mesh(shellMesh(8, 1, 2));
    const scalarField weights(randomWeights(mesh));

    for (const fieldSolver solver : solvers)
    {
        const scalarField field
        (
            makeHarmonicField(mesh, weights, controlsOf(solver, 1e-10))
        );

        forAll(field, p)
        {
            if (mesh.free[p])
            {
                EXPECT_GT(field[p], 0);
                EXPECT_LT(field[p], 1);
            }
        }
    }
}


TEST(makeHarmonicField, isTheMeanOfItsNeighbours)
{
    const backgroundMesh mesh(shellMesh(6, 1, 2));
    const scalarField weights(randomWeights(mesh));
    const scalarField field(solve(mesh, weights));
    scalarField sums(mesh.points.size(), 0), total(mesh.points.size(), 0);

    forAll(mesh.edges, e)
    {
        const label a = mesh.edges[e].start(), b = mesh.edges[e].end();
        sums[a] += weights[e]*field[b];
        sums[b] += weights[e]*field[a];
        total[a] += weights[e];
        total[b] += weights[e];
    }

    forAll(field, p)
    {
        if (mesh.free[p])
        {
            EXPECT_NEAR(field[p], sums[p]/total[p], 1e-10);
        }
    }
}


TEST(makeHarmonicField, solversAgree)
{
    const backgroundMesh mesh(shellMesh(6, 1, 2));
    const scalarField weights(randomWeights(mesh));

    // The energy has no linear term at its minimum: a change of 1e-16 of it
    // leaves the square root of that in the field
    const scalarField iterated
    (
        makeHarmonicField
        (
            mesh, weights, controlsOf(fieldSolver::iteration, 1e-16)
        )
    );

    EXPECT_LT(max(mag(iterated - solve(mesh, weights, 1e-14))), 1e-7);

    // Until it does not change at all
    const scalarField still
    (
        makeHarmonicField(mesh, weights, controlsOf(fieldSolver::iteration, 0))
    );

    EXPECT_LT(max(mag(still - solve(mesh, weights, 1e-14))), 1e-8);
}


TEST(makeHarmonicField, iterationLowersTheEnergy)
{
    // Each goes on from where the one before stopped
    const backgroundMesh mesh(shellMesh(6, 1, 2));
    const scalarField weights(randomWeights(mesh));
    const scalar least = harmonicEnergy(mesh, weights, solve(mesh, weights));
    scalar before = GREAT;

    for (const scalar tolerance : {0.3, 0.1, 0.03, 0.01, 1e-3, 1e-5, 1e-8})
    {
        const scalar energy = harmonicEnergy
        (
            mesh,
            weights,
            makeHarmonicField
            (
                mesh, weights, controlsOf(fieldSolver::iteration, tolerance)
            )
        );

        EXPECT_LT(energy, before);
        EXPECT_GE(energy, least*(1 - 1e-12));
        before = energy;
    }
}


TEST(makeHarmonicField, otherFieldsHaveMoreEnergy)
{
    // The excess is exactly the energy of the difference
    const backgroundMesh mesh(shellMesh(6, 1, 2));
    const scalarField weights(randomWeights(mesh));
    const scalarField field(solve(mesh, weights));
    const scalar energy = harmonicEnergy(mesh, weights, field);
    const scalarField change(perturbation(mesh));

    for (const scalar size : {1.0, 0.1, 0.01})
    {
        const scalar excess =
            harmonicEnergy(mesh, weights, field + size*change) - energy;

        EXPECT_GT(excess, 0);
        EXPECT_NEAR(excess/harmonicEnergy(mesh, weights, size*change), 1, 1e-6);
    }
}


TEST(makeHarmonicField, factorOnWeightsDoesNotMatter)
{
    const backgroundMesh mesh(shellMesh(6, 1, 2));
    const scalarField weights(randomWeights(mesh));

    EXPECT_LT(max(mag(solve(mesh, weights) - solve(mesh, 1e6*weights))), 1e-10);
}


TEST(makeMonotoneField, isTheHarmonicFieldIfThatHasNoExtrema)
{
    const backgroundMesh mesh(shellMesh(6, 1, 2));
    const scalarField weights(cotangentWeights(mesh));
    const fieldControls controls(controlsOf(fieldSolver::krylov, 1e-12));
    const monotoneField field(makeMonotoneField(mesh, weights, controls));

    ASSERT_LT(min(weights), 0);
    EXPECT_EQ(field.nClipped, 0);
    EXPECT_EQ(field.values, makeHarmonicField(mesh, weights, controls));
}


TEST(makeMonotoneField, extremaAreCured)
{
    // Much more conductivity across than along the normals: many weights are
    // negative, and the finite elements have extrema
    const backgroundMesh mesh(shellMesh(8, 1, 2));
    symmTensorField conductivities(mesh.tets.size());
    forAll(conductivities, t)
    {
        const vector axis(normalised(vector(1, 1, 1)));
        conductivities[t] = 0.001*symmTensor::I + sqr(axis);
    }
    const scalarField weights(conductivityWeights(mesh, conductivities));
    const fieldControls controls(controlsOf(fieldSolver::krylov, 1e-10));
    const scalarField before(makeHarmonicField(mesh, weights, controls));
    ASSERT_TRUE(min(before) < -1e-3 || max(before) > 1 + 1e-3);

    const monotoneField field(makeMonotoneField(mesh, weights, controls));

    EXPECT_GT(field.nClipped, 0);
    EXPECT_GT(min(field.values), -1e-9);
    EXPECT_LT(max(field.values), 1 + 1e-9);

    // Most of the negative weights stay
    label nNegative = 0;
    for (const scalar w : weights)
    {
        nNegative += w < 0;
    }
    EXPECT_LT(field.nClipped, nNegative);
}


TEST(makeHarmonicField, pointsWithoutTetsAreLeftAlone)
{
    backgroundMesh mesh(shellMesh(4, 1, 2));
    const scalarField weights(randomWeights(mesh));
    const scalarField field(solve(mesh, weights));

    backgroundMesh more(mesh);
    more.points.append(point(Zero));
    more.gaps.append(1);
    more.free.append(true);

    for (const fieldSolver solver : solvers)
    {
        const scalarField other
        (
            makeHarmonicField(more, weights, controlsOf(solver, 1e-14))
        );

        forAll(field, p)
        {
            EXPECT_NEAR(other[p], field[p], 1e-6);
        }
        EXPECT_TRUE(other.last() >= 0 && other.last() <= 1);
    }
}


TEST(makeHarmonicField, noConvergenceIsAnError)
{
    const backgroundMesh mesh(shellMesh(4, 1, 2));
    scalarField weights(randomWeights(mesh));
    weights = std::numeric_limits<scalar>::quiet_NaN();

    EXPECT_THROW(solve(mesh, weights), Foam::error);
}


TEST(tetGradients, ofALinearField)
{
    const backgroundMesh mesh(cubeMesh(5));

    for (const vector& g : tetGradients(mesh, linearField(mesh)))
    {
        // Rounding over the height of the flattest tetrahedron
        EXPECT_NEAR(mag(g - vector(2, -3, 0.7)), 0, 1e-9);
    }
}


TEST(pointGradients, ofALinearField)
{
    const backgroundMesh mesh(cubeMesh(5));

    for (const vector& g : pointGradients(mesh, linearField(mesh)))
    {
        EXPECT_NEAR(mag(g - vector(2, -3, 0.7)), 0, 1e-9);
    }
}


TEST(pointGradients, pointInwardsBetweenSpheres)
{
    const backgroundMesh mesh(shellMesh(12, 1, 2));
    const scalarField field(solve(mesh, cotangentWeights(mesh)));
    const vectorField gradients(pointGradients(mesh, field));

    for (label p = 0; p < mesh.nWallPoints; ++p)
    {
        const scalar cosine =
            -(mesh.points[p] & gradients[p])/mag(gradients[p]);

        EXPECT_GT(cosine, std::cos(0.1));
    }
}


// ************************************************************************* //
