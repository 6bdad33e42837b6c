/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallClearance.H"
#include "prismLayerControls.H"
#include "testSurfaces.H"
#include "unitConversion.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static scalarField clearanceOf(const wallSurface& wall, const scalar reach)
{
    return makeWallClearance
    (
        wall,
        wallSearch(wall),
        makeWallVisibility(wall, makeWallAddressing(wall)),
        scalarField(wall.points.size(), reach)
    );
}


static bool between(const scalar a, const scalar x, const scalar b)
{
    return x > a && x < b;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(wallClearance, convexBodyHasAllItReachesFor)
{
    for (const wallSurface& wall :
        {testSurfaces::cube(3), testSurfaces::sphere(6)})
    {
        for (const scalar c : clearanceOf(wall, 5))
        {
            EXPECT_EQ(c, 5);
        }
    }
}


TEST(wallClearance, rightAngledConcaveEdgeDoesNotLimit)
{
    for (const scalar c : clearanceOf(testSurfaces::lBlock(6), 0.3))
    {
        EXPECT_EQ(c, 0.3);
    }
}


TEST(wallClearance, slitOfWidthGivesHalfOfIt)
{
    const scalar width = 0.1;
    const wallSurface wall(testSurfaces::slitBlock(8, width));
    const scalarField clearance(clearanceOf(wall, 0.5));
    label nInside = 0;

    forAll(wall.points, p)
    {
        const point& x = wall.points[p];

        if
        (
            mag(mag(x.x() - 1) - 0.5*width) < 1e-9
         && between(1.1, x.y(), 1.9) && between(0.1, x.z(), 0.9)
        )
        {
            ++nInside;

            // Rounds end where they gain less than 1e-6
            EXPECT_NEAR(clearance[p], 0.5*width, 2e-6*width);
        }
    }

    EXPECT_GT(nInside, 20);
}


TEST(wallClearance, roomBetweenBodiesIsHalfTheirDistance)
{
    const wallSurface box(testSurfaces::cube(4));
    const wallSurface wall
    (
        testSurfaces::merge
        (
            box, testSurfaces::translated(box, vector(1.2, 0, 0))
        )
    );
    const scalarField clearance(clearanceOf(wall, 2));

    forAll(wall.points, p)
    {
        const point& x = wall.points[p];
        const bool inner =
            between(0.1, x.y(), 0.9) && between(0.1, x.z(), 0.9);

        if (inner && between(0.9, x.x(), 1.3))
        {
            EXPECT_NEAR(clearance[p], 0.1, 1e-6);
        }
        if (inner && !between(-0.1, x.x(), 2.1))
        {
            EXPECT_EQ(clearance[p], 2);
        }
    }
}


TEST(wallClearance, ballInAcuteEdgeTouchesBothSides)
{
    // The ball that touches one side at the distance s from the edge touches
    // the other there too: its radius is s*std::tan(angle/2)
    const scalar tanHalf = std::tan(0.125*constant::mathematical::pi);
    const wallSurface wall(testSurfaces::wedgeBlock(10, 45));
    const scalarField clearance(clearanceOf(wall, 1));
    label nInside = 0;

    forAll(wall.points, p)
    {
        const point& x = wall.points[p];
        const scalar s = std::hypot(x.x() - 1, x.y() - 1);

        if
        (
            mag(mag(x.x() - 1) - tanHalf*(x.y() - 1)) < 1e-9
         && between(0.2, s, 0.9) && between(0.4, x.z(), 0.6)
        )
        {
            ++nInside;
            EXPECT_NEAR(clearance[p]/(s*tanHalf), 1, 1e-4);
        }
    }

    EXPECT_GT(nInside, 5);
}


TEST(wallClearance, sidesThatAreOppositeInPartTakePartOfTheRoom)
{
    // The room changes by little from 59.99 to 60.01 degrees, and falls from
    // all of the reach at 75 to that of the ball at 45
    const scalar reach = 1;
    scalarField rooms;

    for (const scalar degrees : {75.0, 60.01, 59.99, 45.0})
    {
        const scalar tanHalf =
            std::tan(0.5*degrees*constant::mathematical::pi/180);
        const wallSurface wall(testSurfaces::wedgeBlock(10, degrees));
        const scalarField clearance(clearanceOf(wall, reach));
        scalar smallest = GREAT;

        forAll(wall.points, p)
        {
            const point& x = wall.points[p];

            if
            (
                mag(mag(x.x() - 1) - tanHalf*(x.y() - 1)) < 1e-9
             && between(0.2, x.y() - 1, 0.5) && between(0.4, x.z(), 0.6)
            )
            {
                smallest = min(smallest, clearance[p]);
            }
        }
        rooms.append(smallest);
    }

    EXPECT_EQ(rooms[0], reach);
    EXPECT_NEAR(rooms[1], rooms[2], 2e-3);
    EXPECT_GT(rooms[1], rooms[3] + 0.2);
    EXPECT_LT(rooms[1], reach - 0.2);
}


TEST(wallClearance, ballHoldsNoOppositePoint)
{
    const wallSurface wall(testSurfaces::torus(24, 12, 1, 0.8));
    const wallSearch search(wall);
    const wallVisibility visibility
    (
        makeWallVisibility(wall, makeWallAddressing(wall))
    );
    const scalarField clearance
    (
        makeWallClearance
        (
            wall, search, visibility, scalarField(wall.points.size(), 1)
        )
    );
    label nLimited = 0;

    forAll(wall.points, p)
    {
        const visibilityCone& cone = visibility.cones[p];
        const scalar r = clearance[p];
        nLimited += r < 1;

        EXPECT_FALSE
        (
            search.nearestOpposite
            (
                wall.points[p] + r/cone.cosine*cone.axis,
                (1 - 1e-5)*r,
                cone.axis,
                clearanceControls::oppositeFully
            ).hit()
        );
    }

    EXPECT_GT(nLimited, 0);
}


TEST(wallClearance, scalesWithTheWall)
{
    const wallSurface wall(testSurfaces::slitBlock(4, 0.1));
    wallSurface scaled(wall);
    scaled.points *= 1e-3;

    const scalarField clearance(clearanceOf(wall, 0.5));
    const scalarField small(clearanceOf(scaled, 0.5e-3));

    EXPECT_LT(max(mag(1e3*small/clearance - 1)), 1e-5);
}


TEST(wallClearance, columnsEndHalfWayToPlanes)
{
    // A cube, and a plane at a distance of 0.3 above it
    const scalar distance = 0.3;
    const wallSurface wall(testSurfaces::cube(2));
    const wallVisibility visibility
    (
        makeWallVisibility(wall, makeWallAddressing(wall))
    );
    List<sidePatch> planes(1);
    sidePatch& plane = planes[0];
    plane.origin = point(0, 0, 1 + distance);
    plane.normal = vector(0, 0, 1);
    scalarField clearance(wall.points.size(), 10);
    boundByPlanes(planes, wall.points, visibility, clearance);

    forAll(wall.points, p)
    {
        const visibilityCone& cone = visibility.cones[p];
        const point& x = wall.points[p];
        const point end(x + clearance[p]/cone.cosine*cone.axis);
        if (clearance[p] < 10)
        {
            EXPECT_NEAR(plane.distance(end), 0.5*plane.distance(x), 1e-12);
        }
        else
        {
            EXPECT_LT(cone.axis.z(), 1e-12);
        }
    }
}


TEST(wallClearance, columnsThatMayBeLongerHaveLessRoom)
{
    // A tip of 30 degrees whose axis runs to a block at the distance 1: a ball
    // around the end of a column of the length s*r reaches (s + 1)*r
    const scalar half = ::tan(degToRad(scalar(15)));
    const wallSurface wall
    (
        testSurfaces::merge
        (
            testSurfaces::extruded
            (
                {vector2D(0, 0), vector2D(2, -2*half), vector2D(2, 2*half)},
                1, 0.25
            ),
            testSurfaces::translated
            (
                testSurfaces::cube(8, 4), vector(-5, -2, -1.5)
            )
        )
    );
    const wallAddressing addressing(makeWallAddressing(wall));
    const wallVisibility visibility(makeWallVisibility(wall, addressing));
    const label tip = wall.points.find(point(0, 0, 0.5));
    ASSERT_GE(tip, 0);

    const auto roomFor = [&](const scalar maxStretch)
    {
        return makeWallClearance
        (
            wall, wallSearch(wall), visibility,
            scalarField(wall.points.size(), 1), maxStretch
        )[tip];
    };

    EXPECT_NEAR(roomFor(2), 1.0/3, 1e-3);
    EXPECT_NEAR(roomFor(3), 1.0/4, 1e-3);
    EXPECT_NEAR(roomFor(10), 1/(1 + 1/::sin(degToRad(scalar(15)))), 1e-3);
}


// ************************************************************************* //
