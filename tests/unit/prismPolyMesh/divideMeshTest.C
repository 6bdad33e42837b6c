/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sharedMesh.H"
#include "openSurfaces.H"
#include "polygonCells.H"
#include "testFarField.H"
#include "testLayers.H"
#include "testStages.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::testSurfaces;

//- All pieces are those of decomposePar
static void expectPiecesOf(const sharedMesh& divided)
{
    forAll(divided.pieces, i)
    {
        SCOPED_TRACE(i);
        const meshPiece& piece = divided.pieces[i];

        ASSERT_GT(piece.cellAddressing.size(), 0);
        EXPECT_EQ(piece.process, i);
        expectSamePiece
        (
            piece, pieceOfMesh(divided.mesh(), divided.processorOfCell, i)
        );
    }
}


static void expectPiecesOfTheMesh
(
    const prismLayers& layers,
    const farFieldMesh& far = farFieldMesh()
)
{
    expectPiecesOf(sharedMesh(layers, far, 4, mixedProcesses));
}


//- The pieces of polygons around a sphere, with four layers
static void expectPiecesOfPolygons(const bool hasFarField)
{
    farFieldControls controls;
    controls.type = farFieldType::tet;
    controls.forPolygons = true;
    controls.boundary.type = farBoundaryType::box;
    controls.boundary.box = boundBox(point::uniform(-4), point::uniform(4));
    const prismLayerMesh run(layeredMesh(sphere(6), 4, 0.1));
    farFieldMesh far(hasFarField ? farFieldOf(run, controls) : farFieldMesh());
    const polygonMesh polygons(makePolygonCells(run.made.layers, far));
    const label n = polygons.counts.nLayerCells;
    const sharedMesh divided(polygons.mesh, n, 4, mixedProcesses);

    expectPiecesOf(divided);
    for (label celli = 0; celli < n; ++celli)
    {
        EXPECT_EQ
        (
            divided.processorOfCell[celli],
            divided.processorOfCell[celli - celli % 4]
        );
    }
}


//- Tetrahedra around layers, in a box from that height on, with a zone
static farFieldMesh tetsAround(const prismLayerMesh& run, const scalar low = -4)
{
    farFieldControls controls;
    controls.type = farFieldType::tet;
    controls.polyhedra = false;
    controls.maxCells = 1000000;
    controls.boundary.type = farBoundaryType::box;
    controls.boundary.box = boundBox(point(-4, -4, low), point::uniform(4));
    farFieldMesh far(farFieldOf(run, controls));
    far.cellZones.append(cellZoneParts("some", labelList({1, 5, 8, 9, 40})));
    far.cellZones.last().frontFaces = labelList({2, 4, 9, 10, 11, 20});

    return far;
}


