/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "openSurfaces.H"
#include "wallClearance.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A sheet that faces the symmetry plane z = 0 from a height
static wallSurface plateOver(const scalar height)
{
    wallSurface plate(reversed(sheet(4, height)));
    plate.border.sides = halfPlanes();

    return plate;
}


//- A part of a plane: the square [low, low + 1]^2 in z = 0
static sidePatch part(const scalar low)
{
    const wallSurface square(translated(sheet(1, 0), vector(low, low, 0)));
    sidePatch side(halfPlanes()[0]);
    side.points = square.points;
    side.faces = square.faces;

    return side;
}


static scalarField clearanceIn(const wallSurface& wall, const scalar reach)
{
    const wallSearch search(wall);

    return makeWallClearance
    (
        wall, search, makeWallVisibility(wall, makeWallAddressing(wall)),
        scalarField(wall.points.size(), reach)
    );
}


static pointIndexHit opposite(const wallSearch& search, const scalar distance)
{
    return search.nearestOpposite
    (
        point(0.3, 0.4, 0.25), distance, vector(0, 0, -1),
        clearanceControls::oppositeFrom
    );
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(mirrorImages, plateSeesItsOwnImage)
{
    const wallSurface plate(plateOver(0.25));
    const wallSearch search(plate);
    const pointIndexHit hit(opposite(search, 1));

    ASSERT_TRUE(hit.hit());
    EXPECT_LT(mag(hit.rawPoint() - point(0.3, 0.4, -0.25)), 1e-15);
    EXPECT_GE(hit.index(), 2*plate.faces.size());
    EXPECT_EQ(search.opposition(hit.index(), Zero, vector(0, 0, -1)), 1);
    EXPECT_EQ(search.opposition(hit.index(), Zero, vector(0, 0, 1)), 0);

    EXPECT_FALSE(opposite(search, 0.499).hit());
}


TEST(mirrorImages, plateHasTheRoomUpToThePlane)
{
    for (const scalar distance : {0.05, 0.2})
    {
        // As between the plate and one in the place of its image
        const wallSurface plate(plateOver(distance));
        wallSurface both(merge(plate, sheet(4, -distance)));
        both.border = wallBorder();

        const scalarField mirrored(clearanceIn(plate, 1));
        const scalarField slit(clearanceIn(both, 1));

        forAll(mirrored, p)
        {
            EXPECT_NEAR(mirrored[p], distance, 1e-9);
            EXPECT_NEAR(mirrored[p], slit[p], 1e-12);
        }
    }
}


TEST(mirrorImages, farPlanesLeaveTheReach)
{
    for (const scalar c : clearanceIn(plateOver(0.5), 0.4))
    {
        EXPECT_EQ(c, 0.4);
    }
}


TEST(mirrorImages, partsReflectOnlyWhereTheyAre)
{
    wallSurface plate(plateOver(0.25));
    plate.border.sides = List<sidePatch>(1, part(0));
    EXPECT_TRUE(opposite(wallSearch(plate), 1).hit());

    plate.border.sides = List<sidePatch>(1, part(5));
    EXPECT_FALSE(opposite(wallSearch(plate), 1).hit());
}


TEST(mirrorImages, nearerWallsHideTheImage)
{
    wallSurface walls(merge(plateOver(0.25), sheet(4, 0.1)));
    const wallSearch search(walls);
    const pointIndexHit hit(opposite(search, 1));

    EXPECT_LT(mag(hit.rawPoint() - point(0.3, 0.4, 0.1)), 1e-15);
    EXPECT_LT(hit.index(), 2*walls.faces.size());
}


TEST(mirrorImages, bodiesOnThePlaneDoNotSeeThemselves)
{
    // As the whole body, which is convex
    const wallSurface wall(endedOn(halfSphere(6), halfPlanes()));

    for (const scalar c : clearanceIn(wall, 2))
    {
        EXPECT_EQ(c, 2);
    }
}


// ************************************************************************* //
