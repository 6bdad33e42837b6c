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


meshCell::cornerFacts meshCell::facts() const
{
    const tetSigns positive(points_.begin(), points_.size());
    cornerFacts all;

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


bool meshCell::asBox(const label celli, bool& positive) const
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
        const label facei = mesh_.cellFaces(celli)[i];
        const scalar outwards =
            (side % 2 ? 1 : -1)*mesh_.outwardArea(facei, celli)[side/2];
        positive = positive && outwards > 0;
        area += outwards;
    }

    // A closed surface covers the box a whole number of times
    const scalar once = 2
       *(span.x()*span.y() + span.y()*span.z() + span.z()*span.x());
    positive = positive && area < 1.5*once;

    return true;
}


bool meshCell::hasPositivePyramids(const label celli) const
{
    const cell faces(mesh_.cellFaces(celli));
    const point centre(faces.centre(mesh_.points(), mesh_.faces()));

    return std::all_of
    (
        faces.begin(), faces.end(),
        [&](const label facei)
        {
            return mesh_.pyramidVolume(facei, celli, centre) > 0;
        }
    );
}


bool meshCell::isPositivePolyhedron(const label celli)
{
    set(celli);
    collectCorners();

    return !points_.empty() && facts().closed && hasPositivePyramids(celli);
}


meshCellVerdict meshCell::cornersVerdict(const label celli)
{
    collectCorners();
    if (points_.empty())
    {
        return {meshCellShape::other, false};
    }

    const cornerFacts corners(facts());
    if (!corners.closed)
    {
        return {meshCellShape::other, false};
    }

    // Only a cell with more points, or points within its edges, may be refined
    bool positiveBox = false;
    if (!corners.positive && (corners.within || corners.nPoints > 8))
    {
        return asBox(celli, positiveBox)
          ? meshCellVerdict{meshCellShape::box, positiveBox}
          : meshCellVerdict
            {
                meshCellShape::polyhedron, hasPositivePyramids(celli)
            };
    }

    const auto is = [&](const label nFacesOfShape, const label nPointsOfShape)
    {
        return corners.simple && nFaces() == nFacesOfShape
         && corners.nPoints == nPointsOfShape;
    };

    return
    {
        is(4, 4) && nTriangles_ == 4 ? meshCellShape::tetrahedron
      : is(6, 8) && nQuads_ == 6 ? meshCellShape::hexahedron
      : meshCellShape::other,
        corners.positive
    };
}

} // End namespace Foam

// ************************************************************************* //
