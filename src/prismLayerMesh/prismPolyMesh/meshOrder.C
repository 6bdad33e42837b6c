/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshOrder.H"
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


labelList meshOrder::setRanges(const UList<labelPair>& patchParts)
{
    const polyMeshTopology& far = far_.topology;
    DynamicList<label> patchBlocks(patchParts.size() + 1);
    addRanges(faceKind::stacks, -1, labelRange(0, layers_.faces.size()));
    addRanges(faceKind::farField, -1, labelRange(0, far.neighbour.size()));

    for (const labelPair& parts : patchParts)
    {
        patchBlocks.append(ranges_.size());
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
    patchBlocks.append(ranges_.size());

    if (ranges_.empty())
    {
        ranges_.append(faceRange{faceKind::stacks, -1, labelRange(0, 0)});
    }

    return labelList(std::move(patchBlocks));
}


void meshOrder::setBlocks()
{
    mesh_.nCells = layers_.faces.size()*layers_.nLayers + far_.nCells;
    mesh_.nStackCells = mesh_.nCells - far_.nCells;
    mesh_.nLayers = layers_.nLayers;
    mesh_.nPoints = nAllPoints() - layers_.extraColumnPoints.size();
    mesh_.nPointBlocks = max
    (
        label(1), numberOfBlocks(nAllPoints(), meshBlocks::blockSize)
    );
    mesh_.points = [this](const label i) { return points(i); };
    mesh_.nFaceBlocks = ranges_.size();
    mesh_.faces = [this](const label i) { return faces(i); };
    mesh_.count();
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


labelList meshOrder::cellsOf(const cellZoneParts& zone) const
{
    const label n = layers_.nLayers;
    DynamicList<label> cells(zone.frontFaces.size()*n + zone.cells.size());
    for (const label fronti : zone.frontFaces)
    {
        for (label i = 1; i <= n; ++i)
        {
            cells.append(cellLabel(layers_, fronti, i));
        }
    }
    for (const label celli : zone.cells)
    {
        cells.append(mesh_.nStackCells + celli);
    }

    return labelList(std::move(cells));
}


void meshOrder::setZones()
{
    if (far_.empty())
    {
        return;
    }
    mesh_.cellZones.append
    (
        cellZoneParts(boundaryLayerName, identity(mesh_.nStackCells))
    );
    for (const cellZoneParts& zone : far_.cellZones)
    {
        mesh_.cellZones.append(cellZoneParts(zone.name, cellsOf(zone)));
    }

    const labelList newFaces
    (
        far_.faceZones.size() ? farFaceLabels() : labelList()
    );
    mesh_.faceZones = far_.faceZones;
    for (faceZoneParts& zone : mesh_.faceZones)
    {
        inplaceRenumber(newFaces, zone.faces);
    }
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
        else
        {
            visit
            (
                meshFace{prismFaceKey{-1, -1, 0}, i, false},
                firstFar + far.owner[i],
                i < far.neighbour.size() ? firstFar + far.neighbour[i] : -1
            );
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

    return block;
}


pointField meshOrder::points(const label blocki) const
{
    const label n = layers_.nLayers + 1;
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
        else if (i % n || i/n < layers_.nWallPoints())
        {
            points.append(layers_.points[i]);
        }
    }

    return pointField(std::move(points));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

meshOrder::meshOrder(const prismLayers& layers, farFieldMesh& far)
:
    layers_(layers),
    far_(far),
    faceNeighbours_(findFaceNeighbours(layers))
{
    const List<DynamicList<labelPair>> open(openEdges(layers, faceNeighbours_));
    boundary_ = boundaryFaces(layers, open);
    mesh_.patches = patchesOfMesh(layers, open.size(), far);
    const labelList patchBlocks
    (
        setRanges(partsOfPatches(layers, open.size(), far))
    );
    setBlocks();
    mesh_.patchStarts =
        labelUIndList(mesh_.firstFaces, patchBlocks)();
    setZones();
}

} // End namespace Foam

// ************************************************************************* //
