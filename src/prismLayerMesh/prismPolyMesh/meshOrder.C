/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshOrder.H"
#include "bitSet.H"
#include "prismFaces.H"
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
    // A closed front of triangles has 2.5 faces for each cell
    const label perBlock = kind == faceKind::stacks
      ? max(label(1), label(meshBlocks::blockSize/(2.5*layers_.nLayers)))
      : meshBlocks::blockSize;

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


void meshOrder::setRanges(const UList<labelPair>& patchParts)
{
    const polyMeshTopology& far = far_.topology;
    addRanges(faceKind::stacks, -1, labelRange(0, layers_.faces.size()));
    addRanges(faceKind::farField, -1, labelRange(0, far.neighbour.size()));

    for (const labelPair& parts : patchParts)
    {
        patchBlocks_.append(ranges_.size());
        const label onLayers = parts.first();
        const label onFar = parts.second();
        if (onLayers >= 0)
        {
            addRanges
            (
                faceKind::layerPatch, onLayers,
                labelRange(0, boundary_[onLayers].size())
            );
        }
        if (onFar >= 0)
        {
            addRanges
            (
                faceKind::farField, -1,
                labelRange(far.patchStarts[onFar], far.patchSizes[onFar])
            );
        }
    }
    patchBlocks_.append(ranges_.size());
    addRanges(faceKind::between, -1, labelRange(0, between_.size()));

    if (ranges_.empty())
    {
        ranges_.append(faceRange{faceKind::stacks, -1, labelRange(0, 0)});
    }
}


void meshOrder::setNewPoints()
{
    bitSet columns(layers_.nColumns());
    for (const face& f : layers_.faces)
    {
        columns.set(f);
    }

    // Other columns are there for their points on the wall or the far field
    bitSet isUsed(nAllPoints() - layers_.extraColumnPoints.size());
    for (const label c : columns)
    {
        for (label i = 0; i <= layers_.nLayers; ++i)
        {
            isUsed.set(layers_.pointLabel(c, i));
        }
    }
    for (const face& f : far_.topology.faces)
    {
        for (const label p : f)
        {
            isUsed.set(farPoint(p));
        }
    }

    if (!isUsed.all())
    {
        newPoints_ = invert(isUsed);
    }
    blocks_.nPoints = isUsed.count();
}


void meshOrder::setBlocks()
{
    blocks_.nCells = layers_.faces.size()*layers_.nLayers + far_.nCells;
    blocks_.nPointBlocks = max
    (
        label(1), numberOfBlocks(nAllPoints(), meshBlocks::blockSize)
    );
    blocks_.points = [this](const label i) { return points(i); };
    blocks_.nFaceBlocks = ranges_.size();
    blocks_.faces = [this](const label i) { return faces(i); };
    blocks_.count();
}


label meshOrder::nAllPoints() const
{
    return layers_.points.size()
      + max(label(0), far_.points.size() - layers_.nColumns());
}


label meshOrder::farPoint(const label p) const
{
    const label n = layers_.nColumns();

    return p < n
      ? layers_.pointLabel(p, layers_.nLayers)
      : p + layers_.points.size() - layers_.extraColumnPoints.size() - n;
}


void meshOrder::appendPoints
(
    const meshFace& f,
    DynamicList<label>& points
) const
{
    if (f.farFace >= 0)
    {
        const face& corners = far_.topology.faces[f.farFace];
        const label n = corners.size();
        for (label k = 0; k < n; ++k)
        {
            points.append(farPoint(corners[f.isTurned ? (n - k) % n : k]));
        }
    }
    else if (f.isTurned)
    {
        // The face is of the stack with the lower label
        const edge e(layers_.faces[f.key.front].faceEdge(f.key.edge));
        points.append
        (
            sideFace(layers_, e.reverseEdge(), f.key.level).reverseFace()
        );
    }
    else
    {
        appendFace(layers_, f.key, points);
    }
}


template<class Visit>
void meshOrder::visitStack(const label fronti, const Visit& visit) const
{
    visitInternalFaces
    (
        layers_.nLayers, faceNeighbours_[fronti], fronti,
        [&](const label k, const label i, const label other)
        {
            const label celli = cellLabel(layers_, fronti, i);
            visit
            (
                meshFace{prismFaceKey{fronti, k, i}}, celli,
                k < 0 ? celli + 1 : cellLabel(layers_, other, i)
            );
        }
    );

    // Cells of the far field on the last cell, with their faces
    const auto onFront = std::equal_range
    (
        far_.frontFaces.begin(), far_.frontFaces.end(), fronti
    );
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
        visit
        (
            meshFace{prismFaceKey{-1, -1, 0}, b.second(), true},
            cellLabel(layers_, fronti, layers_.nLayers), firstFar + b.first()
        );
    }
}


