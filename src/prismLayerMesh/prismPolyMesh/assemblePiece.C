/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bitSet.H"
#include "frontPart.H"
#include "Map.H"
#include "pieceMessages.H"

#include <algorithm>
#include <tuple>

namespace Foam
{

//- Sets the stacks of a piece and their edges. Returns the labels of the stacks
static labelList receiveStacks(const List<message>& messages, meshPiece& piece)
{
    DynamicList<meshStack> stacks;
    DynamicList<stackEdge> edges;
    DynamicList<stackSide> sides;
    for (const message& m : messages)
    {
        sentStacks received;
        messageReader reader(m);
        reader(received.stacks, received.edges, received.sides);
        for (meshStack& stack : received.stacks)
        {
            stack.firstEdge += edges.size();
        }
        stacks.append(received.stacks);
        edges.append(received.edges);
        sides.append(received.sides);
    }
    std::sort
    (
        stacks.begin(), stacks.end(),
        [](const meshStack& a, const meshStack& b) { return a.stack < b.stack; }
    );

    labelList labels(stacks.size());
    forAll(labels, i)
    {
        labels[i] = stacks[i].stack;
    }
    placeInList place(labels);
    for (const stackSide& side : sides)
    {
        stackEdge& e = edges[stacks[place(side.stack)].firstEdge + side.k];
        e.firstSide = side.firstSide;
        e.sideStride = side.sideStride;
    }
    piece.stacks = std::move(stacks);
    piece.edges = std::move(edges);

    return labels;
}


//- Sets the columns of a piece, and the points of the wall under further ones
static void setColumns(const sentFarField& far, meshPiece& piece)
{
    bitSet isIn(piece.nColumns);
    Map<label> roots;
    const auto add = [&](const label column, const label root)
    {
        isIn.set(column);
        isIn.set(root);
        if (column != root)
        {
            roots.set(column, root);
        }
    };
    for (const stackEdge& e : piece.edges)
    {
        add(e.column, e.root);
    }
    forAll(far.roots, i)
    {
        add(far.points[i], far.roots[i]);
    }
    piece.columns = isIn.toc();

    placeInList place(piece.columns);
    DynamicList<label> points(roots.size());
    for (const label c : roots.sortedToc())
    {
        points.append(place(roots[c]));
    }
    piece.layers.extraColumnPoints = std::move(points);
    piece.layers.points.setSize
    (
        piece.columns.size()*(piece.layers.nLayers + 1)
    );
}


//- Sets the front faces of a piece. Adds the sides of its stacks that are faces
//  to other processes
static void setStacks(meshPiece& piece, DynamicList<faceBetween>& between)
{
    prismLayers& layers = piece.layers;
    DynamicList<label> patches;
    placeInList place(piece.columns);
    layers.faces.setSize(piece.stacks.size());

    forAll(piece.stacks, i)
    {
        const meshStack& stack = piece.stacks[i];
        if (stack.patch >= 0)
        {
            patches.append(stack.patch);
        }
        layers.faces[i].setSize(stack.nEdges);
        for (label k = 0; k < stack.nEdges; ++k)
        {
            const stackEdge& e = piece.edges[stack.firstEdge + k];
            layers.faces[i][k] = place(e.column);
            if (e.open >= 0)
            {
                piece.open[e.open].append(labelPair(i, k));
            }

            const bool isBetween = e.process >= 0 && e.process != piece.process;
            for (label level = 1; isBetween && level <= layers.nLayers; ++level)
            {
                const meshFace f
                {
                    prismFaceKey{i, k, level}, -1, e.neighbour < stack.stack
                };
                between.append
                (
                    faceBetween
                    {
                        e.process, piece.faceAddress(f),
                        cellLabel(layers, i, level), f
                    }
                );
            }
        }
    }
    layers.patchIDs = std::move(patches);
}


//- Sets the cells and points of the far field of a piece. Returns the labels in
//  the piece of the points that came.
static labelList setFarCells(const sentFarField& far, meshPiece& piece)
{
    const label nOnLayers = far.roots.size();
    const label nColumns = piece.columns.size();
    const label nOwn = far.points.size() - nOnLayers;
    piece.farCells = far.cells;
    piece.far.nCells = far.cells.size();
    piece.farPoints = SubList<label>(far.points, nOwn, nOnLayers);
    piece.far.points.setSize(nColumns + nOwn, Zero);

    labelList labels(far.points.size());
    placeInList place(piece.columns);
    forAll(labels, i)
    {
        labels[i] = i < nOnLayers
          ? place(far.points[i]) : nColumns + i - nOnLayers;
        piece.far.points[labels[i]] = far.coordinates[i];
    }

    return labels;
}


//- Sets starts of patches, and zones of the far field of a piece.
//  place: returns the label in the piece of a stack
static void setPatchesAndZones
(
    const sentFarField& far,
    placeInList& place,
    meshPiece& piece
)
{
    polyMeshTopology& mesh = piece.far.topology;
    label start = mesh.neighbour.size();
    for (const label size : mesh.patchSizes)
    {
        mesh.patchStarts.append(start);
        start += size;
    }
    forAll(far.zoneCells, i)
    {
        cellZoneParts& zone = piece.far.cellZones[i];
        zone.cells = far.zoneCells[i];
        zone.frontFaces = far.zoneStacks[i];
        for (label& stack : zone.frontFaces)
        {
            stack = place(stack);
        }
    }
}


//- Sets the far field of a piece, and its faces to other processes there.
//  stacks: labels of the stacks in the piece
static void setFarField
(
    const labelUList& stacks,
    const sentFarField& far,
    meshPiece& piece,
    DynamicList<faceBetween>& between
)
{
    const label n = piece.layers.nLayers;
    const labelList points(setFarCells(far, piece));
    polyMeshTopology& mesh = piece.far.topology;
    placeInList place(stacks);
    DynamicList<label> fronts;
    label at = 0;
    piece.farFaces.setSize(far.faces.size());

    forAll(far.faces, facei)
    {
        const farFaceRecord& record = far.faces[facei];
        face f(SubList<label>(far.corners, record.nCorners, at));
        inplaceRenumber(points, f);
        at += record.nCorners;
        mesh.faces.append(std::move(f));
        mesh.owner.append(record.owner);
        piece.farFaces[facei] = record.address;

        if (record.patch == -1)
        {
            mesh.neighbour.append(record.beyond);
        }
        else if (record.patch >= 0)
        {
            ++mesh.patchSizes[record.patch];
        }
        else
        {
            const label owner = record.owner < 0
              ? cellLabel(piece.layers, place(-1 - record.owner), n)
              : stacks.size()*n + record.owner;
            const meshFace onFar{prismFaceKey{-1, -1, 0}, facei, false};
            between.append
            (
                faceBetween{record.beyond, record.address, owner, onFar}
            );
        }
        if (record.patch == 0)
        {
            fronts.append(place(record.beyond));
        }
    }
    piece.far.frontFaces = std::move(fronts);
    setPatchesAndZones(far, place, piece);
}


void assemblePiece
(
    const List<message>& messages,
    const sentFarField& far,
    meshPiece& piece
)
{
    const labelList stacks(receiveStacks(messages, piece));
    DynamicList<faceBetween> between;
    setColumns(far, piece);
    setStacks(piece, between);
    setFarField(stacks, far, piece, between);

    std::sort
    (
        between.begin(), between.end(),
        [](const faceBetween& a, const faceBetween& b)
        {
            return std::make_tuple(a.process, mag(a.address))
                 < std::make_tuple(b.process, mag(b.address));
        }
    );
    piece.between = std::move(between);
}

} // End namespace Foam

// ************************************************************************* //
