/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/


#include "prismQuality.H"
#include "testLayers.H"
#include "testSurfaces.H"
#include "Random.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- A layer whose outer surface is given, far above its wall. The points are
//  moved so that their coordinates round.
static prismLayers outerLayer(const pointField& points, const faceList& faces)
{
    const vector x(normalised(vector(1, 0.3, -0.7)));
    const vector y(normalised(x ^ vector(0.2, 1, 0.9)));
    const vector z(x ^ y);

    prismLayers layers;
    layers.nLayers = 1;
    layers.faces = faces;
    layers.patchIDs = labelList(faces.size(), Zero);
    layers.patchNames = wordList(1, word("wall"));

    for (const point& p : points)
    {
        const point q(p.x()*x + p.y()*y + p.z()*z);
        layers.points.append(q - 100*z);
        layers.points.append(q);
    }

    return layers;
}


static label nIntersections(const pointField& points, const faceList& faces)
{
    return findIntersections(outerLayer(points, faces)).size();
}


//- Two cubes of size 1 with faces in z = 1 and z = 1 + gap, layers of a height
static prismLayers twoCubes(const scalar gap, const scalar height)
{
    const wallSurface cube(testSurfaces::cube(3));

    return testSurfaces::straightLayers
    (
        testSurfaces::merge
        (
            cube,
            testSurfaces::translated(cube, vector(0.125, 0.0625, 1 + gap))
        ),
        scalarList({0, 0.5*height, height})
    );
}


