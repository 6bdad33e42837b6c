/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellSizes.H"
#include "Random.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const boundBox box(point(-1, -1, -1), point(3, 1, 1));

static const sizeBounds unbounded;


//- Sizes from two points
static cellSizes twoPoints(const sizeBounds& bounds, const label maxCubes)
{
    return cellSizes
    (
        pointField({point(0, 0, 0), point(2, 0, 0)}),
        scalarField(2, 0.1), 1.2, box, bounds, maxCubes
    );
}


static scalar distance(const point& x)
{
    return min(mag(x), mag(x - point(2, 0, 0)));
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(cellSizes, growFromTheNearestPoint)
{
    const cellSizes sizes(twoPoints(unbounded, 1000000));
    Random random(3);

    for (label i = 0; i < 200; ++i)
    {
        const point x
        (
            box.min() + cmptMultiply(random.sample01<vector>(), box.span())
        );
        const scalar exact = 0.1 + 0.2*distance(x);

        // A cube has one point, which is not the nearest of all in it
        EXPECT_GE(sizes(x), exact*(1 - 1e-12));
        EXPECT_LE(sizes(x), exact*1.5);
    }

    EXPECT_DOUBLE_EQ(sizes(point(0, 0, 0)), 0.1);
    EXPECT_NEAR(sizes(point(0, 0.5, 0)), 0.2, 1e-12);
}


TEST(cellSizes, areBounded)
{
    sizeBounds bounds;
    bounds.largest = 0.15;
    const cellSizes sizes(twoPoints(bounds, 1000000));

    EXPECT_DOUBLE_EQ(sizes(point(0, 0, 0)), 0.1);
    EXPECT_DOUBLE_EQ(sizes(point(-1, 1, 1)), 0.15);
}


TEST(cellSizes, areNotCompleteWithoutEnoughCubes)
{
    EXPECT_TRUE(twoPoints(unbounded, 1000000).complete());
    EXPECT_FALSE(twoPoints(unbounded, 100).complete());

    // Cubes of equal size count, which are not made
    sizeBounds bounds;
    bounds.largest = 0.01;
    EXPECT_FALSE(twoPoints(bounds, 10000000).complete());
    EXPECT_TRUE(twoPoints(bounds, 100000000).complete());
}


TEST(cellSizes, aBoxWithoutThicknessNeedsSquares)
{
    // 4 x 2, with 80,000 squares, or 16,000,000 cubes if it had a thickness
    const boundBox flat(point(-1, -1, 0), point(3, 1, 0));
    const auto complete = [&](const sizeBounds& bounds, const label maxCubes)
    {
        return cellSizes
        (
            pointField(1, Zero), scalarField(1, 1), 1.2, flat, bounds, maxCubes
        ).complete();
    };

    sizeBounds everywhere;
    everywhere.largest = 0.01;
    EXPECT_FALSE(complete(everywhere, 60000));
    EXPECT_TRUE(complete(everywhere, 100000));

    // Divided into cubes, on both sides of the plane
    sizeBounds region;
    region.atPoints = [](const pointField& x)
    {
        return scalarField(x.size(), 0.01);
    };
    EXPECT_TRUE(complete(region, 2000000));
}


TEST(cellSizes, beyondABoxAreThoseOfTheCubeAtItsSide)
{
    const boundBox flat(point(-1, -1, 0), point(3, 1, 0));
    const cellSizes sizes
    (
        pointField(1, Zero), scalarField(1, 0.1), 1.2, flat, unbounded, 1000000
    );

    EXPECT_NEAR(sizes(point(1, 0.5, 0)), 0.1 + 0.2*std::sqrt(1.25), 1e-12);
    EXPECT_NEAR(sizes(point(1, 0.5, 2)), 0.1 + 0.2*std::sqrt(5.25), 1e-12);
}


// ************************************************************************* //
