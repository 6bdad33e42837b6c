/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pieceMessages.H"
#include "bitSet.H"
#include "meshOrder.H"
#include "prismFaces.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Divides the faces of a far field, then its zones
struct farFieldDivider
{
    const prismLayers& layers;
    const farFieldMesh& far;

    //- Labels of its faces in the whole mesh
    const labelList& faceLabels;

    //- Processes of all stacks and of all cells of the far field
    const SubList<label> ofStacks;
    const SubList<label> ofCells;

    List<sentFarField> pieces;

    //- Faces to other processes, with their corners
    List<sentFarField> between;

    //- By cell of the far field: its label in its piece
    labelList local = labelList(far.nCells);

    void addCells()
    {
        forAll(local, celli)
        {
            DynamicList<label>& cells = pieces[ofCells[celli]].cells;
            local[celli] = cells.size();
            cells.append(celli);
        }
    }

    static void add
    (
        const farFaceRecord& record,
        const face& corners,
        sentFarField& to
    )
    {
        to.faces.append(record);
        to.corners.append(corners);
    }

    //- Adds a face whose owner in the whole mesh is in the piece of process p,
    //  and the other cell in the piece of process q. The face is seen from the
    //  owner.
    void addBetween
    (
        const label p,
        const label q,
        const label owner,
        const label neighbour,
        const label address,
        const face& f
    )
    {
        add({-2, address, owner, q, f.size()}, f, between[p]);
        add
        (
            {-2, -address, neighbour, p, f.size()}, f.reverseFace(), between[q]
        );
    }

    void addInternal(const label facei)
    {
        const face& f = far.topology.faces[facei];
        const label own = far.topology.owner[facei];
        const label nei = far.topology.neighbour[facei];
        const label p = ofCells[own];
        const label q = ofCells[nei];
        const label address = faceLabels[facei] + 1;
        if (p == q)
        {
            add({-1, address, local[own], local[nei], f.size()}, f, pieces[p]);
        }
        else
        {
            addBetween(p, q, local[own], local[nei], address, f);
        }
    }

    //- Adds a face on the layers, which is seen from the far field. The stack
    //  has the owner in the whole mesh.
    void addOnLayers(const label facei, const label stack)
    {
        const face& f = far.topology.faces[facei];
        const label celli = far.topology.owner[facei];
        const label p = ofStacks[stack];
        const label q = ofCells[celli];
        const label address = faceLabels[facei] + 1;
        if (p == q)
        {
            add({0, address, local[celli], stack, f.size()}, f, pieces[p]);
        }
        else
        {
            addBetween
            (
                p, q, -1 - stack, local[celli], address, f.reverseFace()
            );
        }
    }

    void addFaces()
    {
        const polyMeshTopology& mesh = far.topology;
        forAll(mesh.neighbour, facei)
        {
            addInternal(facei);
        }
        forAll(far.frontFaces, i)
        {
            addOnLayers(mesh.patchStarts[0] + i, far.frontFaces[i]);
        }
        for (label patchi = 1; patchi < mesh.patchSizes.size(); ++patchi)
        {
            for (label i = 0; i < mesh.patchSizes[patchi]; ++i)
            {
                const label facei = mesh.patchStarts[patchi] + i;
                const face& f = mesh.faces[facei];
                const label own = mesh.owner[facei];
                add
                (
                    {
                        patchi, faceLabels[facei] + 1, local[own], -1, f.size()
                    },
                    f, pieces[ofCells[own]]
                );
            }
        }
        forAll(pieces, p)
        {
            pieces[p].faces.append(between[p].faces);
            pieces[p].corners.append(between[p].corners);
        }
        between.clear();
    }

    void addPoints()
    {
        for (sentFarField& piece : pieces)
        {
            bitSet isUsed(far.points.size());
            isUsed.set(piece.corners);
            piece.points = isUsed.toc();
            piece.coordinates = pointField(far.points, piece.points);
            inplaceRenumber(invert(isUsed), piece.corners);
            for (const label p : piece.points)
            {
                if (p < layers.nColumns())
                {
                    piece.roots.append(layers.root(p));
                }
            }
        }
    }

