/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerSpacing.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Three layers on two points, of given heights
static layerSpacing givenSpacing()
{
    layerSpacing spacing;
    spacing.nLayers = 3;
    spacing.given = scalarField(scalarList({0.1, 0.5, 1, 0.2, 0.3, 2}));
    spacing.firstThickness = scalarField(scalarList({0.1, 0.2}));
    spacing.thickness = scalarField(scalarList({1, 2}));
    spacing.ratio = scalarField(2, 1.5);
    spacing.layersAsked = labelList(2, 3);

    return spacing;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(layerSpacing, givenHeightsAreTheRequest)
{
    const layerSpacing spacing(givenSpacing());

    EXPECT_EQ(requestedHeights(spacing), spacing.given);
    EXPECT_EQ
    (
        requestedHeights(spacing.at(labelList({1, 0, 1}))),
        scalarField(scalarList({0.2, 0.3, 2, 0.1, 0.5, 1, 0.2, 0.3, 2}))
    );
}


TEST(layerSpacing, givenHeightsShrinkToTheRoomInProportion)
{
    const layerSpacing spacing(givenSpacing());
    scalarField column(4);

    spacing.setHeights(0, 0.5, column);
    EXPECT_EQ(column, scalarField(scalarList({0, 0.05, 0.25, 0.5})));

    spacing.setHeights(0, 5, column);
    EXPECT_EQ(column, scalarField(scalarList({0, 0.1, 0.5, 1})));
}


TEST(layerSpacing, givenHeightsAreGradedLayerByLayer)
{
    wallAddressing addressing;
    addressing.pointPoints = labelListList({labelList({1}), labelList({0})});
    addressing.edges = edgeList(1, edge(0, 1));

    EXPECT_EQ
    (
        gradedSpacing(givenSpacing(), addressing, 1.5).given,
        scalarField(scalarList({0.1, 1.5*0.3, 1, 1.5*0.1, 0.3, 1.5}))
    );
}


// ************************************************************************* //
