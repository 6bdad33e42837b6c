/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pieceOrder.H"
#include "bitSet.H"
#include "findFaceNeighbours.H"
#include "layerBlocks.H"

namespace Foam
{

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void pieceOrder::setNewPoints()
{
    const prismLayers& layers = piece_.layers;
    bitSet isUsed(layers.nColumns());
    for (const face& f : layers.faces)
    {
        isUsed.set(f);
    }
    if (label(isUsed.count()) == layers.nColumns())
    {
        return;
    }

    // Other columns are there for their points on the wall
    const label n = layers.nLayers + 1;
    newPoints_.setSize
    (
        layers.points.size() - layers.extraColumnPoints.size(), -1
    );
    label nPoints = 0;
    forAll(layers.points, i)
    {
        const label c = i/n;
        const bool isOwn = c < layers.nWallPoints() || i % n;
        if (isOwn && (i % n == 0 || isUsed.test(c)))
        {
            newPoints_[layers.pointLabel(c, i % n)] = nPoints++;
        }
    }
}


void pieceOrder::addRanges
(
    const faceKind kind,
    const label patch,
    const label nItems
)
{
    const label perBlock = kind == faceKind::stacks
      ? stacksPerBlock(piece_.layers.nLayers) : meshBlocks::blockSize;

    for (label i = 0; i < numberOfBlocks(nItems, perBlock); ++i)
    {
        ranges_.append({kind, patch, rangeOfBlock(nItems, perBlock, i)});
    }
}


void pieceOrder::setParts()
{
    const prismLayers& layers = piece_.layers;
    parts_.patchNames = piece_.patchNames;
    parts_.patchTypes = piece_.patchTypes;
    parts_.patchSizes.setSize(boundary_.size());
    forAll(boundary_, patchi)
    {
        parts_.patchSizes[patchi] = boundary_[patchi].size();
    }

    DynamicList<label> processors, sizes;
    for (const sideBetween& side : between_)
    {
        if (processors.empty() || processors.last() != side.processor)
        {
            processors.append(side.processor);
            sizes.append(0);
        }
        ++sizes.last();
    }
    parts_.processors = std::move(processors);
    parts_.processorSizes = std::move(sizes);

    parts_.cellAddressing.setSize(layers.faces.size()*layers.nLayers);
    forAll(parts_.cellAddressing, celli)
    {
        parts_.cellAddressing[celli] =
            piece_.stacks[celli/layers.nLayers]*layers.nLayers
          + celli % layers.nLayers;
    }
    parts_.pointAddressing = pointAddressing();
    parts_.faceAddressing = faceAddressing();
}


labelList pieceOrder::pointAddressing() const
{
    const prismLayers& layers = piece_.layers;
    const label n = layers.nLayers;
    labelList addressing
    (
        layers.points.size() - layers.extraColumnPoints.size(), -1
    );

    forAll(piece_.columns, c)
    {
        const label whole = piece_.columns[c];
        const label nSkipped = max(whole - piece_.nWallPoints + 1, label(0));
        for (label i = nSkipped > 0; i <= n; ++i)
        {
            addressing[layers.pointLabel(c, i)] = whole*(n + 1) + i - nSkipped;
        }
    }
    if (newPoints_.size())
    {
        inplaceReorder(newPoints_, addressing, true);
    }

    return addressing;
}


labelList pieceOrder::faceAddressing() const
{
    DynamicList<label> addressing;

    forAll(faceNeighbours_, facei)
    {
        visitInternalFaces
        (
            piece_.layers.nLayers, faceNeighbours_[facei], facei,
            [&](const label k, const label i, const label)
            {
                addressing.append(piece_.labels(facei, k, i) + 1);
            }
        );
    }
    for (const auto& patch : boundary_)
    {
        for (const prismFaceKey& f : patch)
        {
            addressing.append(piece_.labels(f.front, f.edge, f.level) + 1);
        }
    }
    for (const sideBetween& side : between_)
    {
        addressing.append(side.isTurned ? -(side.whole + 1) : side.whole + 1);
    }

    return labelList(std::move(addressing));
}


faceBlock pieceOrder::faces(const label blocki) const
{
    const prismLayers& layers = piece_.layers;
    const faceRange& range = ranges_[blocki];
    faceBlock block;

    for (const label i : range.items)
    {
        if (range.kind == faceKind::stacks)
        {
            appendStack(layers, faceNeighbours_, i, block);
        }
        else if (range.kind == faceKind::between)
        {
            appendSide(layers, between_[i], block);
        }
        else
        {
            appendPatchFace(layers, boundary_[range.patch][i], block);
        }
    }
    if (newPoints_.size())
    {
        inplaceRenumber(newPoints_, block.points);
    }

    return block;
}


pointField pieceOrder::points(const label blocki) const
{
    const prismLayers& layers = piece_.layers;
    const label n = layers.nLayers + 1;
    const label nPoints = layers.points.size();
    DynamicList<point> points(meshBlocks::blockSize);

    const labelRange range
    (
        rangeOfBlock(nPoints, meshBlocks::blockSize, blocki)
    );
    for (const label i : range)
    {
        const label c = i/n;
        const bool isOwn = c < layers.nWallPoints() || i % n;
        if
        (
            isOwn
         && (
                newPoints_.empty()
             || newPoints_[layers.pointLabel(c, i % n)] >= 0
            )
        )
        {
            points.append(layers.points[i]);
        }
    }

    return pointField(std::move(points));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

pieceOrder::pieceOrder(const layersPiece& piece, const label processor)
:
    piece_(piece),
    faceNeighbours_(findFaceNeighbours(piece.layers)),
    boundary_(boundaryFaces(piece.layers, piece.open)),
    between_(sidesBetween(piece, processor))
{
    setNewPoints();

    addRanges(faceKind::stacks, -1, piece.layers.faces.size());
    forAll(boundary_, patchi)
    {
        addRanges(faceKind::patch, patchi, boundary_[patchi].size());
    }
    addRanges(faceKind::between, -1, between_.size());
    if (ranges_.empty())
    {
        ranges_.append({faceKind::stacks, -1, labelRange(0, 0)});
    }
    setParts();

    blocks_.nCells = parts_.cellAddressing.size();
    blocks_.nPoints = parts_.pointAddressing.size();
    blocks_.nPointBlocks = max
    (
        label(1),
        numberOfBlocks(piece.layers.points.size(), meshBlocks::blockSize)
    );
    blocks_.points = [this](const label i) { return points(i); };
    blocks_.nFaceBlocks = ranges_.size();
    blocks_.faces = [this](const label i) { return faces(i); };
    blocks_.count();
}

} // End namespace Foam

// ************************************************************************* //
