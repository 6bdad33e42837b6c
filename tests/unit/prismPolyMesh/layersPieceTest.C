/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layersDivider.H"
#include "memoryMesh.H"
#include "openSurfaces.H"
#include "pieceInLists.H"
#include "sharedPiece.H"
#include "testLayers.H"
#include "testStages.H"
#include "testSurfaces.H"
#include "boundBox.H"
#include "Random.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::testSurfaces;

static const label nPieces = 4;

//- Processes of stacks: parts along x, and some stacks anywhere
static labelList processorsOf(const prismLayers& layers)
{
    const boundBox box(layers.points, false);
    Random random(3);
    labelList processors(layers.faces.size());

    forAll(processors, facei)
    {
        const point& x = layers(layers.faces[facei][0], 0);
        const scalar share = (x - box.min()).x()/box.span().x();
        processors[facei] =
            random.sample01<scalar>() < 0.1 ? nPieces - 1
          : share < 0.3 ? 0 : share < 0.7 ? 1 : 2;
    }

    return processors;
}


//- The piece of a process, with the points of the layers
static layersPiece pieceOf
(
    const prismLayers& layers,
    const labelList& processors,
    const label processor
)
{
    const layersDivider divider(layers, columnTeam::alone());
    const List<message> messages
    (
        divider.stacksByProcess(processors, nPieces)
    );
    layersPiece piece
    (
        divider.assemble(List<message>(1, messages[processor]), processors)
    );
    forAll(piece.columns, c)
    {
        for (label i = 0; i <= layers.nLayers; ++i)
        {
            piece.layers.points[piece.layers.index(c, i)] =
                layers(piece.columns[c], i);
        }
    }

    return piece;
}


//- Pieces made of stacks are those of the whole mesh, list by list
static void expectPiecesOfTheMesh(const prismLayers& layers)
{
    const memoryMesh memory(layers);
    const labelList processorOfStack(processorsOf(layers));
    labelList processorOfCell(memory().nCells());
    forAll(processorOfCell, celli)
    {
        processorOfCell[celli] = processorOfStack[celli/layers.nLayers];
    }

    for (label processor = 0; processor < nPieces; ++processor)
    {
        const meshPiece whole
        (
            makeMeshPiece(memory(), processorOfCell, processor)
        );
        const meshPiece own
        (
            pieceInLists
            (
                pieceOf(layers, processorOfStack, processor), processor
            )
        );

        ASSERT_GT(whole.cellAddressing.size(), 0);
        EXPECT_EQ(own.points, whole.points);
        EXPECT_EQ(own.faces, whole.faces);
        EXPECT_EQ(own.owner, whole.owner);
        EXPECT_EQ(own.neighbour, whole.neighbour);
        EXPECT_EQ(own.patchNames, whole.patchNames);
        EXPECT_EQ(own.patchTypes, whole.patchTypes);
        EXPECT_EQ(own.patchSizes, whole.patchSizes);
        EXPECT_EQ(own.processors, whole.processors);
        EXPECT_EQ(own.processorSizes, whole.processorSizes);
        EXPECT_EQ(own.cellAddressing, whole.cellAddressing);
        EXPECT_EQ(own.pointAddressing, whole.pointAddressing);
        EXPECT_EQ(own.faceAddressing, whole.faceAddressing);
        EXPECT_EQ(own.zoneNames, whole.zoneNames);
    }
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(layersDivider, stacksAreBesideEachOther)
{
    const prismLayers layers(straightLayers(cube(3), {0, 0.1}));
    const labelListList beside
    (
        layersDivider(layers, columnTeam::alone()).neighbours()
    );

    ASSERT_EQ(beside.size(), layers.faces.size());
    forAll(beside, stacki)
    {
        EXPECT_EQ(beside[stacki].size(), 3);
        for (const label other : beside[stacki])
        {
            EXPECT_TRUE(beside[other].found(stacki));
        }
    }
}


TEST(layersDivider, aStackAtTheBorderHasFewerBesideIt)
{
    const prismLayers layers(onePolygon(4, {0, 0.1}));

    EXPECT_EQ
    (
        layersDivider(layers, columnTeam::alone()).neighbours(),
        labelListList(1)
    );
}


TEST(centresOfStacks, areInTheMiddle)
{
    const prismLayers layers(onePolygon(5, {0, 0.1, 0.4}));
    const pointField centres(centresOfStacks(layers));

    ASSERT_EQ(centres.size(), 1);
    EXPECT_NEAR(mag(centres[0] - point(0, 0, 0.5/3)), 0, 1e-15);
}


TEST(layersPiece, equalsTheWholeMeshOnTriangles)
{
    expectPiecesOfTheMesh(shakenLayers(sphere(5)));
}


TEST(layersPiece, ofAProcessWithoutStacksIsEmpty)
{
    const prismLayers layers(shakenLayers(sphere(3)));
    const labelList processors(layers.faces.size(), Zero);
    const meshPiece piece
    (
        pieceInLists(pieceOf(layers, processors, 1), 1)
    );

    EXPECT_TRUE(piece.points.empty());
    EXPECT_TRUE(piece.faces.empty());
    EXPECT_TRUE(piece.cellAddressing.empty());
    EXPECT_TRUE(piece.processors.empty());
    EXPECT_EQ(piece.patchSizes, labelList(piece.patchNames.size(), Zero));
}


TEST(layersPiece, equalsTheWholeMeshOnQuadrilateralsInOneLayer)
{
    expectPiecesOfTheMesh(straightLayers(quadSphere(4), {0, 0.1}));
}


TEST(layersPiece, equalsTheWholeMeshWithSeveralColumnsOnAPoint)
{
    const prismLayers layers
    (
        frontLayers(frontOf(cube(4), 60), {0, 0.02, 0.05, 0.1})
    );

    ASSERT_GT(layers.extraColumnPoints.size(), 0);
    expectPiecesOfTheMesh(layers);
}


TEST(layersPiece, equalsTheWholeMeshOnAWallThatEnds)
{
    const wallSurface wall(endedOn(halfSphere(6), halfPlanes()));
    const prismLayerMesh run(layeredMesh(wall, 3, 0.1));

    ASSERT_GT(run.made.layers.border.edges.size(), 0);
    expectPiecesOfTheMesh(run.made.layers);
}

// ************************************************************************* //
