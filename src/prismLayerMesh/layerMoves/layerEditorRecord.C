/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerEditor.H"
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


labelList layerEditor::touchedSince(const label then) const
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
