/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshPiece.H"
#include "DynamicList.H"
#include "labelIOList.H"
#include "processorPolyPatch.H"
#include "readWallSurface.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Collects the faces of a piece
class pieceMaker
{
    const polyMesh& mesh_;
    const labelUList& processorOfCell_;
    const label processor_;

    meshPiece piece_;

    //- Labels of cells in the piece, -1 for cells that are not in it
    labelList localCells_;

    DynamicList<face> faces_;
    DynamicList<label> owner_;
    DynamicList<label> neighbour_;
    DynamicList<label> addressing_;

    bool isHere(const label celli) const { return localCells_[celli] >= 0; }

    //- Add a face with one cell of the piece, its owner there
    void add(const label facei, const label celli, const bool turned)
    {
        const face& f = mesh_.faces()[facei];
        faces_.append(turned ? f.reverseFace() : f);
        owner_.append(localCells_[celli]);
        addressing_.append(turned ? -(facei + 1) : facei + 1);
    }

    void addInternal()
    {
        for (label facei = 0; facei < mesh_.nInternalFaces(); ++facei)
        {
            const label own = mesh_.faceOwner()[facei];
            const label nei = mesh_.faceNeighbour()[facei];
            if (isHere(own) && isHere(nei))
            {
                add(facei, own, false);
                neighbour_.append(localCells_[nei]);
            }
        }
    }

    void addPatches()
    {
        for (const polyPatch& patch : mesh_.boundaryMesh())
        {
            const label before = faces_.size();
            forAll(patch, i)
            {
                const label facei = patch.start() + i;
                if (isHere(mesh_.faceOwner()[facei]))
                {
                    add(facei, mesh_.faceOwner()[facei], false);
                }
            }
            piece_.patchNames.append(patch.name());
            piece_.patchTypes.append(patch.type());
            piece_.patchSizes.append(faces_.size() - before);
        }
    }

    //- Faces to other processes, one process after the other
    void addBetween()
    {
        Map<DynamicList<label>> facesTo;
        for (label facei = 0; facei < mesh_.nInternalFaces(); ++facei)
        {
            const label own = mesh_.faceOwner()[facei];
            const label nei = mesh_.faceNeighbour()[facei];
            if (isHere(own) != isHere(nei))
            {
                const label there = isHere(own) ? nei : own;
                facesTo(processorOfCell_[there]).append(facei);
            }
        }

        piece_.processors = facesTo.sortedToc();
        for (const label other : piece_.processors)
        {
            piece_.processorSizes.append(facesTo[other].size());
            for (const label facei : facesTo[other])
            {
                const label own = mesh_.faceOwner()[facei];
                const bool turned = !isHere(own);
                add
                (
                    facei, turned ? mesh_.faceNeighbour()[facei] : own, turned
                );
            }
        }
    }

    void addPoints()
    {
        piece_.points = mesh_.points();
        piece_.faces.transfer(faces_);
        const labelList newPoints
        (
            removeUnusedPoints(piece_.faces, piece_.points)
        );
        piece_.pointAddressing = invert(piece_.points.size(), newPoints);
    }

    void addZones()
    {
        for (const cellZone& zone : mesh_.cellZones())
        {
            DynamicList<label> cells;
            for (const label celli : zone)
            {
                if (isHere(celli))
                {
                    cells.append(localCells_[celli]);
                }
            }
            piece_.zoneNames.append(zone.name());
            piece_.zones.append(labelList(std::move(cells)));
        }
    }

public:

    pieceMaker
    (
        const polyMesh& mesh,
        const labelUList& processorOfCell,
        const label processor
    )
    :
        mesh_(mesh),
        processorOfCell_(processorOfCell),
        processor_(processor),
        localCells_(mesh.nCells(), -1)
    {}

    meshPiece make()
    {
        DynamicList<label> cells;
        forAll(processorOfCell_, celli)
        {
            if (processorOfCell_[celli] == processor_)
            {
                localCells_[celli] = cells.size();
                cells.append(celli);
            }
        }
        piece_.cellAddressing.transfer(cells);

        addInternal();
        addPatches();
        addBetween();
        addPoints();
        addZones();

        piece_.owner.transfer(owner_);
        piece_.neighbour.transfer(neighbour_);
        piece_.faceAddressing.transfer(addressing_);

        return std::move(piece_);
    }
};

}


//- The patches of the whole mesh, then those to other processes
static void addPatches
(
    const label processor,
    const label nInternalFaces,
    const meshPiece& piece,
    polyMesh& mesh
)
{
    const label nWhole = piece.patchNames.size();
    const polyBoundaryMesh& boundary = mesh.boundaryMesh();
    PtrList<polyPatch> patches(nWhole + piece.processors.size());
    label start = nInternalFaces;

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


static void addZones(const meshPiece& piece, polyMesh& mesh)
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelList meshPiece::boundaryAddressing() const
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
    return pieceMaker(mesh, processorOfCell, processor).make();
}


autoPtr<polyMesh> makePolyMesh
(
    const IOobject& io,
    const label processor,
    meshPiece& piece
)
{
    const label nInternal = piece.neighbour.size();
    autoPtr<polyMesh> mesh
    (
        new polyMesh
        (
            io, std::move(piece.points), std::move(piece.faces),
            std::move(piece.owner), std::move(piece.neighbour), false
        )
    );
    addPatches(processor, nInternal, piece, mesh());
    addZones(piece, mesh());

    return mesh;
}


bool writeAddressing(const polyMesh& mesh, const meshPiece& piece)
{
    const auto write = [&](const char* name, const labelUList& labels)
    {
        const IOobject io
        (
            name, mesh.facesInstance(), polyMesh::meshSubDir, mesh,
            IOobject::NO_READ, IOobject::NO_WRITE, false
        );

        return labelIOList(io, labelList(labels)).write();
    };

    return write("cellProcAddressing", piece.cellAddressing)
        && write("faceProcAddressing", piece.faceAddressing)
        && write("pointProcAddressing", piece.pointAddressing)
        && write("boundaryProcAddressing", piece.boundaryAddressing());
}


} // End namespace Foam

// ************************************************************************* //
