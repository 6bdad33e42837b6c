/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshBuilder.H"
#include "CompactListList.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const SubList<label> meshBuilder::pointsOf(const label facei) const
{
    const label start = facei ? ends_[facei - 1] : 0;

    return SubList<label>(points_, ends_[facei] - start, start);
}


void meshBuilder::append
(
    const labelUList& f,
    const label first,
    const label second
)
{
    const label start = points_.size();
    for (const label p : f)
    {
        if (points_.size() == start || points_.last() != p)
        {
            points_.append(p);
        }
    }
    if (points_.size() > start && points_.last() == points_[start])
    {
        points_.remove();
    }
    ends_.append(points_.size());
    cells_.append(labelPair(first, second));
    if (points_.size() < start + 3)
    {
        leaveOut(size() - 1);
    }
}


void meshBuilder::renumberPoints(const labelUList& newLabels)
{
    label n = 0;
    label start = 0;
    for (label& end : ends_)
    {
        for (label i = start; i < end; ++i)
        {
            points_[n] = newLabels[points_[i]];
            n += points_[n] >= 0;
        }
        start = end;
        end = n;
    }
    points_.setSize(n);
}


labelList meshBuilder::order(const label nCells, const label nPatches) const
{
    // Faces by their smaller cell, or behind these by their patch
    const auto bucketOf = [&](const label facei)
    {
        const labelPair& cells = cells_[facei];

        return isInternal(facei)
          ? min(cells.first(), cells.second())
          : nCells + patchOf(cells.second());
    };
    labelList n(nCells + nPatches, Zero);
    forAll(cells_, facei)
    {
        if (!isLeftOut(facei))
        {
            ++n[bucketOf(facei)];
        }
    }
    CompactListList<label> faces(n);
    forAllReverse(cells_, facei)
    {
        if (!isLeftOut(facei))
        {
            const label bucket = bucketOf(facei);
            faces(bucket, --n[bucket]) = facei;
        }
    }
    const auto key = [&](const label facei)
    {
        return labelPair
        (
            max(cells_[facei].first(), cells_[facei].second()), facei
        );
    };

    #pragma omp parallel for schedule(static)
    for (label celli = 0; celli < nCells; ++celli)
    {
        UList<label> ofCell(faces[celli]);
        std::sort
        (
            ofCell.begin(), ofCell.end(),
            [&](const label a, const label b) { return key(a) < key(b); }
        );
    }

    return faces.m();
}


polyMeshTopology meshBuilder::topology
(
    const labelUList& order,
    const label nPatches
) const
{
    polyMeshTopology made;
    made.patchSizes = labelList(nPatches, Zero);
    label nInternal = 0;
    for (const label facei : order)
    {
        ++(
            isInternal(facei) ? nInternal
          : made.patchSizes[patchOf(cells_[facei].second())]
        );
    }
    made.patchStarts.setSize(nPatches);
    label start = nInternal;
    forAll(made.patchSizes, patchi)
    {
        made.patchStarts[patchi] = start;
        start += made.patchSizes[patchi];
    }
    made.faces.setSize(order.size());
    made.owner.setSize(order.size());
    made.neighbour.setSize(nInternal);

    #pragma omp parallel for schedule(static)
    forAll(order, k)
    {
        const label facei = order[k];
        labelPair cells(cells_[facei]);
        face f(pointsOf(facei));
        if (isTurned(facei))
        {
            f.flip();
            cells.flip();
        }
        made.faces[k].transfer(f);
        made.owner[k] = cells.first();
        if (k < nInternal)
        {
            made.neighbour[k] = cells.second();
        }
    }

    return made;
}

} // End namespace Foam

// ************************************************************************* //
