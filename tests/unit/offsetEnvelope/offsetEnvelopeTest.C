/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pointOrder.H"
#include "testStages.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using testSurfaces::stages;

static bool between(const scalar a, const scalar x, const scalar b)
{
    return x > a && x < b;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(offsetEnvelope, radiusIsScaledThickness)
{
    const stages s(testSurfaces::sphere(8), 5, 0.1);

    EXPECT_NEAR(min(s.envelope.radius), 1.1*0.1, 1e-15);
    EXPECT_NEAR(max(s.envelope.radius), 1.1*0.1, 1e-15);
}


TEST(offsetEnvelope, radiusIsAtMostTheClearance)
{
    const stages s(testSurfaces::slitBlock(8, 0.1), 5, 0.2);

    EXPECT_LT(min(s.clearance), 0.06);
    label nLower = 0;
    forAll(s.envelope.radius, p)
    {
        const scalar wanted =
            min(1.1*s.spacing.thickness[p], s.clearance[p]);
        EXPECT_LE(s.envelope.radius[p], wanted);
        nLower += s.envelope.radius[p] < wanted;

        for (const label q : s.context.addressing.pointPoints[p])
        {
            EXPECT_LE
            (
                s.envelope.radius[p],
                s.envelope.radius[q] + SMALL
              + sheetControls::maxSlope*mag(s.wall.points[p] - s.wall.points[q])
            );
        }
    }

    // Only beside the mouth of the slit
    EXPECT_GT(nLower, 0);
    EXPECT_LT(nLower, s.wall.points.size()/2);
}


TEST(offsetEnvelope, envelopeOfSphereIsASphere)
{
    const stages s(testSurfaces::sphere(12), 5, 0.1);

    ASSERT_GT(s.envelope.nEnvelope, 0);
    for (label i = 0; i < s.envelope.nEnvelope; ++i)
    {
        // The facets are as far inside the sphere as this
        EXPECT_NEAR((mag(s.envelope.points[i]) - 1)/0.11, 1, 0.01);
        EXPECT_NEAR(s.envelope.gaps[i], 0.11, 1e-12);
    }
}


TEST(offsetEnvelope, sheetsHalveTheHeight)
{
    // Edges are 0.065 long: sheets at 0.33, 0.165 and 0.0825
    const stages s(testSurfaces::sphere(24), 5, 0.3);
    boolList found(3, false);

    forAll(s.envelope.points, i)
    {
        const scalar height = mag(s.envelope.points[i]) - 1;
        const label sheet = label(std::log2(0.33/height) + 0.5);

        ASSERT_LT(sheet, 3);
        EXPECT_NEAR(height*std::ldexp(1.0, sheet)/0.33, 1, 0.02);
        EXPECT_EQ(sheet == 0, i < s.envelope.nEnvelope);
        found[sheet] = true;
    }

    EXPECT_EQ(found, boolList(3, true));
}


TEST(offsetEnvelope, noPointIsNearTheWall)
{
    for (const wallSurface& wall :
        {
            testSurfaces::cube(4),
            testSurfaces::lBlock(6),
            testSurfaces::wedgeBlock(6, 45),
            testSurfaces::slitBlock(6, 0.1),
            testSurfaces::torus(24, 12, 1, 0.8)
        })
    {
        const stages s(wall, 5, 0.15);

        ASSERT_GT(s.envelope.nEnvelope, 0);
        for (label i = 0; i < s.envelope.nEnvelope; ++i)
        {
            const scalar height = s.envelope.gaps[i];
            EXPECT_FALSE
            (
                s.context.search().nearer
                (
                    s.envelope.points[i], (0.7 - 1e-9)*height
                )
            );
        }
    }
}


TEST(offsetEnvelope, pointsOfASheetAreApart)
{
    const stages s(testSurfaces::sphere(16), 5, 0.1);
    const scalar density = backgroundMeshControls().radiusEdgeRatio;

    for (label i = 0; i < s.envelope.nEnvelope; ++i)
    {
        for (label j = 0; j < i; ++j)
        {
            EXPECT_GE
            (
                mag(s.envelope.points[i] - s.envelope.points[j]),
                density*0.11 - 1e-12
            );
        }
    }
}


TEST(offsetEnvelope, pointsInASlitAreHalfWay)
{
    const scalar width = 0.1;
    const stages s(testSurfaces::slitBlock(8, width), 5, 0.2);
    label nInside = 0;

    for (label i = 0; i < s.envelope.nEnvelope; ++i)
    {
        const point& x = s.envelope.points[i];

        if
        (
            mag(x.x() - 1) < 0.5*width
         && between(1.2, x.y(), 1.8) && between(0.2, x.z(), 0.8)
        )
        {
            ++nInside;
            EXPECT_NEAR(x.x(), 1, 1e-5*width);
        }
    }

    EXPECT_GT(nInside, 20);
}


TEST(offsetEnvelope, noMorePointsThanTheWallNeeds)
{
    for (const label n : {8, 16, 32})
    {
        const stages s(testSurfaces::sphere(n), 5, 0.1);

        EXPECT_LT(s.envelope.points.size(), 3*s.wall.points.size());
    }
}


TEST(offsetEnvelope, surroundsEdgesAndCornersOfACube)
{
    // Every direction from the centre has a point of the envelope nearby
    const stages s(testSurfaces::cube(6), 5, 0.15);
    const point centre(0.5, 0.5, 0.5);

    for (const point& x : testSurfaces::sphere(6).points)
    {
        scalar largest = -1;
        for (label i = 0; i < s.envelope.nEnvelope; ++i)
        {
            const vector d(normalised(s.envelope.points[i] - centre));
            largest = max(largest, d & x);
        }

        // Points are 0.18 apart at 0.65 or more from the centre
        EXPECT_GT(largest, std::cos(0.3));
    }
}


//- The points of the envelope and of the other sheets, each by place
static pointField sortedPoints(const offsetEnvelope& envelope)
{
    pointField points(envelope.points);
    const auto middle = points.begin() + envelope.nEnvelope;
    std::sort(points.begin(), middle, isBefore);
    std::sort(middle, points.end(), isBefore);

    return points;
}


TEST(offsetEnvelope, doesNotDependOnTheNumbering)
{
    for (const wallSurface& wall :
        {
            testSurfaces::lBlock(8),
            testSurfaces::slitBlock(8, 0.15),
            testSurfaces::wedgeBlock(8, 60),
            testSurfaces::torus(24, 12, 1, 0.8),
            testSurfaces::screw(point(0.3, 0.1, 0)),
            testSurfaces::quadCube(6)
        })
    {
        const stages a(wall, 5, 0.2);
        const stages b(testSurfaces::renumbered(wall, 3), 5, 0.2);
        const pointField inA(sortedPoints(a.envelope));
        const pointField inB(sortedPoints(b.envelope));

        ASSERT_EQ(a.envelope.nEnvelope, b.envelope.nEnvelope);
        ASSERT_EQ(inA.size(), inB.size());

        // The nearest point on an edge is found on one of its two triangles,
        // with another rounding on each
        EXPECT_LT(max(mag(inA - inB)), 1e-14);
    }
}


TEST(offsetEnvelope, everyPointOnAConcaveEdgeHasItsOwn)
{
    // The edge has points 0.125 apart; the envelope is 0.11 above the faces
    const stages s(testSurfaces::lBlock(8), 5, 0.1);
    label nAbove = 0;

    for (label i = 0; i < s.envelope.nEnvelope; ++i)
    {
        const point& x = s.envelope.points[i];
        nAbove += mag(x.x() - 1.11) < 1e-9 && mag(x.y() - 1.11) < 1e-9
            && x.z() > 0 && x.z() < 1;
    }

    EXPECT_EQ(nAbove, 7);
}


// ************************************************************************* //
