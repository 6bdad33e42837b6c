/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshOrder.H"
#include "layerBlocks.H"
#include "prismPolyMesh.H"
#include "UIndirectList.H"

namespace Foam
{

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void meshOrder::addRanges
(
    const faceKind kind,
    const label patch,
    const labelRange& items
)
{
    const label perBlock = kind == faceKind::stacks
      ? stacksPerBlock(layers_.nLayers) : meshBlocks::blockSize;

    for (label i = 0; i < numberOfBlocks(items.size(), perBlock); ++i)
    {
        const labelRange range(rangeOfBlock(items.size(), perBlock, i));
        ranges_.append
        (
            faceRange
            {
                kind, patch,
                labelRange(items.start() + range.start(), range.size())
            }
        );
    }
}


void meshOrder::addLayerPatch(const label patchi)
{
    addRanges
    (
        faceKind::layerPatch, patchi, labelRange(0, boundary_[patchi].size())
    );
}


void meshOrder::addFarPatches()
{
    const label nWall = layers_.patchNames.size();
    const wordList sideNames(sidePatchNames(layers_.border));
    const polyMeshTopology& far = far_.topology;

    forAll(far_.patches.names, patchi)
    {
        patchBlocks_.append(ranges_.size());

        // The sides of layers follow the wall and the outer surface
        const label side = sideNames.find(far_.patches.names[patchi]);
        if (side >= 0)
        {
            addLayerPatch(nWall + 1 + side);
        }
        addRanges
        (
            faceKind::farField, -1,
            labelRange(far.patchStarts[1 + patchi], far.patchSizes[1 + patchi])
        );
    }
}


void meshOrder::addFarPoints
(
    const label facei,
    const bool flip,
    faceBlock& block
) const
{
    const label n = layers_.nColumns();
    const label shift =
        layers_.points.size() - layers_.extraColumnPoints.size() - n;
    const face& f = far_.topology.faces[facei];

    forAll(f, k)
    {
        const label p = f[flip ? (f.size() - k) % f.size() : k];
        block.points.append
        (
            p < n ? layers_.pointLabel(p, layers_.nLayers) : p + shift
        );
    }
}


void meshOrder::addStack(const label fronti, faceBlock& block) const
{
    appendStack(layers_, faceNeighbours_, fronti, block);
    addFacesToFar(fronti, block);
}


void meshOrder::addFacesToFar(const label fronti, faceBlock& block) const
{
    const auto onFront = std::equal_range
    (
        far_.frontFaces.begin(), far_.frontFaces.end(), fronti
    );

    // Cells of the far field on the last cell, with their faces
    DynamicList<labelPair> neighbours;
    for (auto iter = onFront.first; iter != onFront.second; ++iter)
    {
        const label facei =
            far_.topology.patchStarts[0] + (iter - far_.frontFaces.begin());
        neighbours.append(labelPair(far_.topology.owner[facei], facei));
    }
    std::sort(neighbours.begin(), neighbours.end());

    const label firstFar = layers_.faces.size()*layers_.nLayers;
    for (const labelPair& b : neighbours)
    {
        addFarPoints(b.second(), true, block);
        block.endFace
        (
            cellLabel(layers_, fronti, layers_.nLayers), firstFar + b.first()
        );
    }
}


void meshOrder::addFarFace(const label facei, faceBlock& block) const
{
    const label firstFar = layers_.faces.size()*layers_.nLayers;
    const polyMeshTopology& far = far_.topology;

    addFarPoints(facei, false, block);
    block.endFace
    (
        firstFar + far.owner[facei],
        facei < far.neighbour.size() ? firstFar + far.neighbour[facei] : -1
    );
}


faceBlock meshOrder::faces(const label blocki) const
{
    const faceRange& range = ranges_[blocki];
    faceBlock block;

    for (const label i : range.items)
    {
        if (range.kind == faceKind::stacks)
        {
            addStack(i, block);
        }
        else if (range.kind == faceKind::farField)
        {
            addFarFace(i, block);
        }
        else
        {
            appendPatchFace(layers_, boundary_[range.patch][i], block);
        }
    }

    return block;
}


pointField meshOrder::points(const label blocki) const
{
    const label n = layers_.nLayers + 1;
    const label nWall = layers_.nWallPoints()*n;
    const label nLayers = layers_.points.size();
    DynamicList<point> points(meshBlocks::blockSize);

    const labelRange range
    (
        rangeOfBlock(nAllPoints(), meshBlocks::blockSize, blocki)
    );
    for (const label i : range)
    {
        if (i >= nLayers)
        {
            points.append(far_.points[layers_.nColumns() + i - nLayers]);
        }
        else if (i < nWall || i % n)
        {
            points.append(layers_.points[i]);
        }
    }

    return pointField(std::move(points));
}


label meshOrder::nAllPoints() const
{
    return layers_.points.size()
      + (far_.empty() ? 0 : far_.points.size() - layers_.nColumns());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

meshOrder::meshOrder
(
    const prismLayers& layers,
    const farFieldMesh& far,
    labelListList&& faceNeighbours,
    const UList<DynamicList<labelPair>>& open
)
:
    layers_(layers),
    far_(far),
    faceNeighbours_(std::move(faceNeighbours)),
    boundary_(boundaryFaces(layers, open))
{
    const label nLayerPatches =
        far.empty() ? boundary_.size() : layers.patchNames.size();

    addRanges(faceKind::stacks, -1, labelRange(0, layers.faces.size()));
    addRanges
    (
        faceKind::farField, -1, labelRange(0, far.topology.neighbour.size())
    );
    for (label patchi = 0; patchi < nLayerPatches; ++patchi)
    {
        patchBlocks_.append(ranges_.size());
        addLayerPatch(patchi);
    }
    addFarPatches();

    blocks_.nCells = layers.faces.size()*layers.nLayers + far.nCells;
    blocks_.nPoints = nAllPoints() - layers.extraColumnPoints.size();
    blocks_.nPointBlocks = numberOfBlocks(nAllPoints(), meshBlocks::blockSize);
    blocks_.points = [this](const label i) { return points(i); };
    blocks_.nFaceBlocks = ranges_.size();
    blocks_.faces = [this](const label i) { return faces(i); };
    blocks_.count();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelList meshOrder::patchStarts() const
{
    labelList starts
    (
        UIndirectList<label>(blocks_.firstFaces, patchBlocks_)
    );
    starts.append(blocks_.nFaces());

    return starts;
}


labelList meshOrder::farFaceLabels() const
{
    labelList labels(far_.topology.faces.size(), -1);

    forAll(ranges_, i)
    {
        const faceRange& range = ranges_[i];
        if (range.kind == faceKind::farField)
        {
            for (const label facei : range.items)
            {
                labels[facei] =
                    blocks_.firstFaces[i] + facei - range.items.start();
            }
        }
    }

    return labels;
}

} // End namespace Foam

// ************************************************************************* //
