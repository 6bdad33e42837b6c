/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfacePart.H"
#include "wallSearch.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(wallSearch, boundsHoldTheWall)
{
    const wallSurface wall(testSurfaces::torus(12, 8, 3, 1));
    const wallSearch search(wall);

    for (const point& x : wall.points)
    {
        EXPECT_TRUE(search.bounds().contains(x));
    }
}


TEST(wallSearch, nearerComparesWithTheDistance)
{
    const wallSearch search(testSurfaces::cube(3));

    for (const point& x : {point(1.5, 0.4, 0.6), point(0.5, 0.4, 0.5)})
    {
        const scalar distance = x.x() > 1 ? 0.5 : 0.4;

        EXPECT_TRUE(search.nearer(x, (1 + 1e-9)*distance));
        EXPECT_FALSE(search.nearer(x, (1 - 1e-9)*distance));
    }
}


TEST(wallSearch, nearerFarFromTheWall)
{
    const wallSearch search(testSurfaces::cube(3));

    EXPECT_TRUE(search.nearer(point(100, 0.5, 0.5), 99.1));
    EXPECT_FALSE(search.nearer(point(100, 0.5, 0.5), 98.9));
}


TEST(wallSearch, firstHitIsTheFirst)
{
    const wallSearch search(testSurfaces::cube(3));
    const point x(-1, 0.41, 0.52), y(3, 0.41, 0.52);

    ASSERT_TRUE(search.firstHit(x, y).hit());
    ASSERT_TRUE(search.firstHit(y, x).hit());
    EXPECT_NEAR(search.firstHit(x, y).rawPoint().x(), 0, 1e-12);
    EXPECT_NEAR(search.firstHit(y, x).rawPoint().x(), 1, 1e-12);
}


TEST(wallSearch, firstHitMissesBesideTheWall)
{
    const wallSearch search(testSurfaces::cube(3));

    EXPECT_FALSE(search.firstHit(point(-1, 2, 0), point(3, 2, 0)).hit());
    EXPECT_FALSE
    (
        search.firstHit(point(-1, 0.41, 0.52), point(-0.1, 0.41, 0.52)).hit()
    );
}


TEST(wallSearch, footIsTheNearestPoint)
{
    const wallSurface wall(testSurfaces::cube(3));
    const wallSearch search(wall);

    // Above a side, beside an edge, beyond a corner
    const List<Pair<point>> pointsAndFeet
    ({
        {point(0.3, 0.45, 1.7), point(0.3, 0.45, 1)},
        {point(1.4, 0.45, 1.3), point(1, 0.45, 1)},
        {point(2, 2, 2), point(1, 1, 1)},
        {point(0.45, 0.4, 0.3), point(0.45, 0.4, 0)}
    });

    for (const Pair<point>& pair : pointsAndFeet)
    {
        const wallSearch::foot foot(search.footOf(pair.first()));
        point x(Zero);
        scalar sum = 0;

        for (label k = 0; k < 3; ++k)
        {
            x += foot.weights[k]*wall.points[foot.points[k]];
            sum += foot.weights[k];
            EXPECT_GE(foot.weights[k], 0);
        }

        EXPECT_NEAR(sum, 1, 1e-12);
        EXPECT_NEAR(mag(x - pair.second()), 0, 1e-12);
        EXPECT_NEAR(foot.distance, mag(pair.first() - pair.second()), 1e-12);
    }
}


TEST(wallSearch, oppositeSkipsWhatFacesAlong)
{
    // From above the cube only its top is opposite to what points down
    const wallSearch search(testSurfaces::cube(3));
    const point x(0.5, 0.45, 1.5);

    const pointIndexHit top
    (
        search.nearestOpposite(x, 5, vector(0, 0, -1), -0.5)
    );
    ASSERT_TRUE(top.hit());
    EXPECT_NEAR(mag(top.rawPoint() - point(0.5, 0.45, 1)), 0, 1e-12);

    const pointIndexHit bottom
    (
        search.nearestOpposite(x, 5, vector(0, 0, 1), -0.5)
    );
    ASSERT_TRUE(bottom.hit());
    EXPECT_NEAR(mag(bottom.rawPoint() - point(0.5, 0.45, 0)), 0, 1e-12);
}


TEST(wallSearch, oppositeIsByTheCosine)
{
    const wallSearch search(testSurfaces::cube(3));
    const point x(0.5, 0.45, 1.2);

    for (const scalar degrees : {119.0, 121.0})
    {
        const scalar angle = degrees*constant::mathematical::pi/180;
        const vector d(std::sin(angle), 0, std::cos(angle));

        // Only the top is within this distance
        EXPECT_EQ(search.nearestOpposite(x, 0.3, d, -0.5).hit(), degrees > 120);
    }
}


TEST(wallSearch, oppositionGrowsFrom110To130Degrees)
{
    const wallSearch search(testSurfaces::cube(3));
    const label top =
        search.nearestOpposite(point(0.5, 0.45, 1.2), 1, vector(0, 0, -1), 0)
       .index();
    scalar before = 0;

    for (const scalar degrees : {100.0, 109.0, 111.0, 120.0, 129.0, 131.0})
    {
        const scalar angle = degrees*constant::mathematical::pi/180;
        const vector d(std::sin(angle), 0, std::cos(angle));
        const scalar opposition = search.opposition(top, Zero, d);

        EXPECT_EQ(opposition > 0, degrees > 110);
        EXPECT_EQ(opposition < 1, degrees < 130);
        EXPECT_GE(opposition, before);
        before = opposition;
    }
}


//- The nearest points of many triangles are the same: the first one counts, on
//  the wall and on a part of it, whatever the tree is
TEST(wallSearch, theFirstOfEquallyNearTrianglesIsFound)
{
    const wallSurface wall(testSurfaces::sphere(6));
    const boundBox half(point(0, -1, -1), point(1, 1, 1));
    const surfacePart part(makeSurfacePart(wall, facesIn(wall, half)));
    const wallSearch onWall(wall);
    const wallSearch onPart(part.surface);
    label nTies = 0;

    forAll(part.points, i)
    {
        const point& p = wall.points[part.points[i]];
        if (p.x() < 0.3)
        {
            continue;
        }

        // Outside of the sphere in front of a point, seen from the far side
        const point x(1.1*p);
        const vector d(-p);
        const pointIndexHit a(onWall.nearestOpposite(x, 0.2, d, -0.5));
        const pointIndexHit b(onPart.nearestOpposite(x, 0.2, d, -0.5));
        ASSERT_TRUE(a.hit());
        ASSERT_TRUE(b.hit());
        EXPECT_EQ(a.rawPoint(), b.rawPoint());
        const face& f = wall.faces[a.index()];
        EXPECT_EQ
        (
            part.localPoints(f), labelList(part.surface.faces[b.index()])
        );
        for (label facei = 0; facei < a.index(); ++facei)
        {
            EXPECT_FALSE(wall.faces[facei].found(part.points[i]));
        }
        nTies += f.found(part.points[i]);
    }
    EXPECT_GT(nTies, 10);
}


// ************************************************************************* //
