/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layersDivider.H"
#include "bitSet.H"
#include "Map.H"
#include "placeInList.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A stack, and where its corners begin in a list of corners
struct receivedStack
{
    stackRecord record;
    label firstCorner;
};


//- What the messages have
struct receivedStacks
{
    DynamicList<receivedStack> stacks;
    DynamicList<stackCorner> corners;
    DynamicList<stackSide> sides;


    explicit receivedStacks(const List<message>& messages)
    {
        for (const message& m : messages)
        {
            messageReader reader(m);
            sides.append(reader.list<stackSide>());
            while (!reader.atEnd())
            {
                const stackRecord record(reader.value<stackRecord>());
                stacks.append(receivedStack{record, corners.size()});
                for (label k = 0; k < record.nCorners; ++k)
                {
                    corners.append(reader.value<stackCorner>());
                }
            }
        }
        std::sort
        (
            stacks.begin(), stacks.end(),
            [](const receivedStack& a, const receivedStack& b)
            {
                return a.record.stack < b.record.stack;
            }
        );
    }
};

} // End anonymous namespace


//- Sets the columns of a piece, and the points of the wall under further ones.
//  nColumns: of the whole front
static void setColumns
(
    const receivedStacks& received,
    const label nColumns,
    layersPiece& piece
)
{
    bitSet isIn(nColumns);
    Map<label> roots;
    for (const stackCorner& corner : received.corners)
    {
        isIn.set(corner.column);
        isIn.set(corner.root);
        if (corner.column != corner.root)
        {
            roots.set(corner.column, corner.root);
        }
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


//- Sets the front faces of a piece and their labels in the whole mesh
static void setStacks(const receivedStacks& received, layersPiece& piece)
{
    DynamicList<label> patches, wallFaces;
    const label n = received.stacks.size();
    prismFaceLabels& labels = piece.labels;
    piece.stacks.setSize(n);
    piece.layers.faces.setSize(n);
    labels.nLayers = piece.layers.nLayers;
    labels.firstFaces.setSize(n);
    labels.strides.setSize(n);
    labels.outerFaces.setSize(n);

    placeInList place(piece.columns);
    forAll(received.stacks, i)
    {
        const stackRecord& record = received.stacks[i].record;
        piece.stacks[i] = record.stack;
        labels.firstFaces[i] = record.firstFace;
        labels.strides[i] = record.stride;
        labels.outerFaces[i] = record.outerFace;
        if (record.patch >= 0)
        {
            patches.append(record.patch);
            wallFaces.append(record.wallFace);
        }

        face& f = piece.layers.faces[i];
        f.setSize(record.nCorners);
        forAll(f, k)
        {
            f[k] = place
            (
                received.corners[received.stacks[i].firstCorner + k].column
            );
        }
    }
    piece.layers.patchIDs = std::move(patches);
    labels.wallFaces = std::move(wallFaces);
}


//- Sets what is beyond the edges of the front faces, and the labels of sides
static void setEdges(const receivedStacks& received, layersPiece& piece)
{
    prismFaceLabels& labels = piece.labels;
    piece.faceNeighbours.setSize(piece.stacks.size());
    labels.firstSides.setSize(piece.stacks.size());
    labels.sideStrides.setSize(piece.stacks.size());

    forAll(piece.stacks, i)
    {
        const receivedStack& stack = received.stacks[i];
        const label n = stack.record.nCorners;
        piece.faceNeighbours[i].setSize(n);
        labels.firstSides[i].setSize(n);
        labels.sideStrides[i].setSize(n);
        for (label k = 0; k < n; ++k)
        {
            const stackCorner& edge = received.corners[stack.firstCorner + k];
            piece.faceNeighbours[i][k] = edge.neighbour;
            labels.firstSides[i][k] = edge.firstSide;
            labels.sideStrides[i][k] = edge.sideStride;
            if (edge.open >= 0)
            {
                piece.open[edge.open].append(labelPair(i, k));
            }
        }
    }
    placeInList place(piece.stacks);
    for (const stackSide& side : received.sides)
    {
        const label i = place(side.stack);
        labels.firstSides[i][side.k] = side.firstSide;
        labels.sideStrides[i][side.k] = side.sideStride;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

layersPiece layersDivider::assemble
(
    const List<message>& messages,
    const labelUList& processorOfStack
) const
{
    const receivedStacks received(messages);
    layersPiece piece;
    piece.layers.nLayers = layers_.nLayers;
    piece.layers.patchNames = layers_.patchNames;
    piece.nWallPoints = team_.points.nWhole(layers_.nWallPoints());
    piece.patchNames = patches_.names;
    piece.patchTypes = patches_.types();
    piece.open.setSize(open_.size());
    setColumns(received, team_.columns.nWhole(layers_.nColumns()), piece);
    setStacks(received, piece);
    setEdges(received, piece);

    piece.processors = piece.faceNeighbours;
    for (labelList& others : piece.processors)
    {
        for (label& other : others)
        {
            other = other < 0 ? -1 : processorOfStack[other];
        }
    }

    return piece;
}

} // End namespace Foam

// ************************************************************************* //
