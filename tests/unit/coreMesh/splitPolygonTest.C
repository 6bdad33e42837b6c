/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planeOutlines.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(splitPolygon, pointsOnEdgesGetTrianglesWithArea)
{
    // A square with a point on the middle of each edge
    const pointField points
    ({
        point(0, 0, 0), point(1, 0, 0), point(2, 0, 0), point(2, 1, 0),
        point(2, 2, 0), point(1, 2, 0), point(0, 2, 0), point(0, 1, 0)
    });
    const faceList triangles(splitPolygon(points, face(identity(8))));
    ASSERT_EQ(triangles.size(), 6);

    scalar area = 0;
    for (const face& f : triangles)
    {
        EXPECT_GT(f.areaNormal(points).z(), 0.4);
        area += f.areaNormal(points).z();
    }
    EXPECT_NEAR(area, 4, 1e-12);
}


TEST(splitPolygon, aNotchIsNotCovered)
{
    const pointField points
    ({
        point(0, 0, 0), point(4, 0, 0), point(4, 4, 0), point(2, 1, 0),
        point(0, 4, 0)
    });

    for (const face& f : splitPolygon(points, face(identity(5))))
    {
        EXPECT_GT(f.areaNormal(points).z(), 0);
    }
}


TEST(splitPolygon, aTriangleStays)
{
    const pointField points({point(0, 0, 0), point(1, 0, 0), point(0, 1, 0)});
    const faceList triangles(splitPolygon(points, face({2, 0, 1})));

    ASSERT_EQ(triangles.size(), 1);
    EXPECT_EQ(face::compare(triangles[0], face({0, 1, 2})), 1);
}


// ************************************************************************* //
