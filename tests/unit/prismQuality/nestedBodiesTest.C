/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerOverlaps.H"
#include "prismQuality.H"
#include "testLayers.H"
#include "testStages.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A cube of size 1 and a small one with its lowest corner in x
static wallSurface cubes(const point& x)
{
    wallSurface wall(testSurfaces::cube(1));
    const wallSurface other(testSurfaces::cube(1));
    const label n = wall.points.size();

    for (const point& p : other.points)
    {
        wall.points.append(x + 0.02*p);
    }
    for (const face& f : other.faces)
    {
        face moved(f);
        for (label& p : moved)
        {
            p += n;
        }
        wall.faces.append(moved);
    }
    wall.patchIDs = labelList(wall.faces.size(), Zero);

    return wall;
}


//- Three layers, 0.5 thick on the large cube and 0.005 on the small one
static prismLayers layersOn(const wallSurface& wall)
{
    prismLayers layers
    (
        testSurfaces::straightLayers(wall, scalarList({0, 0.1, 0.2, 0.5}))
    );

    for (label c = wall.points.size()/2; c < wall.points.size(); ++c)
    {
        for (label i = 1; i <= 3; ++i)
        {
            point& x = layers.points[layers.index(c, i)];
            x = layers(c, 0) + 0.01*(x - layers(c, 0));
        }
    }

    return layers;
}


static List<labelPair> nested(const prismLayers& layers)
{
    return findNestedBodies
    (
        layers, identity(layers.faces.size()), findBodies(layers)
    );
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(findNestedBodies, findsThoseInLayers)
{
    for (const scalar z : {1.05, 1.15, 1.3, 1.45})
    {
        const prismLayers layers(layersOn(cubes(point(0.6, 0.3, z))));
        const List<labelPair> pairs(nested(layers));

        ASSERT_FALSE(pairs.empty());
        EXPECT_FALSE(certify(layers).valid());

        for (const labelPair& pair : pairs)
        {
            const label facei = pair.second() - layers.faces.size();

            EXPECT_GE(pair.first(), 12);
            EXPECT_LT(facei, 12);
            for (const label c : layers.faces[facei])
            {
                EXPECT_EQ(layers(c, 0).z(), 1);
            }
        }
    }
}


TEST(findNestedBodies, looksAtStacksOfTheListOnly)
{
    const prismLayers layers(layersOn(cubes(point(0.6, 0.3, 1.15))));
    const layerBodies bodies(findBodies(layers));
    const label stack = nested(layers)[0].second() - layers.faces.size();
    const labelList others
    (
        subsetList
        (
            identity(layers.faces.size()),
            [&](const label facei) { return facei != stack; }
        )
    );

    EXPECT_EQ(bodies.firstFaces, labelList({0, 12}));
    EXPECT_EQ
    (
        findNestedBodies(layers, labelList(1, stack), bodies),
        List<labelPair>(1, labelPair(12, stack + layers.faces.size()))
    );
    EXPECT_LT
    (
        findNestedBodies(layers, others, bodies).size(), nested(layers).size()
    );
}


TEST(findNestedBodies, leavesThoseOutside)
{
    for (const scalar z : {1.51, 3.0, -0.6})
    {
        const prismLayers layers(layersOn(cubes(point(0.6, 0.3, z))));

        EXPECT_TRUE(nested(layers).empty());
        EXPECT_TRUE(certify(layers).valid());
    }
}


TEST(findNestedBodies, columnsRetreatFromThem)
{
    // No point of the large cube is near to the small one
    const wallSurface wall(cubes(point(0.6, 0.3, 1.1)));
    const prismLayers layers
    (
        testSurfaces::layeredMesh(wall, 3, 0.5).made.layers
    );

    EXPECT_TRUE(certify(layers).valid());
    EXPECT_TRUE(nested(layers).empty());
}


// ************************************************************************* //
