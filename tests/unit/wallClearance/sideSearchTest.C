/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "openSurfaces.H"
#include "wallSearch.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(sideSearch, pointsNearAPlaneArePutOnIt)
{
    const wallSurface wall(endedOn(quarterCube(4), quarterPlanes()));
    const sideSearch search(wall.border.sides);
    const point from(1, 0.25, 0.25);
    labelPair sides;

    point inside(1.5, 0.3, 0.4);
    EXPECT_TRUE(search.putOnSides(from, 0.1, inside, sides));
    EXPECT_EQ(inside, point(1.5, 0.3, 0.4));
    EXPECT_EQ(sides, labelPair(-1, -1));

    for (const scalar off : {0.05, -0.05})
    {
        point x(1.5, 0.3, off);
        EXPECT_TRUE(search.putOnSides(from, 0.1, x, sides));
        EXPECT_EQ(x, point(1.5, 0.3, 0));
        EXPECT_EQ(sides, labelPair(0, -1));
    }

    point both(1.5, 0.05, -0.05);
    EXPECT_TRUE(search.putOnSides(from, 0.1, both, sides));
    EXPECT_EQ(both, point(1.5, 0, 0));
    EXPECT_EQ(sides, labelPair(0, 1));

    point beyond(1.5, 0.3, -0.2);
    EXPECT_FALSE(search.putOnSides(from, 0.1, beyond, sides));
}


TEST(sideSearch, pointsNearObliquePlanesArePutOnTheirLine)
{
    wallSurface wall(endedOn(quarterCube(4), quarterPlanes()));
    wall.border.sides[1].normal = normalised(vector(0, -0.2, -1));
    const sideSearch search(wall.border.sides);
    labelPair sides;

    point x(1.5, 0.05, 0.05);
    EXPECT_TRUE(search.putOnSides(point(1, 0.25, 0.25), 0.1, x, sides));
    EXPECT_EQ(sides, labelPair(0, 1));

    for (const label s : {0, 1})
    {
        EXPECT_LT(mag(wall.border.sides[s].distance(x)), 1e-16);
    }
}


TEST(sideSearch, pointsBeyondAPartAreThoseBehindIt)
{
    // The square [0, 1]^2 of the plane z = 0
    const wallSurface square(sheet(1, 0));
    List<sidePatch> sides(1, halfPlanes()[0]);
    sides[0].points = square.points;
    sides[0].faces = square.faces;
    const sideSearch search(sides);
    labelPair on;

    point through(0.6, 0.5, -0.5);
    EXPECT_FALSE
    (
        search.putOnSides(point(0.5, 0.5, 0.2), 0.1, through, on)
    );

    point beside(1.8, 0.5, -0.5);
    EXPECT_TRUE(search.putOnSides(point(1.7, 0.5, 0.2), 0.1, beside, on));
    EXPECT_EQ(beside, point(1.8, 0.5, -0.5));
}


// ************************************************************************* //
