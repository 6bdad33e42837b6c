/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellCorners.H"
#include "tetSigns.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool cellCorners::closes(const faceCorner* c, const label n)
{
    for (label i = 0; i < n; ++i)
    {
        label nBeside = 0;

        for (label j = 0; j < n; ++j)
        {
            nBeside += c[j].prev == c[i].next;
        }

        if (nBeside != 1)
        {
            return false;
        }
    }

    return n > 1;
}


bool cellCorners::isPositiveAt
(
    const tetSigns& positive,
    const faceCorner* c
) const
{
    const label third = c[1].prev == c->next ? c[1].next : c[2].next;

    return positive(x_[c->at], x_[c->prev], x_[c->next], x_[third]);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void cellCorners::set(const labelUList& labels, const labelUList& starts)
{
    corners_.clear();
    points_.clear();

    for (label i = 0; i + 1 < starts.size(); ++i)
    {
        const label end = starts[i + 1];

        for (label k = starts[i]; k < end; ++k)
        {
            const label next = k + 1 < end ? k + 1 : starts[i];
            const label prev = k > starts[i] ? k - 1 : end - 1;
            corners_.append(faceCorner{labels[k], labels[next], labels[prev]});
        }
    }

    std::sort
    (
        corners_.begin(), corners_.end(),
        [](const faceCorner& a, const faceCorner& b) { return a.at < b.at; }
    );

    for (const faceCorner& c : corners_)
    {
        points_.append(&x_[c.at]);
    }
}


cellCorners::factsOfAll cellCorners::facts() const
{
    factsOfAll all;
    if (corners_.empty())
    {
        all.closed = false;
        return all;
    }
    const tetSigns positive(points_.begin(), points_.size());

    for (label i = 0, n = 0; i < corners_.size(); i += n, ++all.nPoints)
    {
        const faceCorner* c = &corners_[i];
        for (n = 1; i + n < corners_.size() && c[n].at == c->at; ++n)
        {}

        all.closed = all.closed && closes(c, n);
        all.simple = all.simple && n == 3;
        all.within = all.within || n == 2;
        all.positive = all.positive && all.closed && n > 2
         && (n > 3 || isPositiveAt(positive, c));
    }

    return all;
}


boundBox cellCorners::bounds() const
{
    boundBox bounds(boundBox::invertedBox);
    for (const point* p : points_)
    {
        bounds.add(*p);
    }

    return bounds;
}

} // End namespace Foam

// ************************************************************************* //
