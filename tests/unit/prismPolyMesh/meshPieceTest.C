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
        )
    {}

    bool isBetween(const label facei) const
    {
        return facei < mesh().nInternalFaces()
            && processorOfCell[mesh().faceOwner()[facei]]
            != processorOfCell[mesh().faceNeighbour()[facei]];
    }
};


static faceList facesOf(const meshPiece& piece)
{
    faceList faces(piece.faces.ends.size());
    forAll(faces, i)
    {
        faces[i] = face(piece.faces.face(i));
    }

    return faces;
}


//- Labels in the whole mesh of the faces to the k-th other process
static labelList addressesTo(const meshPiece& piece, const label k)
{
    const label n = piece.patchNames.size() + k;
    const label start =
        piece.faces.neighbour.size() + sum(SubList<label>(piece.patchSizes, n));

    return SubList<label>(piece.faces.addressing, piece.patchSizes[n], start);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(meshPiece, everyCellIsInOne)
{
    const piecedMesh m;
    labelList n(m.mesh().nCells(), Zero);

    for (const meshPiece& piece : m.pieces)
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

    for (const meshPiece& piece : m.pieces)
    {
        const faceList faces(facesOf(piece));
        forAll(faces, i)
        {
            const label address = piece.faces.addressing[i];
            const bool turned = address < 0;
            const label facei = mag(address) - 1;
            const face& f = m.mesh().faces()[facei];
            face own(faces[i]);
            inplaceRenumber(piece.pointAddressing, own);

            EXPECT_EQ(own, turned ? f.reverseFace() : f);
            EXPECT_EQ
            (
                piece.cellAddressing[piece.faces.owner[i]],
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
    EXPECT_EQ(m.pieces[0].others, labelList(1, 1));
    EXPECT_EQ(m.pieces[1].others, labelList({0, 2}));

    for (const label k : {0, 1})
    {
        const meshPiece& a = m.pieces[1];
        const meshPiece& b = m.pieces[a.others[k]];
        labelList addresses(addressesTo(b, 0));
        for (label& address : addresses)
        {
            address = -address;
        }

        EXPECT_EQ(addressesTo(a, k), addresses);
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

        EXPECT_EQ(mesh.nCells(), m.pieces[i].cellAddressing.size());
        EXPECT_EQ(mesh.points(), m.pieces[i].points);
        EXPECT_EQ(mesh.faces(), facesOf(m.pieces[i]));
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
            m.pieces[i].faces.addressing
        );
    }
}


// ************************************************************************* //
