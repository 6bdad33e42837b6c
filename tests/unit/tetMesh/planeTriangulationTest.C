/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planeTriangulation.H"
#include "testSurfaces.H"
#include "thrownMessage.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A rotated frame: points and normal of a region given in x and y
class rotatedRegion
{
    vector e1_;
    vector e2_;

public:

    pointField points;
    planeRegion region;

    //- In the plane with a normal
    explicit rotatedRegion(const vector& normal)
    {
        region.normal = normalised(normal);
        e1_ = normalised
        (
            mag(region.normal.x()) < 0.9
          ? region.normal ^ vector(1, 0, 0) : region.normal ^ vector(0, 1, 0)
        );
        e2_ = region.normal ^ e1_;
    }

    label add(const scalar x, const scalar y)
    {
        points.append(x*e1_ + y*e2_ + 0.3*region.normal);

        return points.size() - 1;
    }

    //- A loop of edges round the square [low, high]^2
    void addSquare(const scalar low, const scalar high, const bool isHole)
    {
        labelList p
        ({
            add(low, low), add(high, low), add(high, high), add(low, high)
        });
        if (isHole)
        {
            Swap(p[1], p[3]);
        }
        forAll(p, i)
        {
            region.boundary.append(edge(p[i], p[p.fcIndex(i)]));
        }
    }

    faceList triangles() const { return triangulatePlane(points, region); }

    //- Sum of the areas along the normal, each being positive
    scalar area(const faceList& triangles) const
    {
        scalar sum = 0;
        for (const face& t : triangles)
        {
            const scalar a = t.areaNormal(points) & region.normal;
            EXPECT_GT(a, 0);
            sum += a;
        }

        return sum;
    }

    std::string error() const
    {
        return thrownMessage<Foam::error>([&]() { triangles(); });
    }
};


//- Along and against the axes, and between them
static List<vector> normals()
{
    return List<vector>
    ({
        {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1},
        {1, 2, -3}, {-0.5, 0.4, 0.45}
    });
}


static bool hasEdge(const faceList& triangles, const edge& e)
{
    return std::any_of
    (
        triangles.begin(), triangles.end(),
        [&](const face& t) { return t.edgeDirection(e) != 0; }
    );
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(planeTriangulation, squareWithAHole)
{
    for (const vector& normal : normals())
    {
        rotatedRegion r(normal);
        r.addSquare(0, 1, false);
        r.addSquare(0.25, 0.75, true);
        const faceList triangles(r.triangles());

        // V + 2 - 2 Euler characteristic, which is 0
        EXPECT_EQ(triangles.size(), 8);
        EXPECT_NEAR(r.area(triangles), 0.75, 1e-14);

        // Its boundary is as given
        const edgeList open(outline(triangles));
        EXPECT_EQ(open.size(), 8);
        for (const edge& e : open)
        {
            const label i = r.region.boundary.find(e);
            ASSERT_GE(i, 0);
            EXPECT_EQ(r.region.boundary[i].start(), e.start());
        }
    }
}


TEST(planeTriangulation, islandInAHoleIsFilled)
{
    rotatedRegion r(vector(1, 2, -3));
    r.addSquare(0, 1, false);
    r.addSquare(0.25, 0.75, true);
    r.addSquare(0.4, 0.6, false);

    EXPECT_NEAR(r.area(r.triangles()), 0.75 + 0.04, 1e-14);
}


TEST(planeTriangulation, hasTheEdgesAndPointsThatAreAsked)
{
    rotatedRegion r(vector(0, 0, 1));
    r.addSquare(0, 1, false);
    const label inside = r.add(0.3, 0.6);
    const label outside = r.add(3, 3);
    const edge diagonal(r.add(0.1, 0.1), r.add(0.9, 0.8));
    r.region.points.append(inside);
    r.region.points.append(outside);
    r.region.edges.append(diagonal);
    const faceList triangles(r.triangles());

    // 4 points on the boundary, 3 inside
    EXPECT_EQ(triangles.size(), 4 - 2 + 2*3);
    EXPECT_NEAR(r.area(triangles), 1, 1e-15);
    EXPECT_TRUE(hasEdge(triangles, diagonal));
    for (const face& t : triangles)
    {
        EXPECT_FALSE(t.found(outside));
    }
}


TEST(planeTriangulation, fencesEndWhatABoundaryLeavesOpen)
{
    // Left and right of a line across a fenced square
    for (const bool left : {true, false})
    {
        rotatedRegion r(vector(0, 0, -1));
        const labelList p
        ({
            r.add(0, 0), r.add(0.3, 0), r.add(1, 0),
            r.add(1, 1), r.add(0.3, 1), r.add(0, 1)
        });
        forAll(p, i)
        {
            r.region.limits.append(edge(p[i], p[p.fcIndex(i)]));
        }
        r.region.boundary.append
        (
            left ? edge(p[1], p[4]) : edge(p[4], p[1])
        );

        EXPECT_NEAR(r.area(r.triangles()), left ? 0.3 : 0.7, 1e-15);
    }
}


TEST(planeTriangulation, crossingEdgesAreAnError)
{
    rotatedRegion r(vector(0, 0, 1));
    r.addSquare(0, 1, false);
    r.region.edges.append(edge(r.add(0.5, -1), r.add(0.5, 2)));

    expectWords(r.error(), {"The edge from (", "crosses another edge"});
}


TEST(planeTriangulation, openBoundaryIsAnError)
{
    rotatedRegion r(vector(0, 0, 1));
    r.addSquare(0, 1, false);
    r.region.boundary.setSize(3);
    r.points[0] = point(1e-3, 2e-3, 0.3);

    expectWords(r.error(), {"not closed near (0.001 0.002 0.3)"});
}


TEST(planeTriangulation, pointsOnAnEdgeDivideIt)
{
    // In the middle of a side, exactly
    rotatedRegion r(vector(0, 0, 1));
    r.addSquare(0, 1, false);
    const label middle = r.add(0.5, 0);
    r.region.points.append(middle);
    r.region.boundary[0] = edge(0, middle);
    r.region.boundary.append(edge(middle, 1));

    EXPECT_EQ(r.triangles().size(), 3);
    EXPECT_NEAR(r.area(r.triangles()), 1, 1e-15);
}


TEST(planeTriangulation, edgesAreDividedAtPointsInOrder)
{
    const pointField points
    ({
        point(-2, 0, 0), point(3, 0, 0), point(1, 1e-10, 0), point(0, 0, 0),
        point(0.5, 1e-3, 0), point(4, 0, 0)
    });
    const labelList at({0, 2, 3, 4, 5});
    const DynamicList<edge> edges(List<edge>({edge(0, 1), edge(1, 0)}));
    const DynamicList<edge> divided(dividedEdges(points, edges, at, 1e-9));
    const List<edge> expected
    ({
        edge(0, 3), edge(3, 2), edge(2, 1), edge(1, 2), edge(2, 3), edge(3, 0)
    });

    ASSERT_EQ(divided.size(), expected.size());
    forAll(expected, i)
    {
        EXPECT_EQ(divided[i].start(), expected[i].start());
        EXPECT_EQ(divided[i].end(), expected[i].end());
    }
}


// ************************************************************************* //
