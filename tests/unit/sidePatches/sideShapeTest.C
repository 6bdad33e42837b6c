/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "openSurfaces.H"
#include "sidePatch.H"
#include "sideShape.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const sidePatch& inletOf(const wallSurface& wall)
{
    for (const sidePatch& side : wall.border.sides)
    {
        if (side.name == "inlet")
        {
            return side;
        }
    }

    return wall.border.sides[0];
}


//- The unit normal of the inlet of bulgedDuct, out of the fluid
static vector bulgeNormal(const point& x)
{
    return -normalised(vector(1, 0.8*(0.5 - x.y()), 0.8*(0.5 - x.z())));
}


static wallSurface endedDuct(const label n)
{
    return endedOn(bulgedDuct(n), wordList({"inlet", "outlet"}));
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(sideShape, nearestPointsAreOnTheFaces)
{
    const wallSurface wall(endedDuct(8));
    const sidePatch& inlet = inletOf(wall);
    ASSERT_TRUE(inlet.isCurved());

    for (const point& x : inlet.points)
    {
        EXPECT_EQ(inlet.shape->nearest(x).rawPoint(), x);

        // Chords of faces 1/8 wide are at most that far from the paraboloid
        const point off(x - 0.1*bulgeNormal(x));
        const point on(inlet.shape->nearest(off).rawPoint());
        EXPECT_NEAR(on.x(), bulgeAt(on), 0.4*2*sqr(0.125)/4 + 1e-12);
        EXPECT_FALSE(inlet.shape->nearest(off, 0.05).hit());
    }
}


TEST(sideShape, tangentPlanesAreThoseOfTheSurface)
{
    const wallSurface wall(endedDuct(16));
    const sidePatch& inlet = inletOf(wall);

    for (const point& x : inlet.points)
    {
        // On the outline half of the faces are missing
        const sidePlane plane(inlet.planeAt(x));
        EXPECT_GT(plane.normal & bulgeNormal(x), 0.998);
        EXPECT_NEAR(mag(plane.normal), 1, 1e-14);
        EXPECT_NEAR(plane.distance(x), 0, 1e-15);
    }
    for (const scalar d : {-0.05, 0.05})
    {
        const point x(-0.2 - d, 0.5, 0.5);
        EXPECT_NEAR(inlet.distance(x), d, 1e-3);
    }
}


TEST(sideShape, pointsAlongALineStayBesideEachOther)
{
    const wallSurface wall(endedDuct(8));
    const sideShape& shape = *inletOf(wall).shape;
    const vector along(1, 0, 0);

    for (const scalar d : {-0.1, 0.1})
    {
        const point x(d, 0.3, 0.6);
        const point on(shape.along(x, along, 0.5));
        EXPECT_NEAR(on.y(), x.y(), 1e-15);
        EXPECT_NEAR(on.z(), x.z(), 1e-15);
        EXPECT_NEAR(on.x(), bulgeAt(x), 0.4*2*sqr(0.125)/4);

        // Too near, or beside the faces
        EXPECT_EQ(shape.along(x, along, 0.01), shape.nearest(x).rawPoint());
        const point beside(d, 1.2, 0.6);
        EXPECT_NEAR(shape.along(beside, along, 0.5).y(), 1, 1e-15);
    }
}


TEST(sideShape, normalsOfEdgesAreTheMeanOfTheirFaces)
{
    // A roof of two faces with the ridge along y; the fluid is below
    const sideShape roof
    (
        pointField({{-1, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 0}}),
        faceList({face({0, 2, 1}), face({1, 2, 3})})
    );
    const sidePlane plane(roof.planeAt(point(0, 0.4, 2)));

    EXPECT_LT(mag(plane.origin - point(0, 0.4, 1)), 1e-15);
    EXPECT_GT(plane.normal.z(), 0.9);
    EXPECT_NEAR(plane.distance(point(0, 0.4, 2)), plane.normal.z(), 1e-15);
}


TEST(sideCurve, followsTheEdgesOfAPartAndAPlane)
{
    const wallSurface wall(halfOf(bulgedDuct(8)));
    const List<sidePatch>& sides = wall.border.sides;
    label inlet = 0, plane = 0;
    forAll(sides, s)
    {
        inlet = sides[s].name == "inlet" ? s : inlet;
        plane = sides[s].isPart() ? plane : s;
    }
    const point from(bulgeAt(point(0, 0.5, 0)), 0.5, 0);
    const sideCurve curve(sides[inlet], sides[plane], from);

    // Nine points from one side of the wall to the other
    ASSERT_EQ(curve.points().size(), 9);
    EXPECT_EQ(curve.points()[0], from);
    EXPECT_NEAR(curve.tangent() & vector(-0.4, 0, 1), std::sqrt(1.16), 0.01);
    for (const point& x : curve.points())
    {
        EXPECT_EQ(x.y(), 0.5);
        EXPECT_NEAR(x.x(), bulgeAt(x), 1e-15);
        EXPECT_EQ(curve.nearest(x), x);
    }

    scalar length = 0;
    for (label i = 1; i < 9; ++i)
    {
        length += mag(curve.points()[i] - curve.points()[i - 1]);
        EXPECT_NEAR(curve.lengthTo(curve.points()[i]), length, 1e-14);
    }
    const point x(-0.3, 0.9, 0.3);
    EXPECT_NEAR(curve.nearest(x).y(), 0.5, 1e-15);
    EXPECT_NEAR(curve.nearest(x).z(), 0.3, 0.05);
}


// ************************************************************************* //
