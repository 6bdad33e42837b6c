/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerEditor.H"
#include "limitGradient.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void layerEditor::restore(const label c, const columnState& before)
{
    const label n = spacing_.nLayers;

    SubList<point>(layers_.points, n, layers_.index(c, 1)) = before.points;
    SubList<vector>(offsets_, n, c*n) = before.offsets;
    straightened_[c] = before.straightened;
    causes_[c] = before.cause;

    if (thickness_[c] != before.thickness)
    {
        thickness_[c] = before.thickness;
        updateHeights(c);
    }
}


void layerEditor::accept(const label c, const columnState& before)
{
    if (recording_)
    {
        before_.insert(c, before);
    }
    touch(c);
}


labelList layerEditor::lower
(
    const labelUList& columns,
    const scalar share,
    const scalar straightenShare
)
{
    for (const label c : columns)
    {
        if (!isFixed(c))
        {
            remember(c);
            thickness_[c] *= share;
            straightened_[c] += straightenShare*(1 - straightened_[c]);
        }
    }

    const Map<scalar> followers
    (
        limitGradientFrom
        (
            columns, front_.surface, front_.addressing,
            layerColumns::maxSlope, thickness_
        )
    );
    labelHashSet lowered(columns);

    forAllConstIters(followers, iter)
    {
        const label c = iter.key();

        if (isFixed(c))
        {
            thickness_[c] = iter.val();
        }
        else if (lowered.insert(c))
        {
            const scalar now = thickness_[c];
            thickness_[c] = iter.val();
            remember(c);
            thickness_[c] = now;
        }
    }

    const labelList changed(lowered.sortedToc());

    #pragma omp parallel for schedule(static, 64) if (changed.size() > 128)
    forAll(changed, i)
    {
        const label c = changed[i];
        setThickness(c, thickness_[c], straightened_[c]);
    }

    for (const label c : changed)
    {
        touch(c);
    }

    return changed;
}


void layerEditor::remember(const label c)
{
    if (recording_ && !before_.found(c))
    {
        before_.insert(c, state(c));
    }
}


void layerEditor::touch(const label c)
{
    journal_.append(front_.addressing.pointFaces[c]);
}


labelList layerEditor::touchedSince(const label then) const
{
    return bitSet
    (
        layers_.faces.size(),
        SubList<label>(journal_, journal_.size() - then, then)
    ).toc();
}


void layerEditor::record()
{
    recording_ = true;
    before_.clear();
}


void layerEditor::keep()
{
    before_.clear();
}


void layerEditor::rollBack(const label c)
{
    restore(c, before_[c]);
    before_.erase(c);
    touch(c);
}

} // End namespace Foam

// ************************************************************************* //
