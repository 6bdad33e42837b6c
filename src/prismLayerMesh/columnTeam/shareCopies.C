/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "frontShare.H"
#include "HashSet.H"
#include "ListOps.H"
#include "Map.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- By point of the wall in the share, the processes other than this one that
//  own a point with which it shares a face
static Map<labelHashSet> othersBeside
(
    const layerFront& front,
    const labelUList& owners,
    const label process
)
{
    Map<labelHashSet> others;
    for (const face& f : front.surface.faces)
    {
        const labelList points(front.pointsUnder(f));
        for (const label p : points)
        {
            if (owners[p] != process)
            {
                for (const label q : points)
                {
                    others(q).insert(owners[p]);
                }
            }
        }
    }

    return others;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void frontShare::setCopies
(
    const labelUList& owners,
    const label nProcesses,
    const label process
)
{
    const Map<labelHashSet> beside(othersBeside(front, owners, process));
    Map<labelHashSet> near;

    for (const face& f : front.surface.faces)
    {
        const labelList points(front.pointsUnder(f));
        for (const label p : points)
        {
            if (beside.found(p))
            {
                for (const label q : points)
                {
                    near(q) |= beside[p];
                }
            }
        }
    }

    List<DynamicList<label>> toOthers(nProcesses);
    List<DynamicList<label>> fromOthers(nProcesses);
    forAll(front.wallPoints, c)
    {
        const label p = front.wallPoints[c];
        if (!columns.isOwn[c])
        {
            fromOthers[owners[p]].append(c);
        }
        else if (near.found(p))
        {
            for (const label other : near[p])
            {
                toOthers[other].append(c);
            }
        }
    }

    columns.sent.setSize(nProcesses);
    columns.received.setSize(nProcesses);
    forAll(columns.sent, p)
    {
        columns.sent[p] = std::move(toOthers[p]);
        columns.received[p] = std::move(fromOthers[p]);
    }

    // The label of a point is the label of its first column
    const label nPoints = points.whole.size();
    points.sent = columns.sent;
    points.received = columns.received;
    forAll(points.sent, p)
    {
        for (labelList* copies : {&points.sent[p], &points.received[p]})
        {
            inplaceSubsetList
            (
                *copies, [=](const label c) { return c < nPoints; }
            );
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
