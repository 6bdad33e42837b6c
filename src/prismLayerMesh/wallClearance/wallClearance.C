/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallClearance.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Radius of the ball that touches the wall's faces at p, has its centre on the
//  axis d, and passes through q: the smaller root s*cosine of
//  |p + s*d - q| = s*cosine. Negative if there is no root.
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


//- Radius of the largest ball, at most largest, that holds no opposite point
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

    // Each round takes the deepest point inside the ball
    for (label round = 0; round < clearanceControls::maxRounds; ++round)
    {
        const pointIndexHit hit
        (
            search.nearestOpposite(p + height/cosine*d, height, d)
        );

        if (!hit.hit())
        {
            break;
        }

        const scalar lower = touchingHeight(p, d, cosine, hit.rawPoint());

        if (lower < 0 || lower >= (1 - clearanceControls::tolerance)*height)
        {
            break;
        }

        height = lower;
    }

    return height;
}


//- The radius up to which no ball holds an opposite point
static scalar room
(
    const wallSearch& search,
    const point& p,
    const visibilityCone& cone,
    const scalar reach
)
{
    const scalar cosine = max(cone.cosine, 1/clearanceControls::maxStretch);

    // Balls on a flat wall hold the smaller ones; at an edge they leave room
    // beside them
    scalar height = cosine < clearanceControls::nestedCosine
      ? reach*clearanceControls::lowestShare : reach;
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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

scalarField makeWallClearance
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
        clearance[p] =
            room(search, wall.points[p], visibility.cones[p], reach[p]);
    }

    return clearance;
}

} // End namespace Foam

// ************************************************************************* //
