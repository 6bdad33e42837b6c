/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "limitHeightJumps.H"
#include "Random.H"
#include "testSurfaces.H"

#include <algorithm>

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Faces of a wall on columns of these heights
static heightLimits given(const wallSurface& wall, const scalarField& columns)
{
    heightLimits heights;
    heights.faces.shallowCopy(wall.faces);
    heights.neighbours = makeWallAddressing(wall).edgeFaces;
    heights.largest.setSize(wall.faces.size(), 10);
    heights.heights = heightLimits::valuesOfCorners(wall.faces);

    forAll(wall.faces, facei)
    {
        UList<scalar> ofFace(heights.heights[facei]);
        ofFace.deepCopy(scalarList(columns, wall.faces[facei]));
    }

    return heights;
}


static scalarField faceHeights
(
    const heightLimits& heights,
    const scalarField& factors
)
{
    scalarField result(heights.faces.size(), 0);

    forAll(result, facei)
    {
        const face& f = heights.faces[facei];
        forAll(f, k)
        {
            result[facei] += heights.heights[facei][k]*factors[f[k]]/f.size();
        }
    }

    return result;
}


static scalar largestChange
(
    const heightLimits& heights,
    const scalarField& factors
)
{
    const scalarField h(faceHeights(heights, factors));
    scalar largest = 1;

    for (const labelPair& pair : heights.neighbours)
    {
        const scalar a = h[pair.first()], b = h[pair.second()];
        largest = max(largest, max(a, b)/min(a, b));
    }

    return largest;
}


static label nEqualToOne(const scalarField& factors)
{
    return std::count(factors.begin(), factors.end(), 1.0);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(heightLimits, equalOnesStay)
{
    const wallSurface wall(testSurfaces::sphere(6));
    const label n = wall.points.size();

    EXPECT_EQ(given(wall, scalarField(n, 1.0)).factors(n), scalarField(n, 1.0));
}


TEST(heightLimits, changesAreBoundedAroundLowColumns)
{
    for
    (
        const wallSurface& wall
      : {testSurfaces::sphere(8), testSurfaces::quadCube(10)}
    )
    {
        const label n = wall.points.size();

        for (const scalar low : {0.8, 0.5, 0.1})
        {
            scalarField columns(n, 1.0);
            columns[17] = low;
            const heightLimits heights(given(wall, columns));
            const scalarField factors(heights.factors(n));

            EXPECT_LT(largestChange(heights, factors), 1.302);

            // It is not lowered itself, nor what is far away
            EXPECT_EQ(factors[17], 1);
            EXPECT_GT(nEqualToOne(factors), n/2);
        }
    }
}


TEST(heightLimits, roughColumnsBecomeEven)
{
    const wallSurface wall(testSurfaces::sphere(10));
    const label n = wall.points.size();
    Random random(5);
    scalarField columns(n);

    for (scalar& h : columns)
    {
        h = std::exp(0.9*random.sample01<scalar>());
    }

    heightLimits heights(given(wall, columns));
    heights.largest = 100;
    const scalarField factors(heights.factors(n));

    EXPECT_GT(largestChange(heights, scalarField(n, 1.0)), 1.33);
    EXPECT_LT(largestChange(heights, factors), 1.302);
    EXPECT_LE(max(factors), 1);
    EXPECT_GE(min(factors), 0.7);
}


TEST(heightLimits, orderOfFacesAndNeighboursChangesNothing)
{
    const wallSurface wall(testSurfaces::sphere(6));
    const label n = wall.points.size();
    Random random(7);
    scalarField columns(n);
    for (scalar& h : columns)
    {
        h = std::exp(random.sample01<scalar>());
    }
    heightLimits heights(given(wall, columns));
    heights.largest = 2;

    wallSurface other(wall);
    std::reverse(other.faces.begin(), other.faces.end());
    heightLimits reversed(given(other, columns));
    reversed.largest = 2;
    std::reverse(reversed.neighbours.begin(), reversed.neighbours.end());

    EXPECT_LT(nEqualToOne(heights.factors(n)), 0.9*n);
    EXPECT_EQ(heights.factors(n), reversed.factors(n));
}


TEST(heightLimits, muchLowerColumnsAreLeftAlone)
{
    // A whole neighbourhood, whose height nobody else is to have
    const wallSurface wall(testSurfaces::sphere(10));
    const label n = wall.points.size();
    scalarField columns(n, 1.0);
    label nLow = 0;

    forAll(columns, c)
    {
        if (wall.points[c].z() > 0.8)
        {
            columns[c] = 1e-3;
            ++nLow;
        }
    }

    const scalarField factors(given(wall, columns).factors(n));

    EXPECT_GE(min(factors), 0.7);
    EXPECT_GT(nEqualToOne(factors), n/2 + nLow);
}


TEST(heightLimits, tallestColumnsOfFacesTooHighComeDown)
{
    const faceList faces({face({0, 1, 2})});
    heightLimits heights;
    heights.faces.shallowCopy(faces);
    heights.heights = heightLimits::valuesOfCorners(faces);
    heights.heights.m() = scalarList({1, 2, 3});
    heights.largest = scalarField(1, 1.5);

    // 1 + 1.75 + 1.75 = 3*1.5
    const scalarField factors(heights.factors(3));
    EXPECT_EQ(factors[0], 1);
    EXPECT_NEAR(factors[1], 1.75/2, 1e-12);
    EXPECT_NEAR(factors[2], 1.75/3, 1e-12);

    heights.largest = 0.9;
    heights.heights.m() = scalarList({1.5, 1.5, 1.2});
    const scalarField all(heights.factors(3));
    EXPECT_NEAR(all[0], 0.6, 1e-12);
    EXPECT_NEAR(all[2], 0.75, 1e-12);
}


// ************************************************************************* //
