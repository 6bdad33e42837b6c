/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceChanges.H"
#include "givenSurface.H"
#include "triPointRef.H"
#include "unitConversion.H"

#include <algorithm>
#include <CGAL/boost/graph/Euler_operations.h>

namespace Foam
{

typedef editedSurface::Mesh Mesh;
typedef editedSurface::Vertex Vertex;
typedef editedSurface::Halfedge Halfedge;
typedef editedSurface::Edge Edge;
typedef editedSurface::Face Face;
typedef editedSurface::candidate candidate;

//- Points that split edges are no further from the middle than this share of
//  the length
static constexpr scalar farFromMiddle = 0.25;

//- Edges beside one that is split are no longer than this share of it
static constexpr scalar shorter = 0.95;


static point middleOf(const editedSurface& surface, const Halfedge h)
{
    const Mesh& mesh = surface.mesh();

    return 0.5*(surface.at(mesh.source(h)) + surface.at(mesh.target(h)));
}


//- Returns the point of the given surface, or of an edge's line, that is
//  nearest to the middle of the edge; sets the line, -1 for none
static point newPointOf(const editedSurface& surface, const Edge e, label& line)
{
    const givenSurface& given = surface.given();
    const Halfedge h = surface.mesh().halfedge(e);
    const point middle(middleOf(surface, h));
    point x;
    line = surface.line(e);

    if (line >= 0)
    {
        line = given.findLine(line, middle, x);
        return x;
    }

    const auto find = [&](const Face f, point& nearest)
    {
        const scalar reach = reachOf(surface.pointsOf(f));
        given.findFace(surface.nearest(f), middle, reach, nearest);
    };
    point y;
    find(surface.mesh().face(h), x);
    find(surface.mesh().face(surface.mesh().opposite(h)), y);

    return magSqr(x - middle) <= magSqr(y - middle) ? x : y;
}


//- Whether x is near enough to the middle of an edge to split the edge there,
//  and new edges from x are shorter than the edge
static bool splits
(
    const editedSurface& surface,
    const Halfedge h,
    const point& x
)
{
    const Mesh& mesh = surface.mesh();
    const scalar length = surface.length(mesh.edge(h));
    if (mag(x - middleOf(surface, h)) > farFromMiddle*length)
    {
        return false;
    }

    for (const Halfedge g : {h, mesh.opposite(h)})
    {
        const point& across = surface.at(mesh.target(mesh.next(g)));
        if
        (
            mesh.face(g) != Mesh::null_face()
         && mag(x - across) > shorter*length
        )
        {
            return false;
        }
    }

    return true;
}


bool splitEdge(editedSurface& surface, const Edge e)
{
    if (surface.isKept(e))
    {
        return false;
    }

    const Halfedge h = surface.mesh().halfedge(e);
    const changeGuard* guard = surface.guard();
    label line;
    const point x(newPointOf(surface, e, line));
    if (!splits(surface, h, x) || (guard && !guard->maySplit(h, x)))
    {
        return false;
    }
    surface.split(e, x, line);

    return true;
}


// * * * * * * * * * * * * * * *  Collapse Edge  * * * * * * * * * * * * * * //

//- Angles [degrees] below which a collapse may not go, unless there are
//  smaller ones before
static constexpr scalar goodAngle = 15;


//- Whether lines let the source of an edge go to the target. A source on a line
//  may go along that line only, a source inside may go anywhere, a fixed source
//  nowhere.
static bool isAlongLine(const editedSurface& surface, const Halfedge h)
{
    const Mesh& mesh = surface.mesh();
    const point& x = surface.at(mesh.source(h));
    const auto kind = surface.kindOf(mesh.source(h));
    if (kind != editedSurface::kind::onLine)
    {
        return kind == editedSurface::kind::inside;
    }

    const label line = surface.line(mesh.edge(h));
    if (line < 0)
    {
        return false;
    }

    const Face f = mesh.face(mesh.is_border(h) ? mesh.opposite(h) : h);
    const scalar deviation = surface.given().deviation(surface.nearest(f));
    for (const Halfedge other : surface.halfedgesFrom(mesh.source(h)))
    {
        if (other != h && surface.line(mesh.edge(other)) >= 0)
        {
            const point& a = surface.at(mesh.target(h));
            const point& b = surface.at(mesh.target(other));
            const scalar t = ((x - a) & (b - a))/max(magSqr(b - a), VSMALL);
            const point middle(0.5*(a + b));
            point y;
            surface.given().findLine(line, middle, y);

            return
                t > 0 && t < 1
             && mag(x - (a + t*(b - a))) <= deviation
             && mag(middle - y) <= deviation;
        }
    }

    return false;
}


//- Returns the triangles that stay around the source of an edge that collapses,
//  with the target in place of the source
static std::vector<candidate> trianglesLeft
(
    const editedSurface& surface,
    const Halfedge h
)
{
    const Mesh& mesh = surface.mesh();
    const Vertex v = mesh.source(h);
    const Vertex u = mesh.target(h);
    std::vector<candidate> result;

    for (const Halfedge g : surface.halfedgesFrom(v))
    {
        const Face f = mesh.face(g);
        if (f == Mesh::null_face())
        {
            continue;
        }

        FixedList<Vertex, 3> vertices(surface.verticesOf(f));
        if (!vertices.found(u))
        {
            std::replace(vertices.begin(), vertices.end(), v, u);
            result.push_back
            (
                surface.triangleOf
                (
                    vertices[0], vertices[1], vertices[2], surface.nearest(f)
                )
            );
        }
    }

    return result;
}


//- Whether these triangles may replace the triangles around the source of an
//  edge; sets their nearest triangles
static bool mayReplace
(
    const editedSurface& surface,
    const Halfedge h,
    std::vector<candidate>& triangles
)
{
    const givenSurface& given = surface.given();
    const Vertex v = surface.mesh().source(h);
    const Vertex u = surface.mesh().target(h);
    const scalar least = min(surface.smallestAngle(v), degToRad(goodAngle));
    scalar distance = GREAT;
    scalar deviation = GREAT;

    for (candidate& t : triangles)
    {
        const FixedList<point, 3>& x = t.points;
        if (smallestAngleOf(x) < least || !isNear(given, x, t.nearest))
        {
            return false;
        }

        for (label k = 0; k < 3; ++k)
        {
            // New edges begin at the target; each is of two triangles
            if
            (
                t.vertices[k] == u
             && !isNear(given, x[k], x[(k + 1) % 3], t.nearest)
            )
            {
                return false;
            }
        }

        const triPointRef triangle(x[0], x[1], x[2]);
        distance =
            min(distance, triangle.nearestPoint(surface.at(v)).distance());
        deviation = min(deviation, given.deviation(t.nearest));
    }

    return distance <= deviation;
}


//- Whether the collapse would make an edge longer than maxRatio times the mean
//  of the lengths that its ends want
static bool wouldStretch
(
    const editedSurface& surface,
    const Halfedge h,
    const scalar maxRatio
)
{
    const Mesh& mesh = surface.mesh();
    const Vertex u = mesh.target(h);

    for (const Halfedge g : surface.halfedgesFrom(mesh.source(h)))
    {
        const Vertex w = mesh.target(g);
        const scalar wanted = 0.5*(surface.lengths[u] + surface.lengths[w]);
        if (w != u && mag(surface.at(w) - surface.at(u)) > maxRatio*wanted)
        {
            return true;
        }
    }

    return false;
}


bool collapseEdge
(
    editedSurface& surface,
    const Halfedge h,
    const scalar maxRatio
)
{
    const Mesh& mesh = surface.mesh();
    if
    (
        surface.isKept(mesh.edge(h)) || !isAlongLine(surface, h)
     || wouldStretch(surface, h, maxRatio)
     || !CGAL::Euler::does_satisfy_link_condition(mesh.edge(h), mesh)
    )
    {
        return false;
    }

    std::vector<candidate> triangles(trianglesLeft(surface, h));
    if
    (
        !mayReplace(surface, h, triangles)
     || (surface.guard() && !surface.guard()->mayCollapse(h))
    )
    {
        return false;
    }
    surface.collapse(h, triangles);

    return true;
}


// * * * * * * * * * * * * * * * *  Flip Edge  * * * * * * * * * * * * * * * //

bool flipEdge(editedSurface& surface, const editedSurface::Edge e)
{
    typedef editedSurface::Vertex Vertex;
    const editedSurface::Mesh& mesh = surface.mesh();
    if
    (
        surface.line(e) >= 0 || surface.isKept(e) || mesh.is_border(e)
     || !surface.journal().isNew(e)
    )
    {
        return false;
    }

    const auto h = mesh.halfedge(e);
    const auto back = mesh.opposite(h);
    const Vertex a = mesh.source(h);
    const Vertex b = mesh.target(h);
    const Vertex c = mesh.target(mesh.next(h));
    const Vertex d = mesh.target(mesh.next(back));
    const auto f = mesh.face(h);
    const auto g = mesh.face(back);
    auto first(surface.triangleOf(a, d, c, surface.nearest(f)));
    auto second(surface.triangleOf(b, c, d, surface.nearest(g)));
    const scalar before =
        min(surface.smallestAngle(f), surface.smallestAngle(g));
    const scalar after =
        min(smallestAngleOf(first.points), smallestAngleOf(second.points));
    const givenSurface& given = surface.given();
    if
    (
        after < before + 1e-6
     || mesh.halfedge(c, d).is_valid()
     || !isNear(given, first.points, first.nearest)
     || !isNear(given, second.points, second.nearest)
     || !isNear(given, surface.at(c), surface.at(d), first.nearest)
     || (surface.guard() && !surface.guard()->mayFlip(h))
    )
    {
        return false;
    }
    surface.flip(h, first, second);

    return true;
}


// * * * * * * * * * * * * * * *  Move Vertex  * * * * * * * * * * * * * * * //

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
    ((after < degToRad(enoughAngle) && after <= surface.smallestAngle(v))
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
