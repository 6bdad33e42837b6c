/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "limitGradient.H"

#include <queue>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Lower values to bound(from, to) > values[from] of their neighbours
template<class Bound>
static labelList lowerTo
(
    const wallAddressing& addressing,
    const Bound& bound,
    scalarField& values
)
{
    // Dijkstra: a value is final when it is the lowest of those left
    typedef std::pair<scalar, label> entry;
    std::priority_queue<entry, std::vector<entry>, std::greater<entry>> front;

    for (const edge& e : addressing.edges)
    {
        const label low = values[e.start()] < values[e.end()]
          ? e.start() : e.end();

        if (bound(low, e.otherVertex(low)) < values[e.otherVertex(low)])
        {
            front.push(entry(values[low], low));
        }
    }

    boolList lowered(values.size(), false);

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
            if (bound(from, to) < values[to])
            {
                values[to] = bound(from, to);
                lowered[to] = true;
                front.push(entry(values[to], to));
            }
        }
    }

    return findIndices(lowered, true);
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::labelList Foam::limitGradient
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const scalar slope,
    scalarField& values
)
{
    const pointField& points = wall.points;

    return lowerTo
    (
        addressing,
        [&](const label from, const label to)
        {
            return values[from] + slope*mag(points[to] - points[from]);
        },
        values
    );
}


Foam::labelList Foam::limitRatio
(
    const wallAddressing& addressing,
    const scalar ratio,
    scalarField& values
)
{
    return lowerTo
    (
        addressing,
        [&](const label from, const label) { return ratio*values[from]; },
        values
    );
}


// ************************************************************************* //
