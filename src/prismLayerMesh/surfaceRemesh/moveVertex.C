/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "editedSurface.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Angle [degrees] below which smoothing may make no angle smaller
static constexpr scalar enoughAngle = 30;

//- Moves that are shorter than this share of the wanted length are not worth it
static constexpr scalar leastMove = 0.05;

//- Steps of the search for a better place, in lengths of the shortest edge
static constexpr scalar firstStep = 0.3;
static constexpr scalar lastStep = 0.02;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

scalar editedSurface::smallestAngle(const Vertex v) const
{
    scalar least = GREAT;
    for (const Halfedge h : halfedgesFrom(v))
    {
        if (mesh_.face(h) != Mesh::null_face())
        {
            least = min(least, smallestAngle(mesh_.face(h)));
        }
    }

    return least;
}


scalar editedSurface::smallestAngle(const Vertex v, const point& x) const
{
    scalar least = GREAT;
    for (const Halfedge h : halfedgesFrom(v))
    {
        const Face f = mesh_.face(h);
        if (f == Mesh::null_face())
        {
            continue;
        }

        candidate triangle;
        triangle.points[0] = x;
        triangle.points[1] = at(mesh_.target(h));
        triangle.points[2] = at(mesh_.target(mesh_.next(h)));
        triangle.nearest = nearest_[f];
        if (!isNear(triangle))
        {
            return 0;
        }
        least = min(least, smallestAngleOf(triangle.points));
    }

    return least;
}


point editedSurface::onSurface(const Vertex v, const point& x) const
{
    point y(at(v));

    for (const Halfedge h : halfedgesFrom(v))
    {
        const label line = lines_[mesh_.edge(h)];
        if (kinds_[v] == kind::inside)
        {
            const Face f = mesh_.face(h);
            given_.findFace(nearest_[f], x, reachOf(pointsOf(f)), y);
            break;
        }
        if (line >= 0)
        {
            given_.findLine(line, x, y);
            break;
        }
    }

    return y;
}


void editedSurface::move(const Vertex v, const point& x)
{
    if (guard_) guard_->leaveAround(v);
    mesh_.point(v) = x;
    changed_[v] = ++nChanges_;
    for (const Halfedge h : halfedgesFrom(v))
    {
        if (mesh_.face(h) != Mesh::null_face())
        {
            tie(mesh_.face(h));
        }
    }
    if (guard_) guard_->enterAround(v);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool editedSurface::smooth(const Vertex v)
{
    if (kinds_[v] == kind::fixed || isAsBefore(v))
    {
        return false;
    }
    notMoved_[v] = nChanges_;

    point sum(Zero);
    label n = 0;
    for (const Halfedge h : halfedgesFrom(v))
    {
        if (kinds_[v] == kind::inside || lines_[mesh_.edge(h)] >= 0)
        {
            sum += at(mesh_.target(h));
            ++n;
        }
    }

    const point x(onSurface(v, sum/n));
    if (mag(x - at(v)) < leastMove*lengths[v])
    {
        return false;
    }
    const scalar after = smallestAngle(v, x);
    if
    (
        (after < degToRad(enoughAngle) && after <= smallestAngle(v))
     || (guard_ && !guard_->mayMove(v, x))
    )
    {
        return false;
    }
    move(v, x);

    return true;
}


bool editedSurface::optimise(const Vertex v)
{
    if (kinds_[v] == kind::fixed)
    {
        return false;
    }

    const scalar before = smallestAngle(v);
    scalar shortest = GREAT;
    for (const Halfedge h : halfedgesFrom(v))
    {
        shortest = min(shortest, length(mesh_.edge(h)));
    }

    scalar best = before;
    point place(at(v));
    for (scalar step = firstStep*shortest; step > lastStep*shortest; step /= 2)
    {
        const point from(place);
        for (label axis = 0; axis < 6; ++axis)
        {
            vector direction(Zero);
            direction[axis % 3] = axis < 3 ? step : -step;
            const point x(onSurface(v, from + direction));
            const scalar angle = smallestAngle(v, x);
            if (angle > best)
            {
                best = angle;
                place = x;
            }
        }
    }

    if (best <= before || (guard_ && !guard_->mayMove(v, place)))
    {
        return false;
    }
    move(v, place);

    return true;
}

} // End namespace Foam

// ************************************************************************* //
