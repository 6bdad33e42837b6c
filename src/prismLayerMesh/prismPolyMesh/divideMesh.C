/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "divideMesh.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Returns the label of the part that has a cell
static label partOf(const meshInBlocks& mesh, const label celli)
{
    const label n = mesh.nStackCells;

    return
        celli < n ? celli/mesh.nLayers : celli - n + n/mesh.nLayers;
}


static meshParts partsToDivide(const meshInBlocks& mesh)
{
    const label nParts = partOf(mesh, mesh.nCells);
    meshParts parts;
    parts.neighbours.setSize(nParts);
    parts.centres.setSize(nParts, Zero);
    parts.weights.setSize(nParts, 1);
    SubList<scalar>(parts.weights, partOf(mesh, mesh.nStackCells)) =
        mesh.nLayers;

    const pointField points(mesh.allPoints());
    labelList nFaces(nParts, 0);
    const auto addFace = [&](const label part, const point& centre)
    {
        parts.centres[part] += centre;
        ++nFaces[part];
    };
    const auto addBeside = [&](const label part, const label other)
    {
        if (part != other && !parts.neighbours[part].found(other))
        {
            parts.neighbours[part].append(other);
        }
    };
    for (label b = 0; b < mesh.nFaceBlocks; ++b)
    {
        const faceBlock block(mesh.faces(b));
        forAll(block.owner, i)
        {
            const label own = partOf(mesh, block.owner[i]);
            const point centre(face(block.face(i)).centre(points));
            addFace(own, centre);
            if (i < block.neighbour.size())
            {
                const label nei = partOf(mesh, block.neighbour[i]);
                addFace(nei, centre);
                addBeside(own, nei);
                addBeside(nei, own);
            }
        }
    }
    forAll(nFaces, part)
    {
        parts.centres[part] /= nFaces[part];
    }

    return parts;
}


//- Sends a piece from the master to its process. Collective.
//  piece: is empty except on the master. Becomes empty on the master.
static void send(const processTeam& team, meshPiece& piece)
{
    // List by list, because messages have a bound on their length
    piece.visitLists([&](auto& list)
    {
        List<message> sent(team.size());
        if (team.isMaster())
        {
            sent[piece.process](list);
            list.clear();
        }
        const List<message> received(team.exchange(sent));
        if (received[0].size())
        {
            messageReader reader(received[0]);
            reader(list);
        }
    });
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList divideCells(const meshInBlocks& mesh, const meshDivision& divide)
{
    const labelList ofParts(divide(partsToDivide(mesh)));
    labelList processes(mesh.nCells);
    forAll(processes, celli)
    {
        processes[celli] = ofParts[partOf(mesh, celli)];
    }

    return processes;
}


meshPiece makeMeshPiece
(
    const meshInBlocks& mesh,
    const processTeam& team,
    const meshDivision& divide
)
{
    labelList processOfCell;
    List<DynamicList<label>> blocks;
    if (team.isMaster())
    {
        processOfCell = divideCells(mesh, divide);
        blocks = blocksOfPieces(mesh, processOfCell, team.size());
    }

    // One piece after the other, so that the master has only one at a time
    meshPiece own;
    own.process = team.rank();
    for (label p = 1; p < team.size(); ++p)
    {
        meshPiece piece;
        if (team.isMaster())
        {
            piece = pieceOf(mesh, processOfCell, p, blocks[p]);
        }
        send(team, p == team.rank() ? own : piece);
    }
    if (team.isMaster())
    {
        own = pieceOf(mesh, processOfCell, 0, blocks[0]);
    }

    return own;
}

} // End namespace Foam

// ************************************************************************* //
