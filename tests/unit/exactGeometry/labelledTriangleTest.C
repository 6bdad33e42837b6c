/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "labelledTriangle.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static labelledTriangle triangleOn
(
    const pointField& points,
    const label a,
    const label b,
    const label c,
    const label facei = 0
)
{
    return labelledTriangle
    {
        {a, b, c}, {points[a], points[b], points[c]}, facei
    };
}


//- Whether they intersect, which must not depend on order and rotation
static bool intersectAnyway
(
    const labelledTriangle& a,
    const labelledTriangle& b
)
{
    const bool result = intersect(a, b);

    for (int turn = 0; turn < 3; ++turn)
    {
        labelledTriangle turned(a);

        for (int k = 0; k < 3; ++k)
        {
            turned.labels[k] = a.labels[(k + turn) % 3];
            turned.points[k] = a.points[(k + turn) % 3];
        }

        EXPECT_EQ(intersect(turned, b), result);
        EXPECT_EQ(intersect(b, turned), result);
    }

    return result;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(orientation, isTheSignOfTheVolume)
{
    const point o(0.1, 0.2, 0.3), x(1.1, 0.2, 0.3), y(0.1, 1.2, 0.3);
    const point above(0.4, 0.4, ::nextafter(0.3, 1));

    EXPECT_EQ(orientation(o, x, y, above), 1);
    EXPECT_EQ(orientation(o, y, x, above), -1);
    EXPECT_EQ(orientation(o, x, y, point(7.7, -5.5, 0.3)), 0);
}


TEST(isCollinear, seesOneUnitInTheLastPlace)
{
    const point a(0.1, 0.1, 0.1), b(0.3, 0.3, 0.3), c(0.7, 0.7, 0.7);

    EXPECT_TRUE(isCollinear(a, b, c));
    EXPECT_TRUE(isCollinear(a, a, c));
    EXPECT_FALSE(isCollinear(a, b, point(0.7, ::nextafter(0.7, 1), 0.7)));
}


TEST(labelledTriangle, neighboursIntersectIfFolded)
{
    pointField points
    ({
        point(0, 0, 0), point(1, 0, 0), point(0.4, 0.5, 0), point(0.6, 0.3, 0)
    });
    const auto folded = [&]()
    {
        return intersectAnyway
        (
            triangleOn(points, 0, 1, 2), triangleOn(points, 1, 0, 3)
        );
    };

    EXPECT_TRUE(folded());

    points[3].z() = 1e-300;
    EXPECT_FALSE(folded());

    points[3] = point(0.6, -0.3, 0);
    EXPECT_FALSE(folded());
}


TEST(labelledTriangle, trianglesWithACommonPointIntersectBeyondIt)
{
    pointField points
    ({
        point(0, 0, 0), point(1, 0.5, 0), point(1, -0.5, 0),
        point(1, 0, -1), point(1, 0, 1)
    });
    const auto cut = [&]()
    {
        return intersectAnyway
        (
            triangleOn(points, 0, 1, 2), triangleOn(points, 0, 3, 4)
        );
    };

    EXPECT_TRUE(cut());

    // On the other side, and above the plane
    points[3].x() = points[4].x() = -1;
    EXPECT_FALSE(cut());

    points[3] = point(1, 0, 1e-300);
    points[4] = point(1, 0, 1);
    EXPECT_FALSE(cut());
}


TEST(labelledTriangle, othersIntersectIfTheyTouch)
{
    pointField points
    ({
        point(0, 0, 0), point(1, 0, 0), point(0, 1, 0),
        point(0.2, 0.2, 0), point(0.2, 0.2, 1), point(0.5, 0.2, 1)
    });
    const auto touch = [&]()
    {
        return intersectAnyway
        (
            triangleOn(points, 0, 1, 2), triangleOn(points, 3, 4, 5)
        );
    };

    EXPECT_TRUE(touch());

    points[3].z() = 1e-300;
    EXPECT_FALSE(touch());
}


TEST(labelledTriangle, trianglesOnTheSamePointsIntersect)
{
    const pointField points({point(0, 0, 0), point(1, 0, 0), point(0, 1, 0)});

    EXPECT_TRUE
    (
        intersectAnyway
        (
            triangleOn(points, 0, 1, 2), triangleOn(points, 1, 0, 2)
        )
    );
}


TEST(addIntersections, findsThePairsOfEachTwoTriangles)
{
    const wallSurface wall
    (
        testSurfaces::merge
        (
            testSurfaces::sphere(3),
            testSurfaces::translated(testSurfaces::sphere(3), vector(1, 0, 0))
        )
    );
    const auto triangles = labelledTriangles
    (
        wall.faces, wall.points, identity(wall.faces.size())
    );
    const size_t half = triangles.size()/2;
    const std::vector<labelledTriangle> first
    (
        triangles.begin(), triangles.begin() + half
    );
    const std::vector<labelledTriangle> second
    (
        triangles.begin() + half, triangles.end()
    );

    DynamicList<labelPair> expected, all, between;

    for (size_t i = 0; i < triangles.size(); ++i)
    {
        for (size_t j = i + 1; j < triangles.size(); ++j)
        {
            if (intersect(triangles[i], triangles[j]))
            {
                expected.append(labelPair(i, j));
            }
        }
    }

    // A pair that is there before is there once
    all.append(expected[0]);
    addIntersections(triangles, {}, all);
    addIntersections(first, second, between);

    EXPECT_GT(expected.size(), 10);
    EXPECT_EQ(all, expected);
    EXPECT_EQ(between, expected);
}


TEST(addIntersections, findsPairsAcrossTheSlabsOfManyTriangles)
{
    // A plane of 60,800 triangles, and one long triangle through 190 squares
    const label n = 190, m = 160;
    pointField points((n + 1)*(m + 1));
    DynamicList<face> faces;
    for (label i = 0; i <= n; ++i)
    {
        for (label j = 0; j <= m; ++j)
        {
            const label p = i*(m + 1) + j;
            points[p] = point(i, j, 0);
            if (i < n && j < m)
            {
                faces.append(face({p, p + m + 1, p + m + 2}));
                faces.append(face({p, p + m + 2, p + 1}));
            }
        }
    }
    const label across = points.size();
    points.append(pointField({{-1, 3.5, -1}, {n + 1, 3.5, -1}, {0, 3.5, 9e4}}));
    const auto plane = labelledTriangles(faces, points, identity(faces.size()));
    const auto needle = labelledTriangles
    (
        faceList(1, face({across, across + 1, across + 2})),
        points,
        labelList(1, faces.size())
    );
    auto all = plane;
    all.push_back(needle[0]);

    DynamicList<labelPair> among, between;
    addIntersections(all, {}, among);
    addIntersections(plane, needle, between);

    EXPECT_EQ(among.size(), 2*n);
    EXPECT_EQ(between, among);
    for (const labelPair& pair : among)
    {
        EXPECT_EQ((pair.first()/2) % m, 3);
        EXPECT_EQ(pair.second(), faces.size());
    }
}


// ************************************************************************* //
