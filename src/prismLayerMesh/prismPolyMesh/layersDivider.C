/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layersDivider.H"
#include "findFaceNeighbours.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The neighbours of counted front faces. The lists of other faces have zeros.
static labelListList neighboursOfCounted
(
    const prismLayers& layers,
    const columnTeam& team
)
{
    labelListList neighbours(findFaceNeighbours(layers));
    forAll(neighbours, facei)
    {
        if (!team.counts(layers.faces[facei]))
        {
            neighbours[facei] = 0;
        }
    }

    return neighbours;
}


//- Open edges, with as many lists as on the other processes. Collective
static List<DynamicList<labelPair>> openEdgesInTeam
(
    const prismLayers& layers,
    const labelListList& faceNeighbours,
    const columnTeam& team
)
{
    List<DynamicList<labelPair>> open(openEdges(layers, faceNeighbours));
    open.setSize
    (
        team.reduce(open.size(), [](label a, label b) { return max(a, b); })
    );

    return open;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void layersDivider::addStack
(
    const label facei,
    const labelUList& open,
    message& stacks
) const
{
    const face& f = layers_.faces[facei];
    const bool isOnWall = facei < layers_.nWallFaces();
    stacks.addValue
    (
        stackRecord
        {
            team_.wholeFace(facei),
            isOnWall ? layers_.patchIDs[facei] : -1,
            isOnWall ? labels_.wallFaces[facei] : -1,
            labels_.outerFaces[facei], labels_.firstFaces[facei],
            labels_.strides[facei], f.size()
        }
    );
    forAll(f, k)
    {
        const label other = faceNeighbours_[facei][k];
        stacks.addValue
        (
            stackCorner
            {
                team_.wholeColumn(f[k]), team_.wholeColumn(layers_.root(f[k])),
                other < 0 ? -1 : team_.wholeFace(other), open[k],
                labels_.firstSides[facei][k], labels_.sideStrides[facei][k]
            }
        );
    }
}


void layersDivider::addSides
(
    const label facei,
    const labelUList& processorOfStack,
    List<DynamicList<stackSide>>& sides
) const
{
    const face& f = layers_.faces[facei];
    forAll(f, k)
    {
        const label other = faceNeighbours_[facei][k];
        if (other > facei)
        {
            // The other runs along the edge the other way
            const label edge = layers_.faces[other].find(f.nextLabel(k));
            const label whole = team_.wholeFace(other);
            sides[processorOfStack[whole]].append
            (
                stackSide
                {
                    whole, edge, labels_.firstSides[other][edge],
                    labels_.sideStrides[other][edge]
                }
            );
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

layersDivider::layersDivider
(
    const prismLayers& layers,
    const columnTeam& team
)
:
    layers_(layers),
    team_(team),
    faceNeighbours_(neighboursOfCounted(layers, team)),
    open_(openEdgesInTeam(layers, faceNeighbours_, team)),
    labels_(makePrismFaceLabels(layers, faceNeighbours_, open_, team)),
    patches_(patchesOfLayers(layers, open_.size()))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelListList layersDivider::neighbours() const
{
    DynamicList<label> stacks, sizes, others;
    forAll(layers_.faces, facei)
    {
        if (team_.counts(layers_.faces[facei]))
        {
            const label n = others.size();
            for (const label other : faceNeighbours_[facei])
            {
                if (other >= 0)
                {
                    others.append(team_.wholeFace(other));
                }
            }
            stacks.append(team_.wholeFace(facei));
            sizes.append(others.size() - n);
        }
    }
    List<message> sent(team_.size());
    sent[0].addList(stacks);
    sent[0].addList(sizes);
    sent[0].addList(others);

    labelListList beside
    (
        team_.isMaster() ? team_.faces.nWhole(layers_.faces.size()) : 0
    );
    for (const message& m : team_.exchange(sent))
    {
        messageReader reader(m);
        if (!reader.atEnd())
        {
            const labelList received(reader.list<label>());
            const labelList nOthers(reader.list<label>());
            const labelList all(reader.list<label>());
            label start = 0;
            forAll(received, i)
            {
                beside[received[i]] = SubList<label>(all, nOthers[i], start);
                start += nOthers[i];
            }
        }
    }

    return beside;
}


List<message> layersDivider::stacksByProcess
(
    const labelUList& processorOfStack,
    const label nProcesses
) const
{
    labelListList openOf(layers_.faces.size());
    forAll(open_, i)
    {
        for (const labelPair& e : open_[i])
        {
            labelList& open = openOf[e.first()];
            open.setSize(layers_.faces[e.first()].size(), -1);
            open[e.second()] = i;
        }
    }

    List<message> stacks(nProcesses);
    List<DynamicList<stackSide>> sides(nProcesses);
    labelList nStacks(nProcesses, 0);
    forAll(layers_.faces, facei)
    {
        if (team_.counts(layers_.faces[facei]))
        {
            labelList& open = openOf[facei];
            open.setSize(layers_.faces[facei].size(), -1);
            const label to = processorOfStack[team_.wholeFace(facei)];
            addStack(facei, open, stacks[to]);
            addSides(facei, processorOfStack, sides);
        }
    }

    List<message> messages(nProcesses);
    forAll(messages, p)
    {
        messages[p].addList(sides[p]);
        messages[p].append(stacks[p]);
    }

    return messages;
}

} // End namespace Foam

// ************************************************************************* //
