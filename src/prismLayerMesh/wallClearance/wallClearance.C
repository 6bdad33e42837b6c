/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallClearance.H"
#include "stageProgress.H"

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
    const scalar discriminant = sqr(along) - (1 - sqr(cosine))*magSqr(pq);

    return along > 0 && discriminant >= 0
      ? cosine*magSqr(pq)/(along + ::sqrt(discriminant))
      : -1;
}


namespace
{

//- A ball that touches the faces at a point, and what bounds it
struct ball
{
    scalar radius = 0;

    //- Triangle of the wall, or -1, and the centre of a ball that it bounds
    label bound = -1;
    point boundCentre = Zero;
};


//- The balls at a point of the wall
struct pointBalls
{
    const wallSearch& search;
    const point& p;
    //- Direction of the centres, and its smallest product with a normal
    const vector& axis;
    const scalar cosine;

    //- Largest ball, at most of the radius 'largest', that holds no point of a
    //  face that is opposite by oppositeCosine
    ball shrunken(const scalar largest, const scalar oppositeCosine) const
    {
        ball b{largest, -1, Zero};

        // Each round takes the deepest point inside the ball
        const auto shrink = [&]()
        {
            const point centre = p + b.radius/cosine*axis;
            const pointIndexHit hit
            (
                search.nearestOpposite
                (
                    centre,
                    (1 - clearanceControls::tolerance)*b.radius,
                    axis,
                    oppositeCosine
                )
            );

            if (!hit.hit())
            {
                return false;
            }

            const scalar lower =
                touchingHeight(p, axis, cosine, hit.rawPoint());

            if (lower < 0)
            {
                return false;
            }

            b = {lower, hit.index(), centre};

            return true;
        };
        repeatUntilStable
        (
            "shrinking balls", clearanceControls::maxRounds, shrink
        );

        return b;
    }


    //- The first ball, of growing ones up to the radius reach, that meets an
    //  opposite face
    ball first(const scalar reach, const scalar oppositeCosine) const
    {
        // Balls on a flat wall hold the smaller ones; at an edge they leave
        // room beside them
        scalar radius = cosine < clearanceControls::nestedCosine
          ? reach*clearanceControls::lowestShare : reach;
        ball b(shrunken(radius, oppositeCosine));

        // One ball ends where the next one begins if it is (1 + cosine)/(1 -
        // cosine) times as large
        const scalar step = min(scalar(2), 1/(1 - min(cosine, scalar(0.5))));

        while (b.bound < 0 && radius < reach)
        {
            radius = min(step*radius, reach);
            b = shrunken(radius, oppositeCosine);
        }

        return b;
    }


    //- A face that is opposite in part takes that part of the room beyond it
    scalar room(const scalar reach) const
    {
        const ball b(first(reach, clearanceControls::oppositeFrom));
        const scalar share =
            b.bound < 0
          ? 1 : search.opposition(b.bound, b.boundCentre, axis);

        if (share == 1)
        {
            return b.radius;
        }

        const ball beyond(first(reach, clearanceControls::oppositeFully));

        return beyond.radius + share*(b.radius - beyond.radius);
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

scalarField makeWallClearance
(
    const wallSurface& wall,
    const wallSearch& search,
    const wallVisibility& visibility,
    const scalarField& reach,
    const scalar maxStretch
)
{
    scalarField clearance(wall.points.size());
    progressCounter counter("room at points", clearance.size());

    #pragma omp parallel for schedule(dynamic, 64)
    for (label p = 0; p < clearance.size(); ++p)
    {
        const visibilityCone& cone = visibility.cones[p];
        const pointBalls balls
        {
            search, wall.points[p], cone.axis,
            max(cone.cosine, 1/maxStretch)
        };
        clearance[p] = balls.room(reach[p]);
        counter.countOne();
    }

    return clearance;
}


void boundByPlanes
(
    const UList<sidePatch>& planes,
    const pointField& points,
    const wallVisibility& visibility,
    scalarField& clearance,
    const scalar maxStretch
)
{
    for (const sidePatch& plane : planes)
    {
        forAll(points, p)
        {
            const visibilityCone& cone = visibility.cones[p];
            const scalar towards = plane.normal & cone.axis;
            if (towards > 0)
            {
                const scalar end = -0.5*plane.distance(points[p])/towards;
                const scalar cosine = max(cone.cosine, 1/maxStretch);
                clearance[p] = min(clearance[p], cosine*end);
            }
        }
    }
}


scalar roomAlong
(
    const wallSearch& search,
    const point& x,
    const vector& n,
    const scalar reach
)
{
    return pointBalls{search, x, n, 1}.room(reach);
}

} // End namespace Foam

// ************************************************************************* //
