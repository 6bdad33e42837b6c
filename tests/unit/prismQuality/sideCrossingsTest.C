/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sideCrossings.H"
#include "layerOverlaps.H"
#include "openSurfaces.H"
#include "prismQuality.H"
#include "testLayers.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Two straight layers of 0.02 and more on a wall that ends on side patches
static prismLayers endedLayers
(
    const wallSurface& wall,
    const scalar thickness = 0.05
)
{
    prismLayers layers(straightLayers(wall, {0, 0.02, thickness}));
    layers.border = wall.border;

    return layers;
}


static labelList crossings(const prismLayers& layers)
{
    return findSideCrossings(layers, identity(layers.faces.size()));
}


//- The front faces with a column
static labelList facesOf(const prismLayers& layers, const label c)
{
    DynamicList<label> faces;
    forAll(layers.faces, facei)
    {
        if (layers.faces[facei].found(c))
        {
            faces.append(facei);
        }
    }

    return labelList(std::move(faces));
}


//- The column at a place of the wall
static label columnAt(const prismLayers& layers, const point& x)
{
    for (label c = 0; c < layers.nColumns(); ++c)
    {
        if (mag(layers(c, 0) - x) < 1e-12)
        {
            return c;
        }
    }

    return -1;
}


//- The duct with layers, and a cube of six faces in it near to the inlet, on
//  which the layers are up to 0.05 thick
static prismLayers ductWithCube(const scalar distance)
{
    const wallSurface walls(endedOn(duct(4), wordList({"inlet", "outlet"})));
    wallSurface both
    (
        merge(walls, translated(quadCube(1, 0.3), vector(distance, 0.35, 0.35)))
    );
    both.border = walls.border;

    return endedLayers(both);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(sideCrossings, columnsInThePlaneDoNotCrossIt)
{
    for (const wallSurface& wall :
        {
            endedOn(halfCube(4), halfPlanes()),
            endedOn(quarterCube(4), quarterPlanes()),
            endedOn(duct(4), wordList({"inlet", "outlet"}))
        })
    {
        EXPECT_TRUE(crossings(endedLayers(wall)).empty());
    }
}


TEST(sideCrossings, columnsBesideAFoldOfAnInletAreBeyondOneOfItsPlanes)
{
    // The inlet is a ridge in the fluid: each half is beyond the other's plane
    wallSurface surface(duct(4));
    for (point& x : surface.points)
    {
        x.x() += (1 - x.x())*(0.2 - 0.4*mag(x.y() - 0.5));
    }
    const wallSurface walls(endedOn(surface, wordList({"inlet", "outlet"})));
    ASSERT_EQ(walls.border.sides.size(), 3);
    const prismLayers layers(endedLayers(walls));

    EXPECT_EQ(crossings(layers), labelList());
}


TEST(sideCrossings, layersInOrBeyondAPlaneCrossIt)
{
    for (const scalar z : {0.0, -0.01})
    {
        prismLayers layers
        (
            endedLayers(endedOn(halfCube(4), halfPlanes()))
        );
        const label c = columnAt(layers, point(0.5, 0, 0.25));
        ASSERT_GE(c, 0);
        layers.points[layers.index(c, 2)].z() = z;

        EXPECT_EQ(facesOf(layers, c).size(), 4);
        EXPECT_EQ(crossings(layers), facesOf(layers, c));
        EXPECT_FALSE(certify(layers).valid());
    }
}


TEST(sideCrossings, layersBeyondAnInletBesideItCrossIt)
{
    prismLayers layers
    (
        endedLayers(endedOn(duct(4), wordList({"inlet", "outlet"})))
    );
    const label c = columnAt(layers, point(0.25, 0.5, 0));
    ASSERT_GE(c, 0);
    layers.points[layers.index(c, 2)].x() = -0.01;

    // Of its four faces two touch the inlet
    DynamicList<label> expected;
    for (const label facei : facesOf(layers, c))
    {
        if (layers.faces[facei].centre(layers.points).x() > -1)
        {
            for (const label k : layers.faces[facei])
            {
                if (layers(k, 0).x() == 0)
                {
                    expected.append(facei);
                    break;
                }
            }
        }
    }
    EXPECT_EQ(expected.size(), 2);

    const labelList found(crossings(layers));
    for (const label facei : expected)
    {
        EXPECT_TRUE(found.found(facei));
    }
}


TEST(sideCrossings, layersThroughAnInletCrossIt)
{
    // The outer cube goes from 0.03 beyond the inlet to this side of it: four
    // of its faces cross the inlet
    const prismLayers layers(ductWithCube(0.02));
    const labelList found(crossings(layers));

    EXPECT_EQ(found.size(), 4);
    for (const label facei : found)
    {
        EXPECT_GE(facei, 64);
        EXPECT_EQ
        (
            mag(layers.faces[facei].areaNormal(layers.outerPoints()).x())
          < 1e-12,
            true
        );
    }
    const labelList all(identity(layers.faces.size()));
    EXPECT_EQ
    (
        findOverlaps
        (
            layers, all, findBodies(layers), stackBoxes(layers),
            scalarField(layers.nColumns(), 1)
        ).size(),
        4
    );
}


TEST(sideCrossings, layersInFrontOfAnInletDoNotCrossIt)
{
    EXPECT_TRUE(crossings(ductWithCube(0.06)).empty());
}


TEST(sideCrossings, bodiesBesideAnInletAreNotLookedAt)
{
    // Through the plane of the inlet, but not through the inlet
    prismLayers layers(ductWithCube(0.02));
    for (label c = 0; c < layers.nColumns(); ++c)
    {
        const bool isCube = mag(layers(c, 0).y() - 0.5) < 0.2
          && mag(layers(c, 0).z() - 0.5) < 0.2
          && layers(c, 0).x() > 0.01 && layers(c, 0).x() < 0.4;
        for (label i = 0; i <= 2 && isCube; ++i)
        {
            layers.points[layers.index(c, i)].y() += 3;
        }
    }

    EXPECT_TRUE(crossings(layers).empty());
}


TEST(sideCrossings, onlyFacesOfTheListAreLookedFor)
{
    prismLayers layers(endedLayers(endedOn(halfCube(4), halfPlanes())));
    const label c = columnAt(layers, point(0.5, 0, 0.25));
    layers.points[layers.index(c, 2)].z() = -0.01;
    const labelList faces(facesOf(layers, c));

    EXPECT_EQ
    (
        findSideCrossings(layers, labelList({faces[1]})),
        labelList({faces[1]})
    );
    EXPECT_TRUE(findSideCrossings(layers, labelList()).empty());
}


// ************************************************************************* //
