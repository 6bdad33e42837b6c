/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "divideMesh.H"

#include "polygonCells.H"
#include "sharedMesh.H"
#include "testFarField.H"
#include "testStages.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Polygons around a sphere, with four layers
static polygonMesh polygonsOnSphere(const bool hasFarField)
{
    farFieldControls controls;
    controls.type = farFieldType::tet;
    controls.forPolygons = true;
    controls.boundary.type = farBoundaryType::box;
    controls.boundary.box = boundBox(point::uniform(-4), point::uniform(4));
    const prismLayerMesh run(layeredMesh(sphere(6), 4, 0.1));
    farFieldMesh far(hasFarField ? farFieldOf(run, controls) : farFieldMesh());

    return makePolygonCells(run.made.layers, far);
}


//- Divides a mesh on four threads; all pieces are those of decomposePar
static void expectPiecesOf(const polygonMesh& polygons)
{
    stackedMesh whole{polygons.mesh, polygons.counts.nLayerCells, 4};
    labelList processorOfCell(polygons.mesh.nCells);
    List<meshPiece> pieces(4);
    std::mutex storing;
    threadTeam::run(4, [&](const threadTeam& processes)
    {
        stackedMesh ofMaster{polyMeshParts(), 0, 1};
        if (processes.isMaster())
        {
            ofMaster = whole;
        }
        meshPiece piece
        (
            makeMeshPiece
            (
                std::move(ofMaster), processes,
                [&](const meshParts& parts)
                {
                    const labelList ofParts(mixedProcesses(parts));
                    forAll(processorOfCell, celli)
                    {
                        processorOfCell[celli] = ofParts[whole.partOf(celli)];
                    }

                    return ofParts;
                }
            )
        );
        const std::lock_guard<std::mutex> lock(storing);
        pieces[processes.rank()] = std::move(piece);
    });

    const memoryMesh mesh(polyMeshParts(polygons.mesh));
    forAll(pieces, i)
    {
        SCOPED_TRACE(i);
        const listedPiece own(pieceInLists(pieces[i]));
        ASSERT_GT(own.cellAddressing.size(), 0);
        expectSamePiece(own, pieceOfMesh(mesh(), processorOfCell, i));
    }
}

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(stackedMesh, partsAreStacksThenCells)
{
    const stackedMesh mesh{polyMeshParts(), 6, 3};

    EXPECT_EQ(mesh.partOf(2), 0);
    EXPECT_EQ(mesh.partOf(3), 1);
    EXPECT_EQ(mesh.partOf(6), 2);
    EXPECT_EQ(mesh.partOf(7), 3);
}


TEST(stackedMesh, piecesEqualTheMeshOfPolygons)
{
    expectPiecesOf(polygonsOnSphere(true));
}


TEST(stackedMesh, piecesEqualTheMeshOfPolygonsWithoutAFarField)
{
    expectPiecesOf(polygonsOnSphere(false));
}


// ************************************************************************* //
