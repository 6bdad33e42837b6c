/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "orientOpenWall.H"
#include "openSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The four sides of the column over the unit square
static List<sidePatch> columnPlanes()
{
    return List<sidePatch>
    ({
        symmetryPlane("west", Zero, vector(-1, 0, 0)),
        symmetryPlane("east", point(1, 0, 0), vector(1, 0, 0)),
        symmetryPlane("south", Zero, vector(0, -1, 0)),
        symmetryPlane("north", point(0, 1, 0), vector(0, 1, 0))
    });
}


//- A sheet with a hill
static wallSurface hill()
{
    wallSurface wall(sheet(8, 0));
    for (point& x : wall.points)
    {
        x.z() = 0.3*x.x()*(1 - x.x())*(1 + x.y());
    }

    return wall;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(orientOpenWall, bodiesOnPlanesAreTurnedOutwards)
{
    for (const label nPlanes : {1, 2})
    {
        const wallSurface body(nPlanes == 1 ? halfCube(4) : quarterCube(4));
        const List<sidePatch> planes
        (
            nPlanes == 1 ? halfPlanes() : quarterPlanes()
        );

        wallSurface good(body);
        EXPECT_EQ(orientOpenWall(good, planes, true), 0);
        EXPECT_EQ(good.faces, body.faces);

        wallSurface turned(reversed(body));
        EXPECT_EQ(orientOpenWall(turned, planes, true), body.faces.size());
        EXPECT_EQ(turned.faces, body.faces);
    }
}


TEST(orientOpenWall, bodiesAreTurnedToTheFluidInside)
{
    wallSurface wall(quarterCube(4));
    EXPECT_EQ
    (
        orientOpenWall(wall, quarterPlanes(), false), wall.faces.size()
    );
    EXPECT_NEAR(volumeTo(wall, Zero), -0.25, 1e-15);
    EXPECT_EQ(orientOpenWall(wall, quarterPlanes(), false), 0);
}


TEST(orientOpenWall, placeFarFromTheOriginDoesNotMatter)
{
    const vector by(1000, 2000, -3000);
    List<sidePatch> planes(quarterPlanes());
    for (sidePatch& plane : planes)
    {
        plane.origin += by;
    }

    wallSurface wall(translated(reversed(quarterCube(4)), by));
    EXPECT_EQ(orientOpenWall(wall, planes, true), wall.faces.size());
    EXPECT_EQ(orientOpenWall(wall, planes, true), 0);
}


TEST(orientOpenWall, originOfAPlaneDoesNotMatter)
{
    List<sidePatch> planes(quarterPlanes());
    planes[0].origin = point(-70, 30, 0);
    planes[1].origin = point(10, 0, 50);

    wallSurface wall(reversed(quarterCube(4)));
    EXPECT_EQ(orientOpenWall(wall, planes, true), wall.faces.size());
    wallSurface half(reversed(halfCube(4)));
    planes.setSize(1);
    EXPECT_EQ(orientOpenWall(half, planes, true), half.faces.size());
}


TEST(orientOpenWall, groundKeepsTheOrderOfItsFile)
{
    for (const wallSurface& ground : {sheet(4, 0), hill()})
    {
        wallSurface up(ground), down(reversed(ground));

        EXPECT_EQ(orientOpenWall(up, columnPlanes(), true), 0);
        EXPECT_EQ(orientOpenWall(down, columnPlanes(), true), 0);
        EXPECT_EQ(up.faces, ground.faces);
        EXPECT_EQ(down.faces, reversed(ground).faces);
    }
}


TEST(orientOpenWall, groundIsTurnedForTheFluidInside)
{
    wallSurface ground(hill());

    EXPECT_EQ
    (
        orientOpenWall(ground, columnPlanes(), false), ground.faces.size()
    );
    EXPECT_EQ(ground.faces, reversed(hill()).faces);
}


TEST(orientOpenWall, closedBodiesBesideAnOpenOneAreBodies)
{
    // Their normals point outwards, as after reading
    const wallSurface ball(translated(sphere(4, 0.2), vector(0.5, 0.5, 2)));
    const wallSurface open(halfCube(4));

    wallSurface outside(merge(reversed(open), ball));
    EXPECT_EQ
    (
        orientOpenWall(outside, halfPlanes(), true), open.faces.size()
    );
    EXPECT_EQ(outside.faces, merge(open, ball).faces);

    wallSurface inside(merge(open, reversed(ball)));
    EXPECT_EQ
    (
        orientOpenWall(inside, halfPlanes(), false), inside.faces.size()
    );
    EXPECT_EQ(inside.faces, merge(reversed(open), ball).faces);
}


TEST(orientOpenWall, componentsWithinOthersAreTheOtherWayRound)
{
    // Half of a hollow cube, with a ball in its cavity
    const wallSurface outer(halfCube(4));
    wallSurface inner(outer);
    const point centre(boundBox(outer.points).centre());
    for (point& x : inner.points)
    {
        // On the plane as before
        const scalar z = x.z();
        x = centre + 0.7*(x - centre);
        x.z() = mag(z - halfPlanes()[0].origin.z()) < 1e-12 ? z : x.z();
    }
    const wallSurface ball(translated(sphere(4, 0.05), centre));

    // The fluid is around the shell and in its cavity, or in the shell
    wallSurface outside(merge(merge(outer, inner), ball));
    orientOpenWall(outside, halfPlanes(), true);
    EXPECT_EQ
    (
        outside.faces, merge(merge(outer, reversed(inner)), ball).faces
    );

    wallSurface inside(merge(merge(outer, inner), reversed(ball)));
    orientOpenWall(inside, halfPlanes(), false);
    EXPECT_EQ
    (
        inside.faces,
        merge(merge(reversed(outer), inner), reversed(ball)).faces
    );
}


TEST(orientOpenWall, closedSurfacesStay)
{
    wallSurface inwards(reversed(sphere(4)));

    EXPECT_EQ(orientOpenWall(inwards, halfPlanes(), true), 0);
    EXPECT_EQ(orientOpenWall(inwards, List<sidePatch>(), true), 0);
    EXPECT_EQ(inwards.faces, reversed(sphere(4)).faces);
}


// ************************************************************************* //
