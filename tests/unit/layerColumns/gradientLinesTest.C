/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gradientLines.H"
#include "harmonicField.H"
#include "SubField.H"
#include "testStages.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- Lines between spheres of radius 1 and 2, along the exact directions at the
//  wall, sampled at the same arc lengths
struct shellLines
{
    backgroundMesh mesh;
    gradientLines lines;
    scalarList arcLengths;
};


static const shellLines& shell()
{
    static const shellLines s([]
    {
        shellLines made;
        made.mesh = testSurfaces::shellMesh(12, 1, 2);
        made.arcLengths = scalarList({0.05, 0.2, 0.5, 0.9, 1.5});

        const label n = made.mesh.nWallPoints;
        const vectorField directions(SubField<point>(made.mesh.points, n));
        scalarField arcLengths(n*made.arcLengths.size());
        forAll(arcLengths, i)
        {
            arcLengths[i] = made.arcLengths[i % made.arcLengths.size()];
        }

        made.lines = makeGradientLines
        (
            made.mesh,
            makeHarmonicField
            (
                made.mesh, cotangentWeights(made.mesh), fieldControls()
            ),
            identity(made.mesh.nWallPoints),
            directions,
            arcLengths
        );

        return made;
    }());

    return s;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(gradientLines, haveTheirSamples)
{
    const gradientLines& lines = shell().lines;
    const label n = shell().mesh.nWallPoints;

    EXPECT_EQ(lines.nSamples, 5);
    EXPECT_EQ(lines.points.size(), 5*n);
    EXPECT_EQ(lines.energies.size(), 5*n);
}


TEST(gradientLines, areRadialBetweenSpheres)
{
    const gradientLines& lines = shell().lines;

    forAll(lines.points, i)
    {
        const vector x(normalised(lines.points[i]));
        const vector radial(shell().mesh.points[i/lines.nSamples]);

        // Half the width of a tetrahedron over its distance
        EXPECT_GT(x & radial, std::cos(0.07));
    }
}


TEST(gradientLines, areSampledAtTheArcLengths)
{
    const gradientLines& lines = shell().lines;

    forAll(lines.points, i)
    {
        // The lines hardly bend
        EXPECT_NEAR
        (
            mag(lines.points[i]) - 1,
            shell().arcLengths[i % lines.nSamples],
            0.01
        );
    }
}


TEST(gradientLines, energiesAreThoseOfTheExactField)
{
    const gradientLines& lines = shell().lines;

    forAll(lines.energies, i)
    {
        const scalar s = shell().arcLengths[i % lines.nSamples];
        EXPECT_NEAR(lines.energies[i], max(2/(1 + s) - 1, scalar(0)), 0.02);
    }
}


TEST(gradientLines, energiesDescend)
{
    const gradientLines& lines = shell().lines;

    forAll(lines.energies, i)
    {
        const bool first = i % lines.nSamples == 0;
        EXPECT_LT(lines.energies[i], first ? 1 : lines.energies[i - 1]);
    }
}


TEST(gradientLines, endOnTheEnvelope)
{
    // Up to one step, an eighth of the gap
    const backgroundMesh& mesh = shell().mesh;
    const label n = mesh.nWallPoints;
    scalarField arcLengths(2*n);
    forAll(arcLengths, i)
    {
        arcLengths[i] = i % 2 ? 1 + 0.125 : 1 - 0.03;
    }

    const gradientLines lines
    (
        makeGradientLines
        (
            mesh, 2 - mag(mesh.points), identity(n),
            vectorField(SubField<point>(mesh.points, n)), arcLengths
        )
    );

    for (label p = 0; p < n; ++p)
    {
        EXPECT_GT(lines.energies[2*p], 0);
        EXPECT_EQ(lines.energies[2*p + 1], 0);
    }
}


TEST(gradientLines, leaveTheWallAlongTheirDirections)
{
    const backgroundMesh& mesh = shell().mesh;
    const label n = mesh.nWallPoints;
    vectorField directions(n);
    forAll(directions, p)
    {
        const vector& x = mesh.points[p];
        directions[p] = normalised(x + 0.3*(vector(0, 0, 1) ^ x));
    }

    const scalar s = 1e-3;
    const gradientLines lines
    (
        makeGradientLines(mesh, 2 - mag(mesh.points), identity(n), directions,
            scalarField(n, s))
    );

    forAll(directions, p)
    {
        EXPECT_NEAR
        (
            mag(lines.points[p] - mesh.points[p] - s*directions[p]), 0, 1e-15
        );
    }
}


// ************************************************************************* //
