/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layersPiece.H"
#include "bitSet.H"
#include "findFaceNeighbours.H"
#include "readWallSurface.H"
#include "SubField.H"

#include <tuple>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The columns of stacks, and those with their points of the wall
static labelList columnsWithRoots
(
    const prismLayers& layers,
    const labelUList& stacks
)
{
    bitSet columns(layers.nColumns());
    for (const label c : layers.columnsOf(stacks))
    {
        columns.set(c);
        columns.set(layers.root(c));
    }

    return columns.toc();
}


//- The layers of some stacks, without a border. Points are not set.
static prismLayers layersOf
(
    const prismLayers& layers,
    const labelUList& stacks,
    const labelUList& columns
)
{
    labelList newColumns(layers.nColumns(), -1);
    prismLayers result;
    result.nLayers = layers.nLayers;
    result.points.setSize(columns.size()*(layers.nLayers + 1));
    DynamicList<label> roots, patchIDs(stacks.size());

    forAll(columns, c)
    {
        newColumns[columns[c]] = c;
        if (columns[c] >= layers.nWallPoints())
        {
            roots.append(newColumns[layers.root(columns[c])]);
        }
    }
    result.extraColumnPoints.transfer(roots);

    result.faces.setSize(stacks.size());
    forAll(stacks, i)
    {
        result.faces[i] = layers.faces[stacks[i]];
        inplaceRenumber(newColumns, result.faces[i]);
        if (stacks[i] < layers.nWallFaces())
        {
            patchIDs.append(layers.patchIDs[stacks[i]]);
        }
    }
    result.patchIDs.transfer(patchIDs);
    result.patchNames = layers.patchNames;

    return result;
}


//- Labels of the points of the piece in the whole mesh, see pointLabel()
static labelList pointAddressing(const layersPiece& piece)
{
    const prismLayers& layers = piece.layers;
    const label n = layers.nLayers;
    labelList addressing
    (
        layers.points.size() - layers.extraColumnPoints.size()
    );

    forAll(piece.columns, c)
    {
        const label whole = piece.columns[c];
        const label nSkipped = max(whole - piece.nWallPoints + 1, label(0));
        for (label i = nSkipped > 0; i <= n; ++i)
        {
            addressing[layers.pointLabel(c, i)] =
                whole*(n + 1) + i - nSkipped;
        }
    }

    return addressing;
}


//- Labels of the faces of the topology in the whole mesh, plus 1
static DynamicList<label> faceAddressing
(
    const layersPiece& piece,
    const labelListList& faceNeighbours,
    const label nFaces
)
{
    const prismLayers& layers = piece.layers;
    DynamicList<label> addressing(nFaces);

    forAll(faceNeighbours, facei)
    {
        visitInternalFaces
        (
            layers.nLayers, faceNeighbours[facei], facei,
            [&](const label k, const label i, const label)
            {
                addressing.append(piece.labels(facei, k, i) + 1);
            }
        );
    }
    for (const auto& patch : boundaryFaces(layers, piece.open))
    {
        for (const prismFaceKey& f : patch)
        {
            addressing.append(piece.labels(f.front, f.edge, f.level) + 1);
        }
    }

    return addressing;
}


//- A side face to another process: the process, the label in the whole mesh,
//  front face, edge, layer
typedef std::tuple<label, label, label, label, label> faceBetween;


//- The faces to other processes, one process after the other, each in the order
//  of the whole mesh
static DynamicList<faceBetween> facesBetween
(
    const layersPiece& piece,
    const label processor
)
{
    DynamicList<faceBetween> faces;

    forAll(piece.processors, facei)
    {
        forAll(piece.processors[facei], k)
        {
            const label other = piece.processors[facei][k];
            if (other < 0 || other == processor)
            {
                continue;
            }
            for (label i = 1; i <= piece.layers.nLayers; ++i)
            {
                const label whole = piece.labels(facei, k, i);
                faces.append(faceBetween(other, whole, facei, k, i));
            }
        }
    }
    std::sort(faces.begin(), faces.end());

    return faces;
}


