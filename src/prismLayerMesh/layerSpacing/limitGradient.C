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

//- Lower values to bound(from, to) > values[from] of their neighbours, from
//  some points on. Returns the values that were lowered, as they were.
template<class Bound>
static Map<scalar> lowerFrom
(
    const labelUList& points,
    const wallAddressing& addressing,
    const Bound& bound,
    scalarField& values
)
{
    // Dijkstra: a value is final when it is the lowest of those left
    typedef std::pair<scalar, label> entry;
    std::priority_queue<entry, std::vector<entry>, std::greater<entry>> front;
    Map<scalar> before;

    for (const label p : points)
    {
        front.push(entry(values[p], p));
    }

    while (!front.empty())
    {
        const entry lowest = front.top();
        front.pop();
        const label from = lowest.second;

        if (lowest.first > values[from])
        {
            continue;
        }

        for (const label to : addressing.pointPoints[from])
        {
            const scalar limit = bound(from, to);

            if (limit < values[to])
            {
                before.insert(to, values[to]);
                values[to] = limit;
                front.push(entry(limit, to));
            }
        }
    }

    return before;
}


//- The same from all points that are too low for a neighbour
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

    return lowerFrom(low.toc(), addressing, bound, values).sortedToc();
}


//- The bound on the gradient
static auto gradientBound
(
    const pointField& points,
    const scalar slope,
    const scalarField& values
)
{
    return [&points, slope, &values](const label from, const label to)
    {
        return values[from] + slope*mag(points[to] - points[from]);
    };
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
    return lowerAll
    (
        addressing, gradientBound(wall.points, slope, values), values
    );
}


Map<scalar> limitGradientFrom
(
    const labelUList& points,
    const wallSurface& wall,
    const wallAddressing& addressing,
    const scalar slope,
    scalarField& values
)
{
    return lowerFrom
    (
        points, addressing, gradientBound(wall.points, slope, values), values
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
