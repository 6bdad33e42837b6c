/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "openSurfaces.H"
#include "wallVisibility.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static wallVisibility conesOf(const wallSurface& wall)
{
    return makeWallVisibility(wall, makeWallAddressing(wall));
}


//- The body of which halfCube and quarterCube are parts
static wallSurface wholeCube(const bool isQuarter)
{
    return translated(quadCube(4), vector(0, isQuarter ? -0.5 : 0, -0.5));
}


//- The same axes and cosines at the same places as on another wall
static void expectSameCones(const wallSurface& part, const wallSurface& whole)
{
    const wallVisibility ofPart(conesOf(part));
    const wallVisibility ofWhole(conesOf(whole));

    forAll(part.points, p)
    {
        const label q = whole.points.find(part.points[p]);
        ASSERT_GE(q, 0);
        EXPECT_LT(mag(ofPart.cones[p].axis - ofWhole.cones[q].axis), 1e-12);
        EXPECT_NEAR(ofPart.cones[p].cosine, ofWhole.cones[q].cosine, 1e-12);
        EXPECT_LT
        (
            mag(ofPart.meanNormals[p] - ofWhole.meanNormals[q]), 1e-12
        );
    }
}


//- A body between planes at an angle of 60 degrees
static wallSurface sector()
{
    wallSurface wall(quarterCube(4));
    const scalar skew = 1/::sqrt(3.0);
    for (point& x : wall.points)
    {
        x.y() += skew*x.z();
    }

    return wall;
}


static List<sidePatch> sectorPlanes()
{
    List<sidePatch> planes(halfPlanes());
    planes.append
    (
        symmetryPlane
        (
            "side", Zero, normalised(vector(0, -1, 1/::sqrt(3.0)))
        )
    );

    return planes;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(sideCones, equalTheWholeBody)
{
    expectSameCones(endedOn(halfCube(4), halfPlanes()), wholeCube(false));
    expectSameCones
    (
        endedOn(quarterCube(4), quarterPlanes()), wholeCube(true)
    );
}


TEST(sideCones, awayFromTheBorderEqualThoseWithoutOne)
{
    const wallSurface wall(endedOn(halfSphere(6), halfPlanes()));
    const wallVisibility ended(conesOf(wall));
    const wallVisibility open(conesOf(halfSphere(6)));

    forAll(wall.points, p)
    {
        const bool onBorder = wall.points[p].z() == 0;
        EXPECT_EQ
        (
            ended.cornerNormals[p].size(),
            (onBorder ? 2 : 1)*open.cornerNormals[p].size()
        );
        EXPECT_TRUE(onBorder || ended.cones[p].axis == open.cones[p].axis);
    }
}


TEST(sideCones, axesOnAPlaneAreInIt)
{
    const wallSurface wall(endedOn(halfSphere(6), halfPlanes()));
    const wallVisibility visibility(conesOf(wall));
    label n = 0;

    forAll(wall.points, p)
    {
        const vector& axis = visibility.cones[p].axis;
        EXPECT_GT(visibility.cones[p].cosine, 0.9);

        if (wall.points[p].z() == 0)
        {
            EXPECT_NEAR(axis.z(), 0, 1e-14);
            EXPECT_GT(axis & wall.points[p], 0.98);
            ++n;
        }
    }

    EXPECT_EQ(n, 24);
    EXPECT_TRUE(visibility.sideLines.empty());
}


TEST(sideCones, axesOnTwoPlanesAreOnTheirLine)
{
    const wallSurface wall(endedOn(sector(), sectorPlanes()));
    const wallVisibility visibility(conesOf(wall));
    ASSERT_EQ(visibility.sideLines.size(), wall.points.size());
    label n = 0;

    forAll(wall.points, p)
    {
        const point& x = wall.points[p];

        if (mag(x.y()) + mag(x.z()) < SMALL)
        {
            // Out of the ends x = 0 and x = 1 of the body
            const vector line(x.x() > 0.5 ? 1 : -1, 0, 0);
            EXPECT_LT(mag(visibility.sideLines[p] - line), 1e-15);
            EXPECT_LT(mag(visibility.cones[p].axis - line), 1e-15);
            EXPECT_NEAR(visibility.cones[p].cosine, 1, 1e-15);
            // A normal, and its reflections in one plane and in both
            EXPECT_EQ(visibility.cornerNormals[p].size(), 4);
            ++n;
        }
        else
        {
            EXPECT_EQ(visibility.sideLines[p], vector::zero);
        }
    }

    EXPECT_EQ(n, 2);
}


TEST(sideCones, rampIsAWedgeWithItsImage)
{
    // A ramp that meets the plane z = 0 at 60 degrees, above or below it
    for (const bool below : {false, true})
    {
        wallSurface ramp(sheet(2, 0));
        for (point& x : ramp.points)
        {
            x.z() = (below ? -1 : 1)*::sqrt(3.0)*x.x();
        }
        ramp.patchNames[0] = "ramp";
        ramp.border.sides = halfPlanes();
        ramp.border.sides.append
        (
            symmetryPlane("around", point(1, 0.5, 0), vector(1, 0, 0))
        );
        ramp.border.edges = outline(ramp.faces);
        for (const edge& e : ramp.border.edges)
        {
            ramp.border.edgeSides.append
            (
                e.centre(ramp.points).x() == 0 ? 0 : 1
            );
        }
        ramp.border.sides[0].normal.z() = below ? 1 : -1;

        const wallVisibility visibility(conesOf(ramp));
        const label p = ramp.points.find(point(0, 0.5, below ? -0. : 0.));
        ASSERT_GE(p, 0);
        EXPECT_NEAR(visibility.cones[p].axis.z(), 0, 1e-15);
        EXPECT_NEAR
        (
            visibility.cones[p].axis.x(), below ? 1 : -1, 1e-15
        );
        EXPECT_NEAR(visibility.cones[p].cosine, ::sqrt(0.75), 1e-15);
    }
}


// ************************************************************************* //