    void addZones()
    {
        for (sentFarField& piece : pieces)
        {
            piece.zoneCells.setSize(far.cellZones.size());
            piece.zoneStacks.setSize(far.cellZones.size());
        }
        forAll(far.cellZones, i)
        {
            for (const label celli : far.cellZones[i].cells)
            {
                pieces[ofCells[celli]].zoneCells[i].append(local[celli]);
            }
            for (const label stack : far.cellZones[i].frontFaces)
            {
                pieces[ofStacks[stack]].zoneStacks[i].append(stack);
            }
        }
    }
};

} // End anonymous namespace


//- The parts of a mesh with a far field
static meshParts partsOfMesh(const prismLayers& layers, const meshBlocks& mesh)
{
    const label nStacks = layers.faces.size();
    const label nLayerCells = nStacks*layers.nLayers;
    const auto partOf = [&](const label celli)
    {
        return celli < nLayerCells
          ? celli/layers.nLayers : nStacks + celli - nLayerCells;
    };

    meshParts parts;
    parts.neighbours.setSize(nStacks + mesh.nCells - nLayerCells);
    parts.centres.setSize(parts.neighbours.size(), Zero);
    parts.weights.setSize(parts.neighbours.size(), Zero);
    const auto addBeside = [&](const label part, const label other)
    {
        if (part != other && !parts.neighbours[part].found(other))
        {
            parts.neighbours[part].append(other);
        }
    };

    // Means of the centres of the faces
    const pointField points(mesh.allPoints());
    pointField centres(mesh.nCells, Zero);
    labelList nFaces(mesh.nCells, 0);
    for (label b = 0; b < mesh.nFaceBlocks; ++b)
    {
        const faceBlock block(mesh.faces(b));
        forAll(block.owner, i)
        {
            const label own = block.owner[i];
            const point x(face(block.face(i)).centre(points));
            centres[own] += x;
            ++nFaces[own];
            if (i < block.neighbour.size())
            {
                const label nei = block.neighbour[i];
                centres[nei] += x;
                ++nFaces[nei];
                addBeside(partOf(own), partOf(nei));
                addBeside(partOf(nei), partOf(own));
            }
        }
    }
    forAll(centres, celli)
    {
        centres[celli] /= nFaces[celli];
        parts.centres[partOf(celli)] += centres[celli];
        parts.weights[partOf(celli)] += 1;
    }
    parts.centres /= parts.weights;

    return parts;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList divideFarField
(
    const prismLayers& layers,
    const farFieldMesh& far,
    const UList<labelPair>& patchParts,
    const label nProcesses,
    const meshDivision& divide,
    List<sentFarField>& pieces
)
{
    labelListList neighbours(findFaceNeighbours(layers));
    const List<DynamicList<labelPair>> open(openEdges(layers, neighbours));
    const meshOrder order(layers, far, std::move(neighbours), open, patchParts);
    const labelList processes(divide(partsOfMesh(layers, order.blocks())));
    const label nStacks = layers.faces.size();
    const labelList faceLabels(order.farFaceLabels());
    farFieldDivider divider
    {
        layers, far, faceLabels, SubList<label>(processes, nStacks),
        SubList<label>(processes, far.nCells, nStacks),
        List<sentFarField>(nProcesses), List<sentFarField>(nProcesses)
    };
    divider.addCells();
    divider.addFaces();
    divider.addPoints();
    divider.addZones();
    pieces = std::move(divider.pieces);

    return processes;
}


sentFarField receiveFarField
(
    const columnTeam& team,
    const label nZones,
    List<sentFarField>& pieces
)
{
    // List by list, because messages have a bound on their length
    sentFarField own;
    own.zoneCells.setSize(nZones);
    own.zoneStacks.setSize(nZones);
    label nLists = 0;
    visitLists(own, [&](auto&) { ++nLists; });

    for (label k = 0; k < nLists; ++k)
    {
        List<message> sent(team.size());
        forAll(pieces, p)
        {
            label i = 0;
            visitLists
            (
                pieces[p],
                [&](auto& list)
                {
                    if (i++ == k)
                    {
                        sent[p](list);
                    }
                }
            );
        }
        const List<message> received(team.exchange(sent));
        messageReader reader(received[0]);
        label i = 0;
        visitLists
        (
            own,
            [&](auto& list)
            {
                if (i++ == k)
                {
                    reader(list);
                }
            }
        );
    }

    return own;
}

} // End namespace Foam

// ************************************************************************* //
