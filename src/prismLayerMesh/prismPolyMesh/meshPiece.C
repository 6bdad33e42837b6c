/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshPiece.H"
#include "bitSet.H"
#include "processorPolyPatch.H"

#include <map>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Cuts a piece out of a mesh
struct pieceCutter
{
    const meshInBlocks& mesh;
    const labelUList& processOfCell;

    meshPiece piece{};

    //- Labels of cells in the piece, -1 for cells that are not in it
    labelList localCells{};

    //- The faces to each other process
    std::map<label, addressedFaces> between{};

    void addCells()
    {
        DynamicList<label> cells;
        localCells.setSize(mesh.nCells, -1);
        forAll(processOfCell, celli)
        {
            if (processOfCell[celli] == piece.process)
            {
                localCells[celli] = cells.size();
                cells.append(celli);
            }
        }
        piece.cellAddressing.transfer(cells);
    }

    void addInternal
    (
        const labelUList& points,
        const label facei,
        const label owner,
        const label neighbour
    )
    {
        const label own = localCells[owner];
        const label nei = localCells[neighbour];
        if (own >= 0 && nei >= 0)
        {
            piece.faces.append(points, facei + 1, own, nei);
        }
        else if (own >= 0)
        {
            between[processOfCell[neighbour]].append(points, facei + 1, own);
        }
        else if (nei >= 0)
        {
            between[processOfCell[owner]].append(points, -(facei + 1), nei);
        }
    }

    void addFaces(const labelUList& blocks)
    {
        piece.patchNames = mesh.patches.names;
        piece.patchTypes = mesh.patches.types();
        piece.patchSizes.setSize(piece.patchNames.size(), 0);
        label patchi = 0;
        for (const label b : blocks)
        {
            const faceBlock block(mesh.faces(b));
            forAll(block.owner, i)
            {
                const label facei = mesh.firstFaces[b] + i;
                const label own = block.owner[i];
                if (i < block.neighbour.size())
                {
                    addInternal(block.face(i), facei, own, block.neighbour[i]);
                }
                else if (localCells[own] >= 0)
                {
                    while (facei >= mesh.patchStarts[patchi + 1])
                    {
                        ++patchi;
                    }
                    piece.faces.append
                    (
                        block.face(i), facei + 1, localCells[own]
                    );
                    ++piece.patchSizes[patchi];
                }
            }
        }
    }

    void addBetween()
    {
        for (const auto& other : between)
        {
            const addressedFaces& faces = other.second;
            piece.others.append(other.first);
            piece.patchSizes.append(faces.owner.size());
            forAll(faces.owner, i)
            {
                piece.faces.points.append(faces.face(i));
                piece.faces.endFace(faces.owner[i]);
                piece.faces.addressing.append(faces.addressing[i]);
            }
        }
    }

    void addPoints()
    {
        bitSet isUsed(mesh.nPoints);
        isUsed.set(piece.faces.points);
        piece.pointAddressing = isUsed.toc();
        inplaceRenumber(invert(isUsed), piece.faces.points);

        DynamicList<point> points(piece.pointAddressing.size());
        label pointi = 0;
        for (label b = 0; b < mesh.nPointBlocks; ++b)
        {
            for (const point& x : mesh.points(b))
            {
                if (isUsed[pointi++])
                {
                    points.append(x);
                }
            }
        }
        piece.points = pointField(std::move(points));
    }

    void addZones()
    {
        for (const cellZoneParts& zone : mesh.cellZones)
        {
            DynamicList<label> cells;
            for (const label celli : zone.cells)
            {
                if (localCells[celli] >= 0)
                {
                    cells.append(localCells[celli]);
                }
            }
            piece.zoneNames.append(zone.name);
            piece.zones.append(labelList(std::move(cells)));
        }
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void addressedFaces::append
(
    const labelUList& corners,
    const label address,
    const label ownerCell,
    const label neighbourCell
)
{
    const label n = corners.size();
    for (label k = 0; k < n; ++k)
    {
        points.append(corners[address < 0 ? (n - k) % n : k]);
    }
    endFace(ownerCell, neighbourCell);
    addressing.append(address);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

List<DynamicList<label>> blocksOfPieces
(
    const meshInBlocks& mesh,
    const labelUList& processOfCell,
    const label nProcesses
)
{
    List<DynamicList<label>> blocks(nProcesses);
    for (label b = 0; b < mesh.nFaceBlocks; ++b)
    {
        const faceBlock block(mesh.faces(b));
        bitSet isIn(nProcesses);
        isIn.set(labelUIndList(processOfCell, block.owner)());
        isIn.set(labelUIndList(processOfCell, block.neighbour)());
        for (const label p : isIn)
        {
            blocks[p].append(b);
        }
    }

    return blocks;
}


meshPiece pieceOf
(
    const meshInBlocks& mesh,
    const labelUList& processOfCell,
    const label process,
    const labelUList& blocks
)
{
    pieceCutter cutter{mesh, processOfCell};
    cutter.piece.process = process;
    cutter.addCells();
    cutter.addFaces(blocks);
    cutter.addBetween();
    cutter.addPoints();
    cutter.addZones();

    return std::move(cutter.piece);
}


meshInBlocks blocksOf(const meshPiece& piece)
{
    const addressedFaces& faces = piece.faces;
    meshInBlocks blocks;
    blocks.nCells = piece.cellAddressing.size();
    blocks.setPoints(piece.points);
    blocks.setFaces
    (
        faces.owner, faces.neighbour,
        [&faces](const label i) { return faces.face(i); }
    );

    forAll(piece.patchNames, i)
    {
        blocks.patches.append(piece.patchNames[i], piece.patchTypes[i]);
    }
    for (const label other : piece.others)
    {
        blocks.patches.append
        (
            processorPolyPatch::newName(piece.process, other),
            processorPolyPatch::typeName
        );
        dictionary& entries = blocks.patches.entries.last();
        entries.add("myProcNo", piece.process);
        entries.add("neighbProcNo", other);
    }
    blocks.patchStarts.append(faces.neighbour.size());
    for (const label size : piece.patchSizes)
    {
        blocks.patchStarts.append(blocks.patchStarts.last() + size);
    }
    forAll(piece.zones, i)
    {
        blocks.cellZones.append
        (
            cellZoneParts(piece.zoneNames[i], piece.zones[i])
        );
    }

    return blocks;
}

} // End namespace Foam

// ************************************************************************* //
