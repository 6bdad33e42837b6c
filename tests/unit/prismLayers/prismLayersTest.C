/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "testLayers.H"
#include "testSurfaces.H"
#include "prismLayers.H"
#include "thrownMessage.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static const scalarList heights({0, 0.01, 0.03, 0.07});


//- One column on each point
static prismLayers plainLayers()
{
    return testSurfaces::straightLayers(testSurfaces::cube(2), heights);
}


//- Two columns on the edges of a cube, three on its corners
static prismLayers dividedLayers()
{
    return testSurfaces::frontLayers
    (
        testSurfaces::frontOf(testSurfaces::quadCube(2), 45.1), heights
    );
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(prismLayers, numbersOfPlainLayers)
{
    const prismLayers layers(plainLayers());

    EXPECT_EQ(layers.nColumns(), 26);
    EXPECT_EQ(layers.nWallPoints(), 26);
    EXPECT_EQ(layers.nWallFaces(), 48);
}


TEST(prismLayers, numbersWithFurtherColumns)
{
    const prismLayers layers(dividedLayers());

    EXPECT_EQ(layers.nWallPoints(), 26);
    EXPECT_EQ(layers.nColumns(), 26 + 12 + 2*8);
    EXPECT_EQ(layers.nWallFaces(), 24);
    EXPECT_EQ(layers.faces.size(), 24 + 24 + 8);
}


TEST(prismLayers, rootsOfTheFirstColumnsAreThemselves)
{
    const prismLayers layers(dividedLayers());

    for (label c = 0; c < layers.nWallPoints(); ++c)
    {
        EXPECT_EQ(layers.root(c), c);
    }
}


TEST(prismLayers, rootsOfFurtherColumnsAreOnTheirPoints)
{
    const prismLayers layers(dividedLayers());

    for (label c = layers.nWallPoints(); c < layers.nColumns(); ++c)
    {
        EXPECT_LT(layers.root(c), layers.nWallPoints());
        EXPECT_EQ(layers(layers.root(c), 0), layers(c, 0));
    }
}


TEST(prismLayers, labelsOfPlainLayersAreTheirIndices)
{
    const prismLayers layers(plainLayers());

    for (label c = 0; c < layers.nColumns(); ++c)
    {
        for (label i = 0; i <= layers.nLayers; ++i)
        {
            EXPECT_EQ(layers.pointLabel(c, i), layers.index(c, i));
        }
    }
    EXPECT_EQ(layers.meshPoints(), layers.points);
}


TEST(prismLayers, labelsAreOneToOneAboveTheWall)
{
    const prismLayers layers(dividedLayers());
    labelList counts(layers.meshPoints().size(), 0);

    for (label c = 0; c < layers.nColumns(); ++c)
    {
        for (label i = c < layers.nWallPoints() ? 0 : 1; i < 4; ++i)
        {
            ++counts[layers.pointLabel(c, i)];
        }
    }

    EXPECT_EQ(counts, labelList(counts.size(), 1));
}


TEST(prismLayers, columnsOnOnePointShareItsLabel)
{
    const prismLayers layers(dividedLayers());

    for (label c = 0; c < layers.nColumns(); ++c)
    {
        EXPECT_EQ
        (
            layers.pointLabel(c, 0), layers.pointLabel(layers.root(c), 0)
        );
    }
}


TEST(prismLayers, meshHasNoPointTwice)
{
    const prismLayers layers(dividedLayers());

    EXPECT_EQ
    (
        layers.meshPoints().size(),
        layers.points.size() - layers.extraColumnPoints.size()
    );
}


TEST(prismLayers, meshPointsAreThoseOfTheColumns)
{
    const prismLayers layers(dividedLayers());
    const pointField points(layers.meshPoints());

    for (label c = 0; c < layers.nColumns(); ++c)
    {
        for (label i = 0; i <= layers.nLayers; ++i)
        {
            EXPECT_EQ(points[layers.pointLabel(c, i)], layers(c, i));
        }
    }
}


TEST(requireCountable, cornersOfAllFacesAreCounted)
{
    EXPECT_NO_THROW(requireCountable(3, 1));

    // Of 32 bits: 11 000 000 triangles with 22 layers are too many
    const auto require = [](const label nLayers)
    {
        requireCountable(16500000, nLayers);
    };
    if (sizeof(label) == 4)
    {
        EXPECT_NO_THROW(require(21));
        expectWords
        (
            thrownMessage<Foam::error>([&]() { require(22); }),
            {"22 layers", "2211000000", "32 bits", "WM_LABEL_SIZE=64"}
        );
    }
    else
    {
        EXPECT_NO_THROW(require(22));
    }
}


// ************************************************************************* //
