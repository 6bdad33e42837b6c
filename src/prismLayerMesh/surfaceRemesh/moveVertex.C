/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceChanges.H"
#include "nearGiven.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef editedSurface::Mesh Mesh;
typedef editedSurface::Vertex Vertex;
typedef editedSurface::Halfedge Halfedge;
typedef editedSurface::Face Face;

//- Angle [degrees] below which smoothing may make no angle smaller
static constexpr scalar enoughAngle = 30;

//- Moves that are shorter than this share of the wanted length are not worth it
static constexpr scalar leastMove = 0.05;

//- Steps of the search for a better place, in lengths of the shortest edge
static constexpr scalar firstStep = 0.3;
static constexpr scalar lastStep = 0.02;


//- The smallest angle [rad] around a vertex if it were at x; 0 if it may not be
//  there
static scalar smallestAngleAt
(
    const editedSurface& surface,
    const Vertex v,
    const point& x
)
{
    const Mesh& mesh = surface.mesh();
    scalar least = GREAT;
    for (const Halfedge h : surface.halfedgesFrom(v))
    {
        const Face f = mesh.face(h);
        if (f == Mesh::null_face())
        {
            continue;
        }

        FixedList<point, 3> triangle;
        triangle[0] = x;
        triangle[1] = surface.at(mesh.target(h));
        triangle[2] = surface.at(mesh.target(mesh.next(h)));
        label nearest = surface.nearest(f);
        if (!isNear(surface.given(), triangle, nearest))
        {
            return 0;
        }
        least = min(least, smallestAngleOf(triangle));
    }

    return least;
}


//- Returns the point that is nearest to x on the surface, or on the line that
//  the vertex is on
static point onSurface
(
    const editedSurface& surface,
    const Vertex v,
    const point& x
)
{
    const givenSurface& given = surface.given();
    point y(surface.at(v));

    for (const Halfedge h : surface.halfedgesFrom(v))
    {
        const label line = surface.line(surface.mesh().edge(h));
        if (surface.kindOf(v) == editedSurface::kind::inside)
        {
            const Face f = surface.mesh().face(h);
            const scalar reach = reachOf(surface.pointsOf(f));
            given.findFace(surface.nearest(f), x, reach, y);
            break;
        }
        if (line >= 0)
        {
            given.findLine(line, x, y);
            break;
        }
    }

    return y;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool smoothVertex(editedSurface& surface, const Vertex v)
{
    const auto kind = surface.kindOf(v);
    if (kind == editedSurface::kind::fixed || !surface.journal().isNew(v))
    {
        return false;
    }

    point sum(Zero);
    label n = 0;
    for (const Halfedge h : surface.halfedgesFrom(v))
    {
        if
        (
            kind == editedSurface::kind::inside
         || surface.line(surface.mesh().edge(h)) >= 0
        )
        {
            sum += surface.at(surface.mesh().target(h));
            ++n;
        }
    }

    const point x(onSurface(surface, v, sum/n));
    if (mag(x - surface.at(v)) < leastMove*surface.lengths[v])
    {
        return false;
    }
    const scalar after = smallestAngleAt(surface, v, x);
    if
    (
        (
            after < degToRad(enoughAngle)
         && after <= surface.smallestAngle(v)
        )
     || (surface.guard() && !surface.guard()->mayMove(v, x))
    )
    {
        return false;
    }
    surface.move(v, x);

    return true;
}


bool optimiseVertex(editedSurface& surface, const Vertex v)
{
    if (surface.kindOf(v) == editedSurface::kind::fixed)
    {
        return false;
    }

    const scalar before = surface.smallestAngle(v);
    scalar shortest = GREAT;
    for (const Halfedge h : surface.halfedgesFrom(v))
    {
        shortest = min(shortest, surface.length(surface.mesh().edge(h)));
    }

    scalar best = before;
    point place(surface.at(v));
    for (scalar step = firstStep*shortest; step > lastStep*shortest; step /= 2)
    {
        const point from(place);
        for (label axis = 0; axis < 6; ++axis)
        {
            vector direction(Zero);
            direction[axis % 3] = axis < 3 ? step : -step;
            const point x(onSurface(surface, v, from + direction));
            const scalar angle = smallestAngleAt(surface, v, x);
            if (angle > best)
            {
                best = angle;
                place = x;
            }
        }
    }

    const changeGuard* guard = surface.guard();
    if (best <= before || (guard && !guard->mayMove(v, place)))
    {
        return false;
    }
    surface.move(v, place);

    return true;
}

} // End namespace Foam

// ************************************************************************* //
