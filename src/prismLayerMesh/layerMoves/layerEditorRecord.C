/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerEditor.H"
#include "bitSet.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void layerEditor::restore(const label c, const columnState& before)
{
    const label n = spacing_.nLayers;

    SubList<point>(layers_.points, n, layers_.index(c, 1)) = before.points;
    causes_[c] = before.cause;

    if (thickness_[c] != before.thickness)
    {
        thickness_[c] = before.thickness;
        setHeights(c, heightsFor(c, before.thickness));
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


void layerEditor::publish(const labelUList& changed)
{
    if (team_.isAlone())
    {
        return;
    }

    const labelHashSet all(changed);
    List<message> toOthers(team_.size());
    forAll(toOthers, p)
    {
        const labelUList& sent = team_.columns.sent()[p];
        columnStates states;
        forAll(sent, i)
        {
            if (all.found(sent[i]))
            {
                states.append(i, state(sent[i]));
            }
        }
        states.addTo(toOthers[p]);
    }

    const List<message> fromOthers(team_.exchange(toOthers));
    forAll(fromOthers, p)
    {
        const columnStates states(fromOthers[p]);
        for (label i = 0; i < states.size(); ++i)
        {
            const label c = team_.columns.received()[p][states.place(i)];
            restore(c, states[i]);
            touch(c);
        }
    }
}


labelList layerEditor::inColours
(
    const labelUList& columns,
    const std::function<void()>& prepare,
    const columnChange& change
)
{
    List<DynamicList<label>> groups(nColours_);
    for (const label c : columns)
    {
        if (mayMove(c))
        {
            groups[colours_[c]].append(c);
        }
    }

    DynamicList<label> all;

    for (const labelUList& group : groups)
    {
        List<columnState> before(group.size());
        boolList changed(group.size(), false);
        prepare();

        #pragma omp parallel for schedule(dynamic, 4) if (group.size() > 8)
        forAll(group, i)
        {
            before[i] = state(group[i]);
            changed[i] = change(group[i], before[i]);
        }

        const label nBefore = all.size();
        forAll(group, i)
        {
            if (changed[i])
            {
                accept(group[i], before[i]);
                all.append(group[i]);
            }
        }
        publish(SubList<label>(all, all.size() - nBefore, nBefore));
    }

    sort(all);

    return labelList(std::move(all));
}


labelList layerEditor::allTouchedSince(const label then) const
{
    const SubList<label> since(journal_, journal_.size() - then, then);

    // In proportion to what has changed, unless that is much
    if (since.size() > layers_.faces.size()/16)
    {
        return bitSet(layers_.faces.size(), since).toc();
    }

    labelList faces(since);
    inplaceUniqueSort(faces);

    return faces;
}


labelList layerEditor::touchedSince(const label then) const
{
    return team_.withOwn(allTouchedSince(then), layers_.faces);
}


const stackBoxes& layerEditor::stackGroups()
{
    if (groups_)
    {
        groups_->update(touchedSince(grouped_));
    }
    else
    {
        groups_.reset(new stackBoxes(layers_));
    }
    grouped_ = now();

    return groups_();
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
