/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "wallClearance.H"

#include <queue>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Radius of the ball that touches p, is centred on p + s*d, and passes
//  through q
static scalar touchingRadius(const point& p, const vector& d, const point& q)
{
    const vector pq = q - p;

    return magSqr(pq)/max(2*(d & pq), VSMALL);
}


static scalar shrunkenBall
(
    const wallSearch& search,
    const point& p,
    const vector& d,
    const scalar reach
)
{
    scalar radius = reach;

    // Each round takes the deepest point inside the ball; two or three do
    for (label round = 0; round < 20; ++round)
    {
        const pointIndexHit hit
        (
            search.nearestOpposite(p + radius*d, radius, d)
        );

        if (!hit.hit() || (d & (hit.rawPoint() - p)) <= 0)
        {
            break;
        }

        const scalar smaller = touchingRadius(p, d, hit.rawPoint());

        if (smaller >= (1 - 1e-6)*radius)
        {
            break;
        }

        radius = smaller;
    }

    return radius;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::scalarField Foam::makeWallClearance
(
    const wallSurface& wall,
    const wallSearch& search,
    const wallVisibility& visibility,
    const scalarField& reach
)
{
    scalarField clearance(wall.points.size());

    forAll(clearance, p)
    {
        clearance[p] = shrunkenBall
        (
            search,
            wall.points[p],
            visibility.cones[p].axis,
            reach[p]
        );
    }

    return clearance;
}


Foam::labelList Foam::limitGradient
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const scalar slope,
    scalarField& values
)
{
    // Dijkstra: a value is final when it is the lowest of those left
    typedef std::pair<scalar, label> entry;
    std::priority_queue<entry, std::vector<entry>, std::greater<entry>> front;

    auto bound = [&](const label from, const label to)
    {
        return values[from] + slope*mag(wall.points[to] - wall.points[from]);
    };

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


// ************************************************************************* //
