/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sparsePoints.H"
#include "Random.H"

#include <gtest/gtest.h>
#include <omp.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- The definition, in quadratic time
static labelList definition
(
    const pointField& points,
    const scalarField& distances
)
{
    DynamicList<label> kept;

    forAll(points, p)
    {
        bool free = true;

        for (const label q : kept)
        {
            free = free
             && mag(points[q] - points[p]) >= min(distances[p], distances[q]);
        }

        if (free)
        {
            kept.append(p);
        }
    }

    return labelList(std::move(kept));
}


static pointField randomPoints(const label n, Random& random)
{
    pointField points(n);

    for (point& x : points)
    {
        x = random.sample01<vector>() - vector::uniform(0.5);
    }

    return points;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(sparsePoints, asDefinedForOneDistance)
{
    Random random(8);
    const pointField points(randomPoints(1500, random));

    for (const scalar distance : {0.01, 0.1, 0.125, 0.3, 2.0})
    {
        const scalarField distances(points.size(), distance);
        EXPECT_EQ
        (
            sparsePoints(points, distances), definition(points, distances)
        );
    }
}


TEST(sparsePoints, asDefinedForDistancesOfAllSizes)
{
    Random random(9);
    const pointField points(randomPoints(1500, random));
    scalarField distances(points.size());

    for (scalar& d : distances)
    {
        d = std::exp(-7*random.sample01<scalar>());
    }

    EXPECT_EQ(sparsePoints(points, distances), definition(points, distances));
}


TEST(sparsePoints, asDefinedFarFromTheOrigin)
{
    Random random(10);
    const pointField points
    (
        1e-3*randomPoints(500, random) + vector(1e4, -1e4, 1e4)
    );
    const scalarField distances(points.size(), 1e-4);

    EXPECT_EQ(sparsePoints(points, distances), definition(points, distances));
}


TEST(sparsePoints, everySecondOnALine)
{
    pointField points(9, point(Zero));
    forAll(points, i)
    {
        points[i].x() = i;
    }

    EXPECT_EQ
    (
        sparsePoints(points, scalarField(9, 1.5)),
        labelList({0, 2, 4, 6, 8})
    );
}


TEST(sparsePoints, theDistanceItselfIsEnough)
{
    const pointField points({point(0, 0, 0), point(1, 0, 0)});

    EXPECT_EQ(sparsePoints(points, scalarField(2, 1)).size(), 2);
}


TEST(sparsePoints, theSmallerDistanceCounts)
{
    const pointField points({point(0, 0, 0), point(1, 0, 0)});

    auto nKept = [&](const scalar first, const scalar second)
    {
        scalarField distances(2, first);
        distances[1] = second;
        return sparsePoints(points, distances).size();
    };

    EXPECT_EQ(nKept(5, 0.5), 2);
    EXPECT_EQ(nKept(0.5, 5), 2);
    EXPECT_EQ(nKept(2, 5), 1);
}


TEST(sparsePoints, oneOfEqualPoints)
{
    const pointField points(5, point(1, 2, 3));

    EXPECT_EQ(sparsePoints(points, scalarField(5, 1e-9)), labelList({0}));
}


TEST(sparsePoints, noneOfNone)
{
    EXPECT_TRUE(sparsePoints(pointField(), scalarField()).empty());
}


TEST(sparsePoints, areTheSameOnAnyNumberOfThreads)
{
    Random random(9);
    const pointField points(randomPoints(5000, random));
    scalarField distances(points.size());
    for (scalar& distance : distances)
    {
        distance = 0.01 + 0.1*random.sample01<scalar>();
    }
    const labelList expected(definition(points, distances));
    const label before = omp_get_max_threads();
    for (const label n : {1, 2, 3, 5})
    {
        omp_set_num_threads(n);
        EXPECT_EQ(sparsePoints(points, distances), expected) << n;
    }
    omp_set_num_threads(before);
}


// ************************************************************************* //