//- What is divided
static meshParts partsOf(const prismLayers& layers, farFieldMesh far)
{
    meshParts result;
    divideCells
    (
        meshOrder(layers, far).mesh(),
        [&](const meshParts& parts)
        {
            result = parts;
            return labelList(parts.centres.size(), Zero);
        }
    );

    return result;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(divideMesh, stacksAreBesideEachOther)
{
    const prismLayers layers(straightLayers(cube(3), {0, 0.1}));
    const labelListList beside(partsOf(layers, farFieldMesh()).neighbours);

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


TEST(divideMesh, aStackAtTheBorderHasFewerBesideIt)
{
    const prismLayers layers(onePolygon(4, {0, 0.1}));

    EXPECT_EQ(partsOf(layers, farFieldMesh()).neighbours, labelListList(1));
}


TEST(divideMesh, cellsOfTheFarFieldAreBesideStacks)
{
    const prismLayerMesh run(layeredMesh(quadSphere(4), 3, 0.1));
    const farFieldMesh far(tetsAround(run));
    const meshParts parts(partsOf(run.made.layers, far));
    const label nStacks = run.made.layers.faces.size();

    ASSERT_EQ(parts.weights.size(), nStacks + far.nCells);
    for (label i = 0; i < nStacks; ++i)
    {
        // Four stacks, and two tetrahedra on the quadrilateral
        EXPECT_EQ(parts.neighbours[i].size(), 6);
        EXPECT_EQ(parts.weights[i], 3);
        EXPECT_LT(mag(parts.centres[i]), 1.1);
    }
    EXPECT_EQ(sum(parts.weights), 3*nStacks + far.nCells);
}


TEST(divideMesh, centresOfStacksAreInTheMiddle)
{
    const prismLayers layers(onePolygon(5, {0, 0.1, 0.2}));
    const pointField centres(partsOf(layers, farFieldMesh()).centres);

    ASSERT_EQ(centres.size(), 1);
    EXPECT_NEAR(mag(centres[0] - point(0, 0, 0.1)), 0, 1e-15);
}


TEST(meshPiece, equalsTheWholeMeshOnTriangles)
{
    expectPiecesOfTheMesh(shakenLayers(sphere(5)));
}


TEST(meshPiece, ofAProcessWithoutCellsIsEmpty)
{
    const sharedMesh divided
    (
        shakenLayers(sphere(3)), farFieldMesh(), 2,
        [](const meshParts& parts)
        {
            return labelList(parts.centres.size(), Zero);
        }
    );
    const meshPiece& piece = divided.pieces[1];

    EXPECT_TRUE(piece.points.empty());
    EXPECT_TRUE(piece.faces.owner.empty());
    EXPECT_TRUE(piece.cellAddressing.empty());
    EXPECT_TRUE(piece.others.empty());
    EXPECT_EQ(piece.patchSizes, labelList(piece.patchNames.size(), Zero));
}


TEST(meshPiece, equalsTheWholeMeshOnQuadrilateralsInOneLayer)
{
    expectPiecesOfTheMesh(straightLayers(quadSphere(4), {0, 0.1}));
}


TEST(meshPiece, equalsTheWholeMeshWithSeveralColumnsOnAPoint)
{
    const prismLayers layers
    (
        frontLayers(frontOf(cube(4), 60), {0, 0.02, 0.05, 0.1})
    );

    ASSERT_GT(layers.extraColumnPoints.size(), 0);
    expectPiecesOfTheMesh(layers);
}


TEST(meshPiece, equalsTheWholeMeshOnAWallThatEnds)
{
    const wallSurface wall(endedOn(halfSphere(6), halfPlanes()));
    const prismLayerMesh run(layeredMesh(wall, 3, 0.1));

    ASSERT_GT(run.made.layers.border.edges.size(), 0);
    expectPiecesOfTheMesh(run.made.layers);
}


TEST(meshPiece, equalsTheWholeMeshWithAFarFieldOnQuadrilaterals)
{
    const prismLayerMesh run(layeredMesh(quadSphere(4), 3, 0.1));

    expectPiecesOfTheMesh(run.made.layers, tetsAround(run));
}


TEST(meshPiece, equalsTheWholeMeshWithAFarFieldOnSeveralColumnsOnAPoint)
{
    prismLayerControls controls;
    controls.layers = layersOf(3, 0.1);
    controls.layers.multipleNormalsAngle = 40;
    const prismLayerMesh run(layeredMesh(quadCube(3), controls));

    ASSERT_GT(run.made.layers.extraColumnPoints.size(), 0);
    expectPiecesOfTheMesh(run.made.layers, tetsAround(run));
}


TEST(meshPiece, equalsTheWholeMeshWithAFarFieldOnAWallThatEnds)
{
    const wallSurface wall(endedOn(halfSphere(6), halfPlanes()));
    const prismLayerMesh run(layeredMesh(wall, 3, 0.1));

    expectPiecesOfTheMesh(run.made.layers, tetsAround(run, 0));
}


TEST(meshPiece, equalsTheMeshOfPolygons)
{
    expectPiecesOfPolygons(true);
}


TEST(meshPiece, equalsTheMeshOfPolygonsWithoutAFarField)
{
    expectPiecesOfPolygons(false);
}


// ************************************************************************* //
