/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "wallClearance.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Columns of offset envelopes are at most this much longer than high
static const scalar smallestCosine = 0.5;

//- Above this cosine a ball holds nearly all of the smaller ones
static const scalar nestedCosine = 0.95;

//- The smallest ball that is looked into, a share of the largest
static const scalar lowestShare = 1.0/32;


//- Height at which the ball of that radius, centred on the axis so that the
//  wall's faces at p touch it, passes through q: the smaller root s*c of
//  |p + s*d - q| = s*c. Negative where there is none.
static scalar touchingHeight
(
    const point& p,
    const vector& d,
    const scalar cosine,
    const point& q
)
{
    const vector pq = q - p;
    const scalar along = d & pq;
    const scalar discriminant =
        sqr(along) - (1 - sqr(cosine))*magSqr(pq);

    return along > 0 && discriminant >= 0
      ? cosine*magSqr(pq)/(along + ::sqrt(discriminant))
      : -1;
}


//- The largest ball of at most that height that no point is in
static scalar shrunkenBall
(
    const wallSearch& search,
    const point& p,
    const vector& d,
    const scalar cosine,
    const scalar largest
)
{
    scalar height = largest;

    // Each round takes the deepest point inside the ball; two or three do
    for (label round = 0; round < 20; ++round)
    {
        const pointIndexHit hit
        (
            search.nearestOpposite(p + height/cosine*d, height, d)
        );

        if (!hit.hit())
        {
            break;
        }

        const scalar lower =
            touchingHeight(p, d, cosine, hit.rawPoint());

        if (lower < 0 || lower >= (1 - 1e-6)*height)
        {
            break;
        }

        height = lower;
    }

    return height;
}


//- The height up to which no ball has a point in it
static scalar room
(
    const wallSearch& search,
    const point& p,
    const visibilityCone& cone,
    const scalar reach
)
{
    const scalar cosine = max(cone.cosine, smallestCosine);

    // Balls on a flat wall hold the smaller ones; at an edge they leave room
    // beside them
    scalar height = cosine < nestedCosine ? reach*lowestShare : reach;
    scalar free = 0;

    for (; height < (1 + SMALL)*reach; height *= 2)
    {
        free = shrunkenBall(search, p, cone.axis, cosine, height);

        if (free < height)
        {
            break;
        }
    }

    return free;
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

    #pragma omp parallel for schedule(dynamic, 64)
    for (label p = 0; p < clearance.size(); ++p)
    {
        clearance[p] = room
        (
            search,
            wall.points[p],
            visibility.cones[p],
            reach[p]
        );
    }

    return clearance;
}


// ************************************************************************* //
