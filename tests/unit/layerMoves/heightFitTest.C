/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heightFit.H"
#include "testSurfaces.H"
#include "Random.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- Change of the mean height of each face by displacements of its points
static scalarField changes
(
    const wallSurface& wall,
    const vectorField& displacements
)
{
    const vectorField normals(wall.faceNormals());
    scalarField sums(wall.faces.size(), 0);

    forAll(sums, facei)
    {
        const face& f = wall.faces[facei];

        for (const label p : f)
        {
            sums[facei] += (normals[facei] & displacements[p])/f.size();
        }
    }

    return sums;
}


static scalarField randomHeights(const wallSurface& wall)
{
    Random random(3);
    scalarField heights(wall.faces.size());

    for (scalar& h : heights)
    {
        h = random.sample01<scalar>() - 0.5;
    }

    return heights;
}


static List<wallSurface> walls()
{
    return List<wallSurface>
    ({
        testSurfaces::sphere(2), testSurfaces::quadSphere(4),
        testSurfaces::lBlock(2)
    });
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(heightFit, noHeightMissingNothingMoves)
{
    for (const wallSurface& wall : walls())
    {
        heightFit fit(wall, identity(wall.faces.size()));
        fit.setMobilities(scalarField(wall.points.size(), 1));

        EXPECT_EQ
        (
            fit.displacements(scalarField(wall.faces.size(), 0)),
            vectorField(wall.points.size(), Zero)
        );
    }
}


TEST(heightFit, columnsOnAPlaneRiseByTheMissingHeight)
{
    // All of the wall: three planes at the corner of a block
    const wallSurface wall(testSurfaces::lBlock(2));
    heightFit fit(wall, identity(wall.faces.size()));
    fit.setMobilities(scalarField(wall.points.size(), 1));

    const vectorField d(fit.displacements(scalarField(wall.faces.size(), 0.1)));
    const scalarField risen(changes(wall, d));

    EXPECT_NEAR(min(risen), 0.1, 2e-3);
    EXPECT_NEAR(max(risen), 0.1, 2e-3);
}


TEST(heightFit, missingHeightsBecomeSmaller)
{
    for (const wallSurface& wall : walls())
    {
        heightFit fit(wall, identity(wall.faces.size()));
        fit.setMobilities(scalarField(wall.points.size(), 1));

        const scalarField missing(randomHeights(wall));
        const scalarField left
        (
            missing - changes(wall, fit.displacements(missing))
        );

        EXPECT_LT(sumSqr(left), 0.5*sumSqr(missing));
    }
}


TEST(heightFit, minimumOfDisplacementsAndErrors)
{
    // Of displacements that bring about the same, none is smaller: d is in the
    // span of the normals of the faces around
    const wallSurface wall(testSurfaces::cube(2));
    heightFit fit(wall, identity(wall.faces.size()));
    fit.setMobilities(scalarField(wall.points.size(), 1));

    const vectorField d(fit.displacements(randomHeights(wall)));
    const label p = wall.points.find(point(0.5, 0.5, 1));

    ASSERT_GE(p, 0);
    EXPECT_NEAR(d[p].x(), 0, 1e-14);
    EXPECT_NEAR(d[p].y(), 0, 1e-14);
    EXPECT_GT(mag(d[p].z()), 1e-3);
}


TEST(heightFit, columnsWithoutMobilityStay)
{
    for (const wallSurface& wall : walls())
    {
        scalarField mobilities(wall.points.size(), 1);
        for (label p = 0; p < mobilities.size(); p += 3)
        {
            mobilities[p] = 0;
        }

        heightFit fit(wall, identity(wall.faces.size()));
        fit.setMobilities(mobilities);
        const vectorField d(fit.displacements(randomHeights(wall)));

        forAll(d, p)
        {
            EXPECT_EQ(mag(d[p]) == 0, mobilities[p] == 0);
        }
    }
}


TEST(heightFit, lessMobilityIsLessDisplacement)
{
    const wallSurface wall(testSurfaces::sphere(2));
    const scalarField missing(randomHeights(wall));
    heightFit fit(wall, identity(wall.faces.size()));

    scalarField mobilities(wall.points.size(), 1);
    fit.setMobilities(mobilities);
    const scalar before = mag(fit.displacements(missing)[7]);

    mobilities[7] = 0.1;
    fit.setMobilities(mobilities);

    EXPECT_LT(mag(fit.displacements(missing)[7]), 0.5*before);
}


TEST(heightFit, onlySomeFaces)
{
    const wallSurface wall(testSurfaces::sphere(2));
    heightFit fit(wall, labelList({5, 17}));
    fit.setMobilities(scalarField(wall.points.size(), 1));

    const scalarField missing(scalarList({0.1, -0.2}));
    const vectorField d(fit.displacements(missing));
    const scalarField risen(changes(wall, d));

    EXPECT_NEAR(risen[5], 0.1, 1e-3);
    EXPECT_NEAR(risen[17], -0.2, 2e-3);

    forAll(d, p)
    {
        EXPECT_EQ
        (
            mag(d[p]) > 0,
            wall.faces[5].found(p) || wall.faces[17].found(p)
        );
    }
}


TEST(heightFit, solvesTheEquations)
{
    // (A.M.A^T + lambda I) y = r with d = M.A^T.y: lambda y is left of r,
    // and d is a sum of normals times y
    const scalar lambda = 0.1;

    for (const wallSurface& wall : walls())
    {
        heightFit fit(wall, identity(wall.faces.size()), lambda);
        fit.setMobilities(scalarField(wall.points.size(), 1));

        const scalarField missing(randomHeights(wall));
        const vectorField d(fit.displacements(missing));
        const scalarField y((missing - changes(wall, d))/lambda);
        const vectorField normals(wall.faceNormals());
        vectorField expected(wall.points.size(), Zero);

        forAll(wall.faces, facei)
        {
            for (const label p : wall.faces[facei])
            {
                expected[p] +=
                    y[facei]*normals[facei]/wall.faces[facei].size();
            }
        }

        EXPECT_LT(max(mag(expected - d)), 1e-2*max(mag(d)));
    }
}


// ************************************************************************* //
