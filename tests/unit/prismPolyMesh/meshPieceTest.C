/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sharedMesh.H"
#include "labelIOList.H"
#include "temporaryFiles.H"
#include "testLayers.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- A mesh in pieces, not all of which touch each other
struct piecedMesh
:
    sharedMesh
{
    List<listedPiece> lists;

    piecedMesh()
    :
        sharedMesh
        (
            testSurfaces::shakenLayers(testSurfaces::sphere(4)),
            farFieldMesh(), 3,
            [](const meshParts& parts)
            {
                labelList processes(parts.centres.size());
                forAll(processes, i)
                {
                    const scalar x = parts.centres[i].x();
                    processes[i] = x < -0.5 ? 0 : x < 0.5 ? 1 : 2;
                }

                return processes;
            }
        ),
        lists(pieces.size())
    {
        forAll(lists, i)
        {
            lists[i] = inLists(i);
        }
    }

    bool isBetween(const label facei) const
    {
        return facei < mesh().nInternalFaces()
            && processorOfCell[mesh().faceOwner()[facei]]
            != processorOfCell[mesh().faceNeighbour()[facei]];
    }
};


//- First face to the k-th other process
static label startOf(const listedPiece& piece, const label k)
{
    label start = piece.neighbour.size() + sum(piece.patchSizes);
    for (label i = 0; i < k; ++i)
    {
        start += piece.processorSizes[i];
    }

    return start;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(meshPiece, everyCellIsInOne)
{
    const piecedMesh m;
    labelList n(m.mesh().nCells(), Zero);

    for (const listedPiece& piece : m.lists)
    {
        for (const label celli : piece.cellAddressing)
        {
            ++n[celli];
        }
        EXPECT_EQ
        (
            piece.points,
            pointField(m.mesh().points(), piece.pointAddressing)
        );
    }

    EXPECT_EQ(n, labelList(m.mesh().nCells(), 1));
}


TEST(meshPiece, facesAreThoseOfTheWholeMesh)
{
    const piecedMesh m;
    labelList n(m.mesh().nFaces(), Zero);

    for (const listedPiece& piece : m.lists)
    {
        forAll(piece.faces, i)
        {
            const bool turned = piece.faceAddressing[i] < 0;
            const label facei = mag(piece.faceAddressing[i]) - 1;
            const face& f = m.mesh().faces()[facei];
            face own(piece.faces[i]);
            inplaceRenumber(piece.pointAddressing, own);

            EXPECT_EQ(own, turned ? f.reverseFace() : f);
            EXPECT_EQ
            (
                piece.cellAddressing[piece.owner[i]],
                turned
              ? m.mesh().faceNeighbour()[facei] : m.mesh().faceOwner()[facei]
            );
            ++n[facei];
        }
    }

    forAll(n, facei)
    {
        EXPECT_EQ(n[facei], m.isBetween(facei) ? 2 : 1);
    }
}


TEST(meshPiece, facesBetweenProcessesAreInOneOrder)
{
    const piecedMesh m;
    EXPECT_EQ(m.lists[0].processors, labelList(1, 1));
    EXPECT_EQ(m.lists[1].processors, labelList({0, 2}));

    for (const label other : {0, 2})
    {
        const listedPiece& a = m.lists[1];
        const listedPiece& b = m.lists[other];
        const label k = a.processors.find(other);
        EXPECT_EQ(a.processorSizes[k], b.processorSizes[0]);

        for (label i = 0; i < a.processorSizes[k]; ++i)
        {
            EXPECT_EQ
            (
                a.faceAddressing[startOf(a, k) + i],
                -b.faceAddressing[startOf(b, 0) + i]
            );
        }
    }
}


class meshPieceFiles
:
    public temporaryFiles
{};


TEST_F(meshPieceFiles, areAMeshInUpperTriangularOrder)
{
    const piecedMesh m;
    dictionary control;
    control.add("deltaT", 1);
    control.add("writeInterval", 1);
    control.add("writePrecision", 17);
    const Time time
    (
        control, folder_, "case", "system", "constant", false, false
    );

    forAll(m.pieces, i)
    {
        IOobject io("piece" + name(i), time.constant(), time);
        writeMeshPiece(m.pieces[i], io);
        io.readOpt() = IOobject::MUST_READ;
        const polyMesh mesh(io);

        EXPECT_EQ(mesh.nCells(), m.lists[i].cellAddressing.size());
        EXPECT_EQ(mesh.points(), m.lists[i].points);
        EXPECT_EQ(mesh.faces(), m.lists[i].faces);
        EXPECT_FALSE(mesh.checkUpperTriangular());
        EXPECT_EQ(mesh.boundaryMesh().last().type(), "processor");
        EXPECT_FALSE(mesh.boundaryMesh().checkDefinition());
        EXPECT_EQ
        (
            labelIOList
            (
                IOobject
                (
                    "faceProcAddressing", time.constant(), polyMesh::meshSubDir,
                    mesh, IOobject::MUST_READ, IOobject::NO_WRITE, false
                )
            ),
            m.lists[i].faceAddressing
        );
    }
}


// ************************************************************************* //