//- Those of which an outer face is a candidate
static List<labelPair> pairsWith
(
    const List<labelPair>& pairs,
    const boolList& candidates
)
{
    DynamicList<labelPair> found;

    for (const labelPair& pair : pairs)
    {
        bool any = false;
        for (const label f : pair)
        {
            const label outer = f - candidates.size();
            any = any || (outer >= 0 && candidates[outer]);
        }

        if (any)
        {
            found.append(pair);
        }
    }

    return List<labelPair>(std::move(found));
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(findIntersections, noneOnEmbeddedShapes)
{
    const scalarList heights({0, 0.01, 0.03});

    for
    (
        const wallSurface& wall :
        {
            testSurfaces::cube(5),
            testSurfaces::quadCube(5),
            testSurfaces::sphere(6),
            testSurfaces::torus(24, 12, 1, 0.3),
            testSurfaces::lBlock(3)
        }
    )
    {
        EXPECT_TRUE
        (
            findIntersections
            (
                testSurfaces::straightLayers(wall, heights)
            ).empty()
        );
    }
}


TEST(findIntersections, outerSurfacesThatCross)
{
    const prismLayers layers(twoCubes(0.25, 0.15));
    const List<labelPair> pairs(findIntersections(layers));
    const label nFaces = layers.faces.size();

    ASSERT_FALSE(pairs.empty());

    for (const labelPair& pair : pairs)
    {
        // Of different cubes, both on the outer surface
        EXPECT_GE(pair.first(), nFaces);
        EXPECT_LT(pair.first(), nFaces + nFaces/2);
        EXPECT_GE(pair.second(), nFaces + nFaces/2);
    }
}


TEST(findIntersections, outerSurfaceThroughTheOppositeWall)
{
    const prismLayers layers(twoCubes(0.25, 0.3));
    const List<labelPair> pairs(findIntersections(layers));

    label nWithWall = 0;
    for (const labelPair& pair : pairs)
    {
        nWithWall += pair.first() < layers.faces.size();
    }

    EXPECT_GT(nWithWall, 0);
}


TEST(findIntersections, surfacesThatTouch)
{
    EXPECT_TRUE(findIntersections(twoCubes(0.25, 0.124)).empty());
    EXPECT_FALSE(findIntersections(twoCubes(0.25, 0.125)).empty());
}


TEST(findIntersections, eachPairOnceInOrder)
{
    const List<labelPair> pairs(findIntersections(twoCubes(0.25, 0.15)));

    for (label i = 1; i < pairs.size(); ++i)
    {
        EXPECT_LT(pairs[i - 1], pairs[i]);
    }
}


TEST(findIntersections, wallAndOuterSurfaceThatCoincide)
{
    const prismLayers layers
    (
        testSurfaces::straightLayers
        (
            testSurfaces::cube(1),
            scalarList({0, 0})
        )
    );

    const List<labelPair> pairs(findIntersections(layers));

    for (label facei = 0; facei < layers.faces.size(); ++facei)
    {
        EXPECT_TRUE(pairs.found(labelPair(facei, 12 + facei)));
    }
}


TEST(findIntersections, trianglesWithACommonEdge)
{
    const faceList faces({face({0, 1, 2}), face({1, 0, 3})});
    pointField points
    ({
        point(0, 0, 0), point(1, 0, 0), point(0.5, 1, 0), point(0.5, -1, 0)
    });

    EXPECT_EQ(nIntersections(points, faces), 0) << "in one plane";

    points[3] = point(0.5, 1, 1e-9);
    EXPECT_EQ(nIntersections(points, faces), 0) << "nearly folded";
}


TEST(findIntersections, foldedTriangles)
{
    // Not moved, because rounding would unfold them
    prismLayers layers
    (
        outerLayer(pointField(4), {face({0, 1, 2}), face({1, 0, 3})})
    );

    const pointField outer
    ({
        point(0, 0, 0), point(1, 0, 0), point(0.5, 1, 0), point(0.3, 2, 0)
    });

    forAll(outer, c)
    {
        layers.points[layers.pointLabel(c, 0)] = outer[c] - vector(0, 0, 9);
        layers.points[layers.pointLabel(c, 1)] = outer[c];
    }

    const List<labelPair> pairs(findIntersections(layers));

    ASSERT_EQ(pairs.size(), 1);
    EXPECT_EQ(pairs[0], labelPair(2, 3));
}


TEST(findIntersections, trianglesWithACommonPoint)
{
    const faceList faces({face({0, 1, 2}), face({0, 3, 4})});
    pointField points
    ({
        point(0, 0, 0), point(1, 0, 0), point(0, 1, 0),
        point(-1, 0, 0), point(0, -1, 0)
    });

    EXPECT_EQ(nIntersections(points, faces), 0) << "in one plane";

    points[3] = point(0.5, 0.5, 1);
    points[4] = point(0.5, 0.5, 0.1);
    EXPECT_EQ(nIntersections(points, faces), 0) << "above";

    points[4] = point(0.4, 0.4, -1);
    EXPECT_EQ(nIntersections(points, faces), 1) << "through its inside";

    points[3] = point(-0.5, 0.5, 1);
    points[4] = point(-0.5, 0.5, -1);
    EXPECT_EQ(nIntersections(points, faces), 0) << "through its plane, beside";
}


TEST(findIntersections, trianglesWithoutACommonPoint)
{
    const faceList faces({face({0, 1, 2}), face({3, 4, 5})});
    pointField points
    ({
        point(0, 0, 0), point(1, 0, 0), point(0, 1, 0),
        point(0.2, 0.2, 1), point(0.3, 0.2, 1), point(0.2, 0.3, -1)
    });

    EXPECT_EQ(nIntersections(points, faces), 1);

    points[5].z() = 1e-9;
    EXPECT_EQ(nIntersections(points, faces), 0);
}


TEST(findIntersections, foldedPolygons)
{
    // Seen from above the second half of the square covers the first
    const faceList faces({face({0, 1, 2, 3})});
    prismLayers layers(outerLayer(pointField(4), faces));

    const pointField outer
    ({
        point(0, 0, 0), point(1, 0, 0), point(1, 1, 0), point(0.9, 0.3, 0)
    });

    forAll(outer, c)
    {
        layers.points[layers.pointLabel(c, 0)] = outer[c] - vector(0, 0, 9);
        layers.points[layers.pointLabel(c, 1)] = outer[c];
    }

    const List<labelPair> pairs(findIntersections(layers));

    ASSERT_EQ(pairs.size(), 1);
    EXPECT_EQ(pairs[0], labelPair(1, 1));
}


TEST(findIntersections, degenerateOuterFaces)
{
    const pointField points(3, point(1, 2, 3));

    const List<labelPair> pairs
    (
        findIntersections(outerLayer(points, {face({0, 1, 2})}))
    );

    ASSERT_EQ(pairs.size(), 1);
    EXPECT_EQ(pairs[0], labelPair(1, 1));
}


TEST(findIntersections, candidatesAreAmongThePairs)
{
    const prismLayers crossing(twoCubes(0.25, 0.15));
    const prismLayers reaching(twoCubes(0.25, 0.4));
    Random random(29);

    for (const prismLayers& layers : {crossing, reaching})
    {
        for (const scalar share : {0.0, 0.1, 0.5, 0.9, 1.0})
        {
            boolList candidates(layers.faces.size());
            for (bool& candidate : candidates)
            {
                candidate = random.sample01<scalar>() < share;
            }

            EXPECT_EQ
            (
                findIntersections(layers, findIndices(candidates, true)),
                pairsWith(findIntersections(layers), candidates)
            );
        }
    }
}


TEST(findIntersections, oneCandidateHasItsPairs)
{
    const prismLayers layers(twoCubes(0.25, 0.15));
    const List<labelPair> all(findIntersections(layers));
    label n = 0;

    forAll(layers.faces, facei)
    {
        boolList candidates(layers.faces.size(), false);
        candidates[facei] = true;
        const List<labelPair> pairs
        (
            findIntersections(layers, labelList(1, facei))
        );
        n += pairs.size();

        EXPECT_EQ(pairs, pairsWith(all, candidates));
    }

    // Of each pair of outer faces both are candidates once
    EXPECT_EQ(n, 2*all.size());
}


// ************************************************************************* //
