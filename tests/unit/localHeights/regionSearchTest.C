/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "regionSearch.H"
#include "testSurfaces.H"
#include "thrownMessage.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static geometryRegion regionOf(const std::string& geometry)
{
    geometryRegion region;
    region.name = "part";
    region.geometry = dictionaryOf(geometry);

    return region;
}


//- Number of points on which the region and a criterion differ
template<class Criterion>
static label nDifferent(const geometryRegion& region, const Criterion& isIn)
{
    const pointField points(testSurfaces::cube(7).points);
    const autoPtr<Time> time(Time::New());
    const boolList in(regionSearch(region, time()).contains(points));
    label n = 0;

    forAll(points, p)
    {
        n += in[p] != isIn(points[p]);
    }

    return n;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(regionSearch, insideAndOutsideOfABox)
{
    geometryRegion region
    (
        regionOf("type searchableBox; min (-1 -1 -1); max (2 0.5 0.5);")
    );
    const auto inBox = [](const point& x)
    {
        return x.y() < 0.5 && x.z() < 0.5;
    };

    EXPECT_EQ(nDifferent(region, inBox), 0);

    region.mode = geometryRegion::modes::outside;
    EXPECT_EQ(nDifferent(region, [&](const point& x) { return !inBox(x); }), 0);
}


TEST(regionSearch, insideOfASphereAndACylinder)
{
    EXPECT_EQ
    (
        nDifferent
        (
            regionOf("type searchableSphere; centre (1 1 1); radius 0.6;"),
            [](const point& x) { return mag(x - point(1, 1, 1)) < 0.6; }
        ),
        0
    );
    EXPECT_EQ
    (
        nDifferent
        (
            regionOf
            (
                "type searchableCylinder; point1 (0 0 -1); point2 (0 0 2);"
                " radius 0.7;"
            ),
            [](const point& x) { return ::hypot(x.x(), x.y()) < 0.7; }
        ),
        0
    );
}


TEST(regionSearch, nearASurfaceWithoutInside)
{
    geometryRegion region
    (
        regionOf
        (
            "type searchablePlate; origin (0 0 0.5); span (1 1 0);"
        )
    );
    region.mode = geometryRegion::modes::distance;
    region.distance = 0.3;

    EXPECT_EQ
    (
        nDifferent
        (
            region, [](const point& x) { return mag(x.z() - 0.5) < 0.3; }
        ),
        0
    );

    region.mode = geometryRegion::modes::inside;
    const std::string message
    (
        thrownMessage<error>([&]()
        {
            nDifferent(region, [](const point&) { return true; });
        })
    );
    expectWords(message, {"region part", "not closed"});
}


TEST(regionSearch, distancesAreThoseFromTheRegion)
{
    const autoPtr<Time> time(Time::New());
    const pointField points({point(0, 0, 0), point(3, 0, 0), point(0, 0, -5)});
    geometryRegion region
    (
        regionOf("type searchableSphere; centre (0 0 0); radius 1;")
    );

    const auto expectDistances = [&](const scalarList& expected)
    {
        const scalarField found(regionSearch(region, time()).distances(points));
        forAll(expected, i)
        {
            EXPECT_NEAR(found[i], expected[i], 1e-12) << i;
        }
    };

    expectDistances(scalarList({0, 2, 4}));

    region.mode = geometryRegion::modes::outside;
    expectDistances(scalarList({1, 0, 0}));

    region.mode = geometryRegion::modes::distance;
    region.distance = 0.5;
    expectDistances(scalarList({0.5, 1.5, 3.5}));
}


// ************************************************************************* //
