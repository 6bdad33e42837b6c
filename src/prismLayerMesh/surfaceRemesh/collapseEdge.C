/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// From CGAL
#include <CGAL/boost/graph/Euler_operations.h>

#include "surfaceChanges.H"
#include "nearGiven.H"
#include "triPointRef.H"
#include "unitConversion.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef editedSurface::Mesh Mesh;
typedef editedSurface::Vertex Vertex;
typedef editedSurface::Halfedge Halfedge;
typedef editedSurface::Face Face;
typedef editedSurface::candidate candidate;

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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

} // End namespace Foam

// ************************************************************************* //
