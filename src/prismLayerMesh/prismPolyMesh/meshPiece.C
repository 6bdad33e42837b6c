/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshPiece.H"
#include "DynamicList.H"
#include "labelIOList.H"
#include "meshFiles.H"
#include "processorPolyPatch.H"
#include "readWallSurface.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Collects the faces of a piece
struct pieceMaker
{
    const polyMesh& mesh;
    const labelUList& processorOfCell;
    const label processor;

    meshPiece piece{};

    //- Labels of cells in the piece, -1 for cells that are not in it
    labelList localCells = labelList(mesh.nCells(), -1);

    DynamicList<face> faces{};
    DynamicList<label> owner{};
    DynamicList<label> neighbour{};
    DynamicList<label> addressing{};

    bool isHere(const label celli) const { return localCells[celli] >= 0; }

    //- Add a face with one cell of the piece, its owner there
    void add(const label facei, const label celli, const bool turned)
    {
        const face& f = mesh.faces()[facei];
        faces.append(turned ? f.reverseFace() : f);
        owner.append(localCells[celli]);
        addressing.append(turned ? -(facei + 1) : facei + 1);
    }

    void addInternal()
    {
        for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
        {
            const label own = mesh.faceOwner()[facei];
            const label nei = mesh.faceNeighbour()[facei];
            if (isHere(own) && isHere(nei))
            {
                add(facei, own, false);
                neighbour.append(localCells[nei]);
            }
        }
    }

    void addPatches()
    {
        for (const polyPatch& patch : mesh.boundaryMesh())
        {
            const label before = faces.size();
            forAll(patch, i)
            {
                const label facei = patch.start() + i;
                if (isHere(mesh.faceOwner()[facei]))
                {
                    add(facei, mesh.faceOwner()[facei], false);
                }
            }
            piece.patchNames.append(patch.name());
            piece.patchTypes.append(patch.type());
            piece.patchSizes.append(faces.size() - before);
        }
    }

    //- Faces to other processes, one process after the other
    void addBetween()
    {
        Map<DynamicList<label>> facesTo;
        for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
        {
            const label own = mesh.faceOwner()[facei];
            const label nei = mesh.faceNeighbour()[facei];
            if (isHere(own) != isHere(nei))
            {
                const label otherCell = isHere(own) ? nei : own;
                facesTo(processorOfCell[otherCell]).append(facei);
            }
        }

        piece.processors = facesTo.sortedToc();
        for (const label other : piece.processors)
        {
            piece.processorSizes.append(facesTo[other].size());
            for (const label facei : facesTo[other])
            {
                const label own = mesh.faceOwner()[facei];
                const bool turned = !isHere(own);
                add
                (
                    facei, turned ? mesh.faceNeighbour()[facei] : own, turned
                );
            }
        }
    }

    void addPoints()
    {
        piece.points = mesh.points();
        piece.faces.transfer(faces);
        const labelList newPoints
        (
            removeUnusedPoints(piece.faces, piece.points)
        );
        piece.pointAddressing = invert(piece.points.size(), newPoints);
    }

    void addZones()
    {
        for (const cellZone& zone : mesh.cellZones())
        {
            DynamicList<label> cells;
            for (const label celli : zone)
            {
                if (isHere(celli))
                {
                    cells.append(localCells[celli]);
                }
            }
            piece.zoneNames.append(zone.name());
            piece.zones.append(labelList(std::move(cells)));
        }
    }

    meshPiece make()
    {
        DynamicList<label> cells;
        forAll(processorOfCell, celli)
        {
            if (processorOfCell[celli] == processor)
            {
                localCells[celli] = cells.size();
                cells.append(celli);
            }
        }
        piece.cellAddressing.transfer(cells);

        addInternal();
        addPatches();
        addBetween();
        addPoints();
        addZones();

        piece.owner.transfer(owner);
        piece.neighbour.transfer(neighbour);
        piece.faceAddressing.transfer(addressing);

        return std::move(piece);
    }
};

}


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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelList pieceParts::boundaryAddressing() const
{
    labelList addressing(identity(patchNames.size()));
    addressing.append(labelList(processors.size(), -1));

    return addressing;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

meshPiece makeMeshPiece
(
    const polyMesh& mesh,
    const labelUList& processorOfCell,
    const label processor
)
{
    return pieceMaker{mesh, processorOfCell, processor}.make();
}


void writeMeshPiece
(
    const meshPiece& piece,
    const label processor,
    const IOobject& io
)
{
    writeMeshPiece(piece, blocksOf(piece), processor, io);
}


void writeMeshPiece
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

} // End namespace Foam

// ************************************************************************* //
