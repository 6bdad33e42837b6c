/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshCell.H"
#include "cell.H"
#include "tetSigns.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void meshCell::collectCorners()
{
    corners_.clear();
    points_.clear();

    for (label i = 0; i < nFaces(); ++i)
    {
        const label n = nPoints(i);

        for (label k = 0; k < n; ++k)
        {
            corners_.append
            (
                faceCorner
                {
                    corner(i, k), corner(i, k + 1), corner(i, k + n - 1)
                }
            );
        }
    }

    std::sort
    (
        corners_.begin(), corners_.end(),
        [](const faceCorner& a, const faceCorner& b) { return a.at < b.at; }
    );

    for (const faceCorner& c : corners_)
    {
        points_.append(&mesh_.points()[c.at]);
    }
}


template<class Visit>
void meshCell::visitPoints(const Visit& visit) const
{
    for (label i = 0, n = 0; i < corners_.size(); i += n)
    {
        const faceCorner* c = &corners_[i];
        for (n = 1; i + n < corners_.size() && c[n].at == c->at; ++n)
        {}

        visit(c, n);
    }
}


bool meshCell::closes(const faceCorner* c, const label n)
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


bool meshCell::isClosed() const
{
    bool closed = corners_.size();
    visitPoints
    (
        [&](const faceCorner* c, const label n)
        {
            closed = closed && closes(c, n);
        }
    );

    return closed;
}


bool meshCell::isPositiveAt
(
    const tetSigns& positive,
    const faceCorner* c
) const
{
    const pointField& x = mesh_.points();
    const label third = c[1].prev == c->next ? c[1].next : c[2].next;

    return positive(x[c->at], x[c->prev], x[c->next], x[third]);
}


bool meshCell::hasPositiveCorners() const
{
    const tetSigns positive(points_.begin(), points_.size());
    bool allPositive = true;
    visitPoints
    (
        [&](const faceCorner* c, const label n)
        {
            allPositive =
                allPositive && n > 2 && (n > 3 || isPositiveAt(positive, c));
        }
    );

    return allPositive;
}


label meshCell::nPoints() const
{
    label number = 0;
    visitPoints([&](const faceCorner*, label) { ++number; });

    return number;
}


bool meshCell::isSimple() const
{
    bool simple = true;
    visitPoints
    (
        [&](const faceCorner*, const label n) { simple = simple && n == 3; }
    );

    return simple;
}


bool meshCell::mayBeRefined() const
{
    bool within = false;
    visitPoints
    (
        [&](const faceCorner*, const label n) { within = within || n == 2; }
    );

    return within || nPoints() > 8;
}


label meshCell::sideOf(const label i, const boundBox& bounds) const
{
    for (label side = 0; side < 6; ++side)
    {
        const scalar at = (side % 2 ? bounds.max() : bounds.min())[side/2];
        label n = 0;
        for (label k = 0; k < nPoints(i); ++k)
        {
            n += mesh_.points()[corner(i, k)][side/2] == at;
        }

        if (n == nPoints(i))
        {
            return side;
        }
    }

    return -1;
}


scalar meshCell::areaAlong(const label i, const direction axis) const
{
    const pointField& x = mesh_.points();
    const point& origin = x[corner(i, 0)];
    vector twice(Zero);
    for (label k = 1; k + 1 < nPoints(i); ++k)
    {
        twice += (x[corner(i, k)] - origin) ^ (x[corner(i, k + 1)] - origin);
    }

    return twice[axis];
}


bool meshCell::asBox(bool& positive) const
{
    boundBox bounds(boundBox::invertedBox);
    for (const point* p : points_)
    {
        bounds.add(*p);
    }

    const vector span(bounds.span());
    scalar area = 0;
    positive = cmptMin(span) > 0;

    for (label i = 0; i < nFaces(); ++i)
    {
        const label side = sideOf(i, bounds);
        if (side < 0)
        {
            return false;
        }
        const scalar outwards = (side % 2 ? 1 : -1)*areaAlong(i, side/2);
        positive = positive && outwards > 0;
        area += outwards;
    }

    // A closed surface covers the box a whole number of times
    const scalar once = 4
       *(span.x()*span.y() + span.y()*span.z() + span.z()*span.x());
    positive = positive && area < 1.5*once;

    return true;
}


bool meshCell::hasPositivePyramids(const label celli) const
{
    const cell c(mesh_.cellFaces(celli));
    const point centre(c.centre(mesh_.points(), mesh_.faces()));
    bool positive = true;

    for (const label facei : c)
    {
        const face& f = mesh_.faces()[facei];
        const scalar outwards = mesh_.owner(facei) == celli ? 1 : -1;
        const vector above(f.centre(mesh_.points()) - centre);
        positive = positive
         && outwards*(f.areaNormal(mesh_.points()) & above) > 0;
    }

    return positive;
}


meshCellVerdict meshCell::cornersVerdict(const label celli)
{
    collectCorners();
    if (!isClosed())
    {
        return {meshCellShape::other, false};
    }

    const bool positive = hasPositiveCorners();
    bool positiveBox = false;
    if (!positive && mayBeRefined())
    {
        return asBox(positiveBox)
          ? meshCellVerdict{meshCellShape::box, positiveBox}
          : meshCellVerdict
            {
                meshCellShape::polyhedron, hasPositivePyramids(celli)
            };
    }

    const auto is = [&](const label nFacesOfShape, const label nPointsOfShape)
    {
        return isSimple() && nFaces() == nFacesOfShape
         && nPoints() == nPointsOfShape;
    };

    return
    {
        is(4, 4) && nTriangles_ == 4 ? meshCellShape::tetrahedron
      : is(6, 8) && nQuads_ == 6 ? meshCellShape::hexahedron
      : meshCellShape::other,
        positive
    };
}

} // End namespace Foam

// ************************************************************************* //
