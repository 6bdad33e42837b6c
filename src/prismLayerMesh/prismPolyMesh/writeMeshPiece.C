/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writeMeshPiece.H"
#include "labelIOList.H"
#include "meshFiles.H"
#include "pieceOrder.H"
#include "processorPolyPatch.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The patches of the whole mesh, then those to other processes
static void addPatches
(
    const label processor,
    const pieceParts& piece,
    label start,
    polyMesh& mesh
)
{
    const label nWhole = piece.patchNames.size();
    const polyBoundaryMesh& boundary = mesh.boundaryMesh();
    PtrList<polyPatch> patches(nWhole + piece.processors.size());

    forAll(piece.patchNames, i)
    {
        const label size = piece.patchSizes[i];
        patches.set
        (
            i,
            polyPatch::New
            (
                piece.patchTypes[i], piece.patchNames[i], size, start, i,
                boundary
            )
        );
        start += size;
    }
    forAll(piece.processors, i)
    {
        const label size = piece.processorSizes[i];
        patches.set
        (
            nWhole + i,
            new processorPolyPatch
            (
                size, start, nWhole + i, boundary, processor,
                piece.processors[i]
            )
        );
        start += size;
    }
    mesh.addPatches(patches, false);
}


static void addZones(const pieceParts& piece, polyMesh& mesh)
{
    List<cellZone*> zones;
    forAll(piece.zones, i)
    {
        zones.append
        (
            new cellZone
            (
                piece.zoneNames[i], piece.zones[i], i, mesh.cellZones()
            )
        );
    }
    if (zones.size())
    {
        mesh.addZones(List<pointZone*>(), List<faceZone*>(), zones);
    }
}


//- The piece in blocks, at least one of faces and one of points
static meshBlocks blocksOf(const meshPiece& piece)
{
    static constexpr label blockSize = meshBlocks::blockSize;

    const label nPoints = piece.points.size();
    const label nFaces = piece.faces.size();
    meshBlocks mesh;
    mesh.nCells = piece.cellAddressing.size();
    mesh.nPoints = nPoints;
    mesh.nPointBlocks = max(label(1), numberOfBlocks(nPoints, blockSize));
    mesh.points = [&piece, nPoints](const label i)
    {
        const labelRange range(rangeOfBlock(nPoints, blockSize, i));

        return pointField
        (
            SubList<point>(piece.points, range.size(), range.start())
        );
    };
    mesh.nFaceBlocks = max(label(1), numberOfBlocks(nFaces, blockSize));
    mesh.faces = [&piece, nFaces](const label i)
    {
        faceBlock block;
        for (const label facei : rangeOfBlock(nFaces, blockSize, i))
        {
            block.points.append(piece.faces[facei]);
            block.endFace
            (
                piece.owner[facei],
                facei < piece.neighbour.size() ? piece.neighbour[facei] : -1
            );
        }

        return block;
    };
    mesh.count();

    return mesh;
}


static void writeAddressing(const polyMesh& frame, const pieceParts& piece)
{
    const auto write = [&](const char* name, const labelUList& labels)
    {
        const IOobject io
        (
            name, frame.facesInstance(), polyMesh::meshSubDir, frame,
            IOobject::NO_READ, IOobject::NO_WRITE, false
        );
        writeWhole(labelIOList(io, labelList(labels)));
    };

    write("cellProcAddressing", piece.cellAddressing);
    write("faceProcAddressing", piece.faceAddressing);
    write("pointProcAddressing", piece.pointAddressing);
    write("boundaryProcAddressing", piece.boundaryAddressing());
}


static void writePiece
(
    const pieceParts& parts,
    const meshBlocks& blocks,
    const label processor,
    const IOobject& io
)
{
    polyMesh frame
    (
        io, pointField(), faceList(), labelList(), labelList(), false
    );
    addPatches(processor, parts, blocks.nInternalFaces(), frame);
    addZones(parts, frame);

    writeMeshFiles(frame, blocks);
    writeAddressing(frame, parts);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void writeMeshPiece
(
    const meshPiece& piece,
    const label processor,
    const IOobject& io
)
{
    writePiece(piece, blocksOf(piece), processor, io);
}


void writeMeshPiece
(
    const layersPiece& piece,
    const label processor,
    const IOobject& io
)
{
    const pieceOrder order(piece, processor);
    writePiece(order.parts(), order.blocks(), processor, io);
}

} // End namespace Foam

// ************************************************************************* //
