/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "limitGradient.H"
#include "HashSet.H"

#include <queue>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Lower values to bound(from, to) of their neighbours, from some points on.
//  get(p) is the value of a point, set(p, value) lowers it.
template<class Bound, class Get, class Set>
static void lowerFrom
(
    const labelUList& points,
    const wallAddressing& addressing,
    const Bound& bound,
    const Get& get,
    const Set& set
)
{
    // Dijkstra: a value is final when it is the lowest of those left
    typedef std::pair<scalar, label> entry;
    std::priority_queue<entry, std::vector<entry>, std::greater<entry>> front;

    for (const label p : points)
    {
        front.push(entry(get(p), p));
    }

    while (!front.empty())
    {
        const entry lowest = front.top();
        front.pop();
        const label from = lowest.second;

        if (lowest.first > get(from))
        {
            continue;
        }

        for (const label to : addressing.pointPoints[from])
        {
            const scalar limit = bound(from, to);

            if (limit < get(to))
            {
                set(to, limit);
                front.push(entry(limit, to));
            }
        }
    }
}


//- Lowers the neighbours of all points that are too low for a neighbour, and
//  then their neighbours, and so on
template<class Bound>
static labelList lowerAll
(
    const wallAddressing& addressing,
    const Bound& bound,
    scalarField& values
)
{
    labelHashSet low;

    for (const edge& e : addressing.edges)
    {
        const label from = values[e.start()] < values[e.end()]
          ? e.start() : e.end();
        const label to = e.otherVertex(from);

        if (bound(from, to) < values[to])
        {
            low.insert(from);
        }
    }

    labelHashSet lowered;
    lowerFrom
    (
        low.toc(), addressing, bound,
        [&](const label p) { return values[p]; },
        [&](const label p, const scalar value)
        {
            values[p] = value;
            lowered.insert(p);
        }
    );

    return lowered.sortedToc();
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList limitGradient
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const scalar slope,
    scalarField& values
)
{
    const pointField& points = wall.points;

    return lowerAll
    (
        addressing,
        [&](const label from, const label to)
        {
            return values[from] + slope*mag(points[to] - points[from]);
        },
        values
    );
}


void followGradient
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const scalar slope,
    const scalarField& values,
    Map<scalar>& lowered
)
{
    const pointField& points = wall.points;
    const auto get = [&](const label p)
    {
        return lowered.lookup(p, values[p]);
    };

    lowerFrom
    (
        lowered.sortedToc(), addressing,
        [&](const label from, const label to)
        {
            return get(from) + slope*mag(points[to] - points[from]);
        },
        get,
        [&](const label p, const scalar value) { lowered.set(p, value); }
    );
}


labelList limitRatio
(
    const wallAddressing& addressing,
    const scalar ratio,
    scalarField& values
)
{
    return lowerAll
    (
        addressing,
        [&](const label from, const label) { return ratio*values[from]; },
        values
    );
}

} // End namespace Foam

// ************************************************************************* //
