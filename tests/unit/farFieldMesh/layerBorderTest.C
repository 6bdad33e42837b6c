/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sideRegions.H"
#include "openSurfaces.H"
#include "testLayers.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- One layer of 0.1
static prismLayers borderLayer(const wallSurface& wall)
{
    prismLayers layers(straightLayers(wall, {0, 0.1}));
    layers.border = wall.border;

    return layers;
}


//- On the quarter cube: corners are the columns on (0 0 0) and (1 0 0), whose
//  outer points are (-0.1 0 0) and (1.1 0 0)
static prismLayers quarter()
{
    return borderLayer(endedOn(quarterCube(4), quarterPlanes()));
}


static label topAt(const layerBorder& border, const point& x)
{
    forAll(border.outerPoints(), i)
    {
        if (mag(border.outerPoints()[i] - x) < 1e-12)
        {
            return i;
        }
    }

    return -1;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(layerBorder, outerEdgesRunRoundTheRemainder)
{
    const prismLayers layers(borderLayer(endedOn(halfCube(4), halfPlanes())));
    const layerBorder border(layers, 1e-9);
    EXPECT_EQ(border.columns().size(), 16);
    ASSERT_EQ(border.outerEdges().size(), 16);

    // Twice the area to the left of the edges, seen from the fluid: that of a
    // hole
    vector area(Zero);
    for (const edge& e : border.outerEdges())
    {
        area += border.outerPoints()[e.start()] ^ border.outerPoints()[e.end()];
    }
    EXPECT_LT(mag(area - vector(0, 0, -2*1.44)), 1e-14);

    forAll(border.columns(), i)
    {
        EXPECT_EQ(border.outerPoints()[i], layers(border.columns()[i], 1));
        EXPECT_TRUE(i == 0 || border.columns()[i - 1] < border.columns()[i]);
    }
}


TEST(layerBorder, coversEdgesOfTheWallInBothDirections)
{
    const prismLayers layers(quarter());
    const layerBorder border(layers, 1e-9);

    for (const edge& e : layers.border.edges)
    {
        labelPair ends;
        EXPECT_TRUE
        (
            border.covers(layers(e.start(), 0), layers(e.end(), 0), ends)
        );
        EXPECT_TRUE
        (
            border.covers(layers(e.end(), 0), layers(e.start(), 0), ends)
        );
    }
}


TEST(layerBorder, coversWhatIsBelowATop)
{
    const layerBorder border(quarter(), 1e-9);
    labelPair ends;

    EXPECT_TRUE
    (
        border.covers(point(1, 0, 0), point(1.07, 0, 0), ends)
    );
    EXPECT_TRUE
    (
        border.covers(point(1.05, 0, 0), point(1.02, 0, 0), ends)
    );
}


TEST(layerBorder, topsTakeThePlaceOfCoveredEnds)
{
    const layerBorder border(quarter(), 1e-9);
    const label high = topAt(border, point(1.1, 0, 0));
    const label low = topAt(border, point(-0.1, 0, 0));
    ASSERT_GE(high, 0);
    ASSERT_GE(low, 0);
    labelPair ends;

    EXPECT_FALSE(border.covers(point(1.05, 0, 0), point(2, 0, 0), ends));
    EXPECT_EQ(ends, labelPair(high, -1));
    EXPECT_FALSE(border.covers(point(2, 0, 0), point(1, 0, 0), ends));
    EXPECT_EQ(ends, labelPair(-1, high));
    EXPECT_FALSE(border.covers(point(-2, 0, 0), point(-0.05, 0, 0), ends));
    EXPECT_EQ(ends, labelPair(-1, low));

    // Beyond the top, and on another line
    EXPECT_FALSE(border.covers(point(1.2, 0, 0), point(2, 0, 0), ends));
    EXPECT_EQ(ends, labelPair(-1, -1));
    EXPECT_FALSE(border.covers(point(1.05, 0.2, 0), point(2, 0, 0), ends));
    EXPECT_EQ(ends, labelPair(-1, -1));
}


TEST(layerBorder, topsOnASideAreThoseOnTwo)
{
    const layerBorder border(quarter(), 1e-9);
    const label high = topAt(border, point(1.1, 0, 0));
    const label low = topAt(border, point(-0.1, 0, 0));

    for (const label side : {0, 1})
    {
        const labelList outerPoints(border.outerPointsOn(side));
        EXPECT_EQ(outerPoints.size(), 2);
        EXPECT_TRUE(outerPoints.found(low));
        EXPECT_TRUE(outerPoints.found(high));
    }
    EXPECT_TRUE(border.outerPointsOn(2).empty());
}


// ************************************************************************* //
