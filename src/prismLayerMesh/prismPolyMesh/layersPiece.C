/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layersPiece.H"
#include "bitSet.H"
#include "findFaceNeighbours.H"
#include "SubField.H"

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

} // End namespace Foam

// ************************************************************************* //
