/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSmoother.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static const label n = 20;
static const scalar h = 1.0/n;


//- The unit cube in squares of side h: on all of it the mean of length^2 of the
//  edges of a point is h^2
struct squares
{
    wallSurface wall;
    wallAddressing addressing;
    wallSmoother smoother;

    squares()
    :
        wall(testSurfaces::quadCube(n)),
        addressing(makeWallAddressing(wall)),
        smoother(wall, addressing)
    {}

    //- A peak in the middle of the top, smoothed
    scalarField peak(const scalar variance, const label maxPasses) const
    {
        scalarField values(wall.points.size(), 0);
        forAll(values, p)
        {
            if (mag(wall.points[p] - point(0.5, 0.5, 1)) < 0.1*h)
            {
                values[p] = 1;
            }
        }
        smoother.smooth
        (
            scalarField(values.size(), variance), maxPasses, values
        );

        return values;
    }

    //- Sum of values*(x - 0.5)^2 along an axis
    scalar variance(const scalarField& values, const direction axis) const
    {
        return sum(values*sqr(wall.points.component(axis) - 0.5));
    }
};


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(wallSmoother, addsTheVarianceToAPeak)
{
    const squares s;

    for (const scalar variance : {0.1*h*h, h*h, 2.5*h*h})
    {
        const scalarField values(s.peak(variance, 10));

        EXPECT_NEAR(sum(values), 1, 1e-13);
        EXPECT_NEAR(s.variance(values, 0), variance, 1e-13);
        EXPECT_NEAR(s.variance(values, 1), variance, 1e-13);
        EXPECT_GE(min(values), 0);
    }
}


TEST(wallSmoother, addsNoMoreThanFullPasses)
{
    const squares s;
    const scalarField values(s.peak(100*h*h, 3));

    EXPECT_NEAR(s.variance(values, 0), 3*wallSmoother::fullPass*0.5*h*h, 1e-13);
}


TEST(wallSmoother, doesNothingWithoutVariance)
{
    const squares s;
    const scalarField values(s.peak(0, 10));

    EXPECT_EQ(sum(values), 1);
    EXPECT_EQ(max(values), 1);
}


TEST(wallSmoother, keepsConstants)
{
    const squares s;
    vectorField values(s.wall.points.size(), vector(1, 2, 3));

    s.smoother.smooth(scalarField(values.size(), h*h), 5, values);
    EXPECT_LT(max(mag(values - vector(1, 2, 3))), 1e-14);
}


TEST(wallSmoother, meanIsThatOfTheNeighbours)
{
    // A linear field has its own value as mean, away from edges
    const squares s;
    const scalarField values(s.wall.points & vector(1, 2, 0));

    forAll(values, p)
    {
        const point& x = s.wall.points[p];

        if
        (
            x.z() > 1 - 0.1*h
         && mag(x.x() - 0.5) < 0.3
         && mag(x.y() - 0.5) < 0.3
        )
        {
            EXPECT_NEAR(s.smoother.mean(values, p), values[p], 1e-14);
        }
    }
}


// ************************************************************************* //