//- Append the faces to other processes
static void addBetween
(
    const layersPiece& piece,
    const label processor,
    polyMeshTopology& mesh,
    DynamicList<label>& addressing,
    meshPiece& result
)
{
    const prismLayers& layers = piece.layers;
    DynamicList<label> processors, sizes;

    for (const faceBetween& f : facesBetween(piece, processor))
    {
        const auto [other, whole, facei, k, i] = f;
        if (processors.empty() || processors.last() != other)
        {
            processors.append(other);
            sizes.append(0);
            mesh.startPatch();
        }
        ++sizes.last();

        // The face is of the stack with the lower label
        const edge e(layers.faces[facei].faceEdge(k));
        const bool turned =
            piece.faceNeighbours[facei][k] < piece.stacks[facei];
        mesh.append
        (
            turned
          ? sideFace(layers, e.reverseEdge(), i).reverseFace()
          : sideFace(layers, e, i),
            cellLabel(layers, facei, i)
        );
        addressing.append(turned ? -(whole + 1) : whole + 1);
    }
    result.processors.transfer(processors);
    result.processorSizes.transfer(sizes);
}


//- Drop the points that no face has
static void dropUnused(meshPiece& piece)
{
    const labelList newPoints(removeUnusedPoints(piece.faces, piece.points));
    const labelList used(invert(piece.points.size(), newPoints));
    piece.pointAddressing =
        labelList(UIndirectList<label>(piece.pointAddressing, used));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

layersDivider::layersDivider(const prismLayers& layers)
:
    layers_(layers),
    faceNeighbours_(findFaceNeighbours(layers)),
    open_(openEdges(layers, faceNeighbours_)),
    labels_(makePrismFaceLabels(layers, faceNeighbours_, open_)),
    patches_(patchesOfLayers(layers, open_.size()))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelListList layersDivider::neighbours() const
{
    labelListList beside(faceNeighbours_);
    for (labelList& stacks : beside)
    {
        inplaceSubsetList(stacks, [](const label other) { return other >= 0; });
    }

    return beside;
}


layersPiece layersDivider::piece
(
    const labelUList& processorOfStack,
    const label processor
) const
{
    layersPiece result;
    result.stacks = findIndices(processorOfStack, processor);
    result.columns = columnsWithRoots(layers_, result.stacks);
    result.layers = layersOf(layers_, result.stacks, result.columns);
    result.nWallPoints = layers_.nWallPoints();
    result.patchNames = patches_.names;
    result.patchTypes = patches_.types();
    result.labels = labels_.subset(result.stacks);
    result.faceNeighbours =
        labelListList(UIndirectList<labelList>(faceNeighbours_, result.stacks));
    result.processors = result.faceNeighbours;
    for (labelList& others : result.processors)
    {
        for (label& other : others)
        {
            other = other < 0 ? -1 : processorOfStack[other];
        }
    }

    const labelList newFaces(invert(layers_.faces.size(), result.stacks));
    result.open.setSize(open_.size());
    forAll(open_, i)
    {
        for (const labelPair& e : open_[i])
        {
            const label facei = newFaces[e.first()];
            if (facei >= 0)
            {
                result.open[i].append(labelPair(facei, e.second()));
            }
        }
    }

    return result;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

pointField centresOfStacks(const prismLayers& layers)
{
    pointField centres(layers.faces.size(), Zero);
    const label n = layers.nLayers + 1;

    forAll(centres, facei)
    {
        const face& f = layers.faces[facei];
        for (const label c : f)
        {
            centres[facei] += sum(SubField<point>(layers.points, n, c*n));
        }
        centres[facei] /= f.size()*n;
    }

    return centres;
}


meshPiece makeMeshPiece(const layersPiece& piece, const label processor)
{
    const prismLayers& layers = piece.layers;
    const labelListList faceNeighbours(findFaceNeighbours(layers));
    polyMeshTopology mesh
    (
        makePrismTopology(layers, faceNeighbours, piece.open)
    );
    DynamicList<label> addressing
    (
        faceAddressing(piece, faceNeighbours, mesh.faces.size())
    );

    meshPiece result;
    result.patchNames = piece.patchNames;
    result.patchTypes = piece.patchTypes;
    result.patchSizes = mesh.patchSizes;
    addBetween(piece, processor, mesh, addressing, result);

    result.points = layers.meshPoints();
    result.faces.transfer(mesh.faces);
    result.owner.transfer(mesh.owner);
    result.neighbour.transfer(mesh.neighbour);
    result.faceAddressing.transfer(addressing);
    result.pointAddressing = pointAddressing(piece);
    dropUnused(result);

    result.cellAddressing.setSize(layers.faces.size()*layers.nLayers);
    forAll(result.cellAddressing, celli)
    {
        result.cellAddressing[celli] =
            piece.stacks[celli/layers.nLayers]*layers.nLayers
          + celli % layers.nLayers;
    }

    return result;
}

} // End namespace Foam

// ************************************************************************* //
