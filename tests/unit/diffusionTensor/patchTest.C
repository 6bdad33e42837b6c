/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Every model of the conductivity against what its equation has as solution
    between plates, spheres and cylinders, and in edges.

\*---------------------------------------------------------------------------*/

#include "tensorsOnShell.H"
#include "mathematicalConstants.H"

#include <functional>

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static const wordList models({"isotropic", "anisotropic", "gradientPower"});


static fieldControls tight
(
    const fieldSolver solver = fieldSolver::krylov
)
{
    fieldControls controls;
    controls.solver = solver;
    controls.tolerance = 1e-12;

    return controls;
}


//- The field of a model with its coefficients
static scalarField fieldOf
(
    const backgroundMesh& mesh,
    const word& model,
    const fieldControls& controls = tight(),
    const dictionary& coeffs = dictionary()
)
{
    const solved isotropic
    {
        mesh, makeHarmonicField(mesh, cotangentWeights(mesh), controls)
    };

    return makeHarmonicField
    (
        mesh, weightsOf(isotropic, model, coeffs), controls
    );
}


//- Conductivity along the gradient of a model with the default coefficients
static scalar normalConductivity(const word& model, const scalar sigma)
{
    if (model == "isotropic")
    {
        return 1;
    }
    if (model == "gradientPower")
    {
        return std::pow(sigma, sigma < 1 ? 3 : 5.0/3);
    }

    const auto alongGradient = [](const scalar x)
    {
        const label n = 1000;
        scalar sum = 0;
        for (label i = 0; i < n; ++i)
        {
            const scalar c = (i + 0.5)/n;
            sum += std::exp(x*c)*sqr(c)/n;
        }

        return sum;
    };

    return std::exp
    (
        2*(alongGradient(min(sigma, 1.0)) - alongGradient(1))/0.25
    );
}


//- The solution of div(K grad(H)) = 0 from 1 at the radius 1 to 0 at 2, for K
//  from the slope of the isotropic solution, in space of that many dimensions
struct radialSolution
{
    scalarField integral;

    radialSolution(const word& model, const label nDimensions)
    :
        integral(2001, 0)
    {
        const label n = integral.size() - 1;
        const scalar total =
            nDimensions == 3 ? 0.5 : std::log(2.0);

        for (label i = 0; i < n; ++i)
        {
            const scalar area = std::pow(1 + (i + 0.5)/n, nDimensions - 1);
            const scalar sigma = 1/(area*total);
            integral[i + 1] = integral[i]
              + 1/(area*normalConductivity(model, sigma)*n);
        }
    }

    scalar operator()(const scalar radius) const
    {
        const scalar n = integral.size() - 1;
        const label i =
            min(max(label((radius - 1)*n), label(0)), label(n - 1));
        const scalar s = (radius - 1)*n - i;

        return 1
          - ((1 - s)*integral[i] + s*integral[i + 1])/integral.last();
    }
};


//- Root mean square difference from the radial solution at free points; the
//  radius is the distance from the axis z or from the origin
static scalar radialError
(
    const backgroundMesh& mesh,
    const word& model,
    const label nDimensions
)
{
    const scalarField field(fieldOf(mesh, model));
    const radialSolution exact(model, nDimensions);
    scalar sumSqr = 0;
    label nFree = 0;

    forAll(field, p)
    {
        if (mesh.free[p])
        {
            point x = mesh.points[p];
            x.z() *= nDimensions - 2;
            sumSqr += sqr(field[p] - exact(mag(x)));
            ++nFree;
        }
    }

    return Foam::sqrt(sumSqr/nFree);
}


//- The exponent m of 1 - H ~ r^m on the bisector of an edge, from a radius r
//  above which gradientPower's floor on the slope is not reached
static scalar exponentAtEdge
(
    const scalar degrees,
    const word& model,
    const scalar smallest,
    const dictionary& coeffs = dictionary()
)
{
    const backgroundMesh mesh(testSurfaces::sectorMesh(24, degrees));
    const scalarField field(fieldOf(mesh, model, tight(), coeffs));
    const scalar half = 0.5*degrees*constant::mathematical::pi/180;
    const vector bisector(std::cos(half), std::sin(half), 0);
    scalarField logRadius, logDrop;

    forAll(field, p)
    {
        const point& x = mesh.points[p];
        const scalar r = mag(x);

        const bool onBisector =
            x.z() == 0 && mag(x - r*bisector) < 1e-9;

        if (onBisector && r > smallest && r < 5*smallest)
        {
            logRadius.append(std::log(r));
            logDrop.append(std::log(1 - field[p]));
        }
    }

    // Least squares
    const scalarField dx(logRadius - average(logRadius));

    return sum(dx*logDrop)/sum(sqr(dx));
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(patchTest, betweenPlatesFieldsAreLinear)
{
    const backgroundMesh mesh(testSurfaces::platesMesh(8));

    for (const auto solver : {fieldSolver::krylov, fieldSolver::iteration})
    {
        for (const word& model : models)
        {
            const scalarField field(fieldOf(mesh, model, tight(solver)));

            EXPECT_LT(max(mag(field - (1 - mesh.points.component(2)))), 0.02)
                << model << ' ' << int(solver);
        }
    }
}


TEST(patchTest, betweenSpheresFieldsConverge)
{
    const backgroundMesh coarse(testSurfaces::shellMesh(8, 1, 2));
    const backgroundMesh fine(testSurfaces::shellMesh(16, 1, 2));

    for (const word& model : models)
    {
        const scalar error = radialError(fine, model, 3);
        EXPECT_LT(error, 0.02) << model;
        EXPECT_GT(std::log2(radialError(coarse, model, 3)/error), 1) << model;
    }
}


TEST(patchTest, betweenCylindersFieldsConverge)
{
    const backgroundMesh coarse(testSurfaces::tubeMesh(5, 1, 2));
    const backgroundMesh fine(testSurfaces::tubeMesh(10, 1, 2));

    for (const word& model : models)
    {
        const scalar error = radialError(fine, model, 2);
        EXPECT_LT(error, 0.02) << model;
        EXPECT_GT(std::log2(radialError(coarse, model, 2)/error), 1) << model;
    }
}


TEST(patchTest, isotropicFieldHasTheExponentOfTheEdge)
{
    for (const scalar degrees : {45.0, 60.0, 90.0, 120.0, 150.0, 270.0})
    {
        EXPECT_NEAR
        (
            exponentAtEdge(degrees, "isotropic", 0.03)/(180/degrees), 1, 0.05
        ) << degrees;
    }
}


TEST(patchTest, gradientPowerMakesLevelSetsParallelInEdges)
{
    for (const scalar degrees : {60.0, 90.0, 120.0, 150.0, 270.0})
    {
        dictionary coeffs;
        coeffs.add(degrees < 180 ? "qConcave" : "qConvex", 1 + 180/degrees);
        coeffs.add("tau", 1);

        EXPECT_NEAR
        (
            exponentAtEdge
            (
                degrees, "gradientPower", degrees < 90 ? 0.08 : 0.03, coeffs
            ),
            1, 0.05
        ) << degrees;
    }
}


// ************************************************************************* //
