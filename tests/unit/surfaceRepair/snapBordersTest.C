/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stitchSurface.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static wallSurface trianglesOn(const List<point>& points, const faceList& faces)
{
    wallSurface surface;
    surface.points = pointField(points);
    surface.faces = faces;

    return surface;
}


static scalar areaOf(const wallSurface& surface)
{
    scalar area = 0;
    for (const face& f : surface.faces)
    {
        area += f.mag(surface.points);
    }

    return area;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(snapBorders, nearPointsMoveToTheirMean)
{
    // Three triangles with a corner each at the origin, nearly
    wallSurface surface
    (
        trianglesOn
        (
            {
                point(0.03, 0, 0), point(1, 0, 0), point(1, 1, 0),
                point(0, 0.03, 0), point(0, 1, 0), point(-1, 1, 0),
                point(0, 0, 0.03), point(-1, -1, 0), point(0, -1, 0)
            },
            {face({0, 1, 2}), face({3, 4, 5}), face({6, 7, 8})}
        )
    );
    snapBorders(surface, 0.1);

    for (const label p : {0, 3, 6})
    {
        EXPECT_NEAR(mag(surface.points[p] - point::uniform(0.01)), 0, 1e-15);
    }
    EXPECT_EQ(surface.points[1], point(1, 0, 0));
    EXPECT_EQ(surface.faces.size(), 3);
}


TEST(snapBorders, edgesAreDividedAtPointsOfOthers)
{
    // Across a gap of 0.01 the lower triangle has two points more, one of them
    // twice, and its neighbour shares an edge that is divided as well
    wallSurface surface
    (
        trianglesOn
        (
            {
                point(0, 0.01, 0), point(3, 0.01, 0), point(0, 2, 0),
                point(0, 0, 0), point(1, 0, 0), point(0, -1, 0),
                point(1, 0, 0), point(2, 0, 0), point(1.5, -1, 0),
                point(-0.01, 1, 0), point(-1, 1, 0), point(-1, 0.9, 0)
            },
            {
                face({0, 1, 2}), face({5, 4, 3}), face({8, 7, 6}),
                face({9, 10, 11})
            }
        )
    );
    const scalar area = areaOf(surface);
    snapBorders(surface, 0.1);

    // At (1 0), (2 0) and (0 1)
    ASSERT_EQ(surface.points.size(), 12 + 3);
    EXPECT_EQ(surface.faces.size(), 4 + 3);
    EXPECT_NEAR(areaOf(surface), area, 0.05);
    EXPECT_EQ(surface.points[12], point(1, 0, 0));
    EXPECT_EQ(surface.points[13], point(2, 0, 0));
    EXPECT_EQ(surface.points[14], point(-0.01, 1, 0));

    for (const face& f : surface.faces)
    {
        EXPECT_GT(f.mag(surface.points), 0.01);
    }
}


TEST(snapBorders, edgesShorterThanTheGapStay)
{
    const wallSurface given
    (
        trianglesOn
        (
            {point(0, 0, 0), point(0.05, 0, 0), point(0, 1, 0)},
            {face({0, 1, 2})}
        )
    );
    wallSurface surface(given);
    snapBorders(surface, 0.1);

    EXPECT_EQ(surface.points, given.points);
    EXPECT_EQ(surface.faces, given.faces);
}


TEST(snapBorders, edgesWithTwoFacesStay)
{
    // The points 1 and 3 are near, but the edge between the others is inside
    const wallSurface given
    (
        trianglesOn
        (
            {
                point(0, 0, 0), point(0.04, 0.5, 0), point(0, 1, 0),
                point(-0.04, 0.5, 0)
            },
            {face({0, 1, 2}), face({0, 2, 3})}
        )
    );
    wallSurface surface(given);
    snapBorders(surface, 0.01);

    EXPECT_EQ(surface.points, given.points);
    EXPECT_EQ(surface.faces, given.faces);
}


// ************************************************************************* //
