/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshPiece.H"
#include "DynamicList.H"
#include "surfacePart.H"

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

} // End anonymous namespace


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

} // End namespace Foam

// ************************************************************************* //
