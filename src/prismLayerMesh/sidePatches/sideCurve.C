/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sideCurve.H"
#include "boundBox.H"
#include "sidePatch.H"
#include "linePointRef.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef std::pair<point, point> segment;

static DynamicList<segment> segmentsOf(const sidePatch& part)
{
    DynamicList<segment> segments;
    for (const edge& e : outline(part.faces))
    {
        segments.append
        (
            segment(part.points[e.start()], part.points[e.end()])
        );
    }

    return segments;
}


static DynamicList<segment> commonSegments
(
    const sidePatch& part,
    const sidePatch& other
)
{
    const scalar tolerance = 1e-9*boundBox(part.points, false).mag();
    const DynamicList<segment> others(segmentsOf(other));
    DynamicList<segment> common;

    for (const segment& s : segmentsOf(part))
    {
        if
        (
            other.isPart()
          ? others.found(segment(s.second, s.first))
          : other.hasEdge(s.first, s.second, tolerance)
        )
        {
            common.append(s);
        }
    }

    return common;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

sideCurve::foot sideCurve::footOf(const point& x) const
{
    foot best{points_[0], 0};
    scalar least = magSqr(x - points_[0]);
    scalar length = 0;

    for (label i = 1; i < points_.size(); ++i)
    {
        const linePointRef line(points_[i - 1], points_[i]);
        const point at(line.nearestDist(x).rawPoint());

        if (magSqr(x - at) < least)
        {
            least = magSqr(x - at);
            best = foot{at, length + mag(at - points_[i - 1])};
        }
        length += line.mag();
    }

    return best;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

sideCurve::sideCurve
(
    const sidePatch& first,
    const sidePatch& second,
    const point& from
)
{
    DynamicList<segment> segments
    (
        first.isPart()
      ? commonSegments(first, second) : commonSegments(second, first)
    );
    points_.append(from);

    for (label i = 0; i < segments.size(); ++i)
    {
        const point end(points_.last());
        const segment s(segments[i]);

        if (s.first == end || s.second == end)
        {
            points_.append(s.first == end ? s.second : s.first);
            segments.remove(i);
            i = -1;
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