template<class Visit>
void meshOrder::visitRange(const faceRange& range, const Visit& visit) const
{
    const label firstFar = layers_.faces.size()*layers_.nLayers;
    const polyMeshTopology& far = far_.topology;

    for (const label i : range.items)
    {
        if (range.kind == faceKind::stacks)
        {
            visitStack(i, visit);
        }
        else if (range.kind == faceKind::layerPatch)
        {
            const prismFaceKey& key = boundary_[range.patch][i];
            visit
            (
                meshFace{key},
                cellLabel(layers_, key.front, max(key.level, label(1))), -1
            );
        }
        else if (range.kind == faceKind::farField)
        {
            visit
            (
                meshFace{prismFaceKey{-1, -1, 0}, i, false},
                firstFar + far.owner[i],
                i < far.neighbour.size() ? firstFar + far.neighbour[i] : -1
            );
        }
        else
        {
            visit(between_[i].face, between_[i].owner, -1);
        }
    }
}


faceBlock meshOrder::faces(const label blocki) const
{
    faceBlock block;
    visitRange
    (
        ranges_[blocki],
        [&](const meshFace& f, const label owner, const label neighbour)
        {
            appendPoints(f, block.points);
            block.endFace(owner, neighbour);
        }
    );
    if (newPoints_.size())
    {
        inplaceRenumber(newPoints_, block.points);
    }

    return block;
}


pointField meshOrder::points(const label blocki) const
{
    const label n = layers_.nLayers + 1;
    const label nLayers = layers_.points.size();
    const auto isUsed = [&](const label p)
    {
        return newPoints_.empty() || newPoints_[p] >= 0;
    };
    DynamicList<point> points(meshBlocks::blockSize);

    const labelRange range
    (
        rangeOfBlock(nAllPoints(), meshBlocks::blockSize, blocki)
    );
    for (const label i : range)
    {
        if (i >= nLayers)
        {
            const label p = layers_.nColumns() + i - nLayers;
            if (isUsed(farPoint(p)))
            {
                points.append(far_.points[p]);
            }
        }
        else if
        (
            (i % n || i/n < layers_.nWallPoints())
         && isUsed(layers_.pointLabel(i/n, i % n))
        )
        {
            points.append(layers_.points[i]);
        }
    }

    return pointField(std::move(points));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

meshOrder::meshOrder
(
    const prismLayers& layers,
    const farFieldMesh& far,
    labelListList&& faceNeighbours,
    const UList<DynamicList<labelPair>>& open,
    const UList<labelPair>& patchParts
)
:
    layers_(layers),
    far_(far),
    faceNeighbours_(std::move(faceNeighbours)),
    boundary_(boundaryFaces(layers, open))
{
    setRanges(patchParts);
    blocks_.nPoints = nAllPoints() - layers.extraColumnPoints.size();
    setBlocks();
}


meshOrder::meshOrder(const meshPiece& piece)
:
    layers_(piece.layers),
    far_(piece.far),
    faceNeighbours_(findFaceNeighbours(piece.layers)),
    boundary_(boundaryFaces(piece.layers, piece.open)),
    between_(piece.between)
{
    setRanges(piece.patchParts);
    setNewPoints();
    setBlocks();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelList meshOrder::patchStarts() const
{
    return labelList(UIndirectList<label>(blocks_.firstFaces, patchBlocks_));
}


List<labelPair> meshOrder::facesToProcesses() const
{
    DynamicList<labelPair> processes;
    for (const faceBetween& f : between_)
    {
        if (processes.empty() || processes.last().first() != f.process)
        {
            processes.append(labelPair(f.process, 0));
        }
        ++processes.last().second();
    }

    return List<labelPair>(std::move(processes));
}


labelList meshOrder::farFaceLabels() const
{
    labelList labels(far_.topology.faces.size());
    label facei = 0;
    for (const faceRange& range : ranges_)
    {
        visitRange
        (
            range,
            [&](const meshFace& f, label, label)
            {
                if (f.farFace >= 0)
                {
                    labels[f.farFace] = facei;
                }
                ++facei;
            }
        );
    }

    return labels;
}


labelList meshOrder::faceAddressing(const meshPiece& piece) const
{
    DynamicList<label> addressing(blocks_.nFaces());
    for (const faceRange& range : ranges_)
    {
        visitRange
        (
            range,
            [&](const meshFace& f, label, label)
            {
                addressing.append(piece.faceAddress(f));
            }
        );
    }

    return labelList(std::move(addressing));
}


labelList meshOrder::pointAddressing(const meshPiece& piece) const
{
    labelList addressing(piece.pointAddressing());
    if (newPoints_.size())
    {
        inplaceReorder(newPoints_, addressing, true);
    }

    return addressing;
}

} // End namespace Foam

// ************************************************************************* //
