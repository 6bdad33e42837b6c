/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "limitGradient.H"
#include "testSurfaces.H"
#include "Random.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static scalarField randomValues(const label n)
{
    Random random(6);
    scalarField values(n);

    for (scalar& v : values)
    {
        v = random.sample01<scalar>();
    }

    return values;
}


//- The largest difference over slope times distance between neighbours
static scalar steepest
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const scalar slope,
    const scalarField& values
)
{
    scalar largest = 0;

    for (const edge& e : addressing.edges)
    {
        largest = max
        (
            largest,
            mag(values[e.start()] - values[e.end()])/(slope*e.mag(wall.points))
        );
    }

    return largest;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(limitGradient, coneAboveOneLowPoint)
{
    // On the squares of a cube the way along edges from the origin to a point
    // is as long as the sum of its coordinates
    const wallSurface wall(testSurfaces::quadCube(6));
    const scalar slope = 0.5;
    scalarField values(wall.points.size(), GREAT);

    forAll(values, p)
    {
        if (mag(wall.points[p]) < 1e-9)
        {
            values[p] = 0;
        }
    }
    limitGradient(wall, makeWallAddressing(wall), slope, values);

    forAll(values, p)
    {
        const point& x = wall.points[p];
        EXPECT_NEAR(values[p], slope*(x.x() + x.y() + x.z()), 1e-14);
    }
}


TEST(limitGradient, boundsTheSlope)
{
    const wallSurface wall(testSurfaces::sphere(8));
    const wallAddressing addressing(makeWallAddressing(wall));
    scalarField values(randomValues(wall.points.size()));
    limitGradient(wall, addressing, 0.3, values);

    EXPECT_LE(steepest(wall, addressing, 0.3, values), 1 + 1e-12);
}


TEST(limitGradient, lowersNoMoreThanItMust)
{
    // Each point keeps its value or has a neighbour that bounds it
    const wallSurface wall(testSurfaces::sphere(8));
    const wallAddressing addressing(makeWallAddressing(wall));
    const scalarField before(randomValues(wall.points.size()));
    scalarField values(before);
    limitGradient(wall, addressing, 0.3, values);

    forAll(values, p)
    {
        scalar bound = before[p];
        for (const label q : addressing.pointPoints[p])
        {
            const scalar length = mag(wall.points[q] - wall.points[p]);
            bound = min(bound, values[q] + 0.3*length);
        }

        EXPECT_EQ(values[p], bound);
    }
}


TEST(limitGradient, returnsThePointsThatItLowered)
{
    const wallSurface wall(testSurfaces::sphere(8));
    const scalarField before(randomValues(wall.points.size()));
    scalarField values(before);
    const labelList lowered
    (
        limitGradient(wall, makeWallAddressing(wall), 0.3, values)
    );

    DynamicList<label> expected;
    forAll(values, p)
    {
        if (values[p] < before[p])
        {
            expected.append(p);
        }
    }

    EXPECT_GT(lowered.size(), 0);
    EXPECT_EQ(lowered, labelList(expected));
}


TEST(limitGradient, secondTimeChangesNothing)
{
    const wallSurface wall(testSurfaces::sphere(8));
    const wallAddressing addressing(makeWallAddressing(wall));
    scalarField values(randomValues(wall.points.size()));
    limitGradient(wall, addressing, 0.3, values);
    const scalarField once(values);

    EXPECT_TRUE(limitGradient(wall, addressing, 0.3, values).empty());
    EXPECT_EQ(values, once);
}


TEST(limitGradient, leavesWhatIsFlatEnough)
{
    const wallSurface wall(testSurfaces::cube(5));
    scalarField values(wall.points.component(vector::X));
    const scalarField before(values);

    // Edges along x have this slope, up to the rounding of their lengths
    EXPECT_TRUE
    (
        limitGradient
        (
            wall, makeWallAddressing(wall), 1 + 1e-12, values
        ).empty()
    );
    EXPECT_EQ(values, before);
}


TEST(limitRatio, powersOfTheRatioAroundOneLowPoint)
{
    const wallSurface wall(testSurfaces::cube(6));
    const wallAddressing addressing(makeWallAddressing(wall));

    scalarField values(wall.points.size(), 100);
    values[17] = 1;
    const labelList lowered(limitRatio(addressing, 1.5, values));

    // By breadth first search
    labelList steps(values.size(), -1);
    DynamicList<label> front(1, 17);
    steps[17] = 0;
    for (label i = 0; i < front.size(); ++i)
    {
        for (const label q : addressing.pointPoints[front[i]])
        {
            if (steps[q] < 0)
            {
                steps[q] = steps[front[i]] + 1;
                front.append(q);
            }
        }
    }

    forAll(values, p)
    {
        const scalar expected = min(scalar(100), ::pow(1.5, steps[p]));

        EXPECT_NEAR(values[p]/expected, 1, 1e-12);
        EXPECT_EQ(lowered.found(p), expected < 100 && p != 17);
    }
}


TEST(followGradient, equalsTheWholeWall)
{
    const wallSurface wall(testSurfaces::sphere(10));
    const wallAddressing addressing(makeWallAddressing(wall));
    Random random(3);
    scalarField values(wall.points.size());

    for (scalar& v : values)
    {
        v = 1 + random.sample01<scalar>();
    }
    limitGradient(wall, addressing, 0.5, values);

    for (label round = 0; round < 20; ++round)
    {
        Map<scalar> lowered;
        scalarField whole(values);
        for (label i = 0; i < 2; ++i)
        {
            const label p = random.position<label>(0, values.size() - 1);
            lowered.set(p, 0.8*values[p]);
            whole[p] = 0.8*values[p];
        }

        followGradient(wall, addressing, 0.5, values, lowered);
        limitGradient(wall, addressing, 0.5, whole);

        forAll(whole, p)
        {
            EXPECT_EQ(whole[p], lowered.lookup(p, values[p]));
            EXPECT_EQ(lowered.found(p), whole[p] < values[p]);
        }
        values = whole;
    }
}


// ************************************************************************* //
