/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// From CGAL
#include <CGAL/boost/graph/Euler_operations.h>

#include "editedSurface.H"
#include "triPointRef.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Angles [degrees] below which a collapse may not go, unless there are
//  smaller ones before
static constexpr scalar goodAngle = 15;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool editedSurface::isAlongLine(const Halfedge h) const
{
    const Vertex v = mesh_.source(h);
    const Vertex u = mesh_.target(h);
    if (kinds_[v] != kind::onLine)
    {
        return kinds_[v] == kind::inside;
    }

    const label line = lines_[mesh_.edge(h)];
    if (line < 0)
    {
        return false;
    }

    const Halfedge inside =
        mesh_.is_border(h) ? mesh_.opposite(h) : h;
    const scalar deviation = given_.deviation(nearest_[mesh_.face(inside)]);
    for (const Halfedge other : halfedgesFrom(v))
    {
        if (other != h && lines_[mesh_.edge(other)] >= 0)
        {
            const point& a = at(u);
            const point& b = at(mesh_.target(other));
            const scalar t =
                ((at(v) - a) & (b - a))/max(magSqr(b - a), VSMALL);
            const point middle(0.5*(a + b));
            point y;
            given_.findLine(line, middle, y);

            return
                t > 0 && t < 1
             && mag(at(v) - (a + t*(b - a))) <= deviation
             && mag(middle - y) <= deviation;
        }
    }

    return false;
}


std::vector<editedSurface::candidate> editedSurface::trianglesLeft
(
    const Halfedge h
) const
{
    const Vertex v = mesh_.source(h);
    const Vertex u = mesh_.target(h);
    std::vector<candidate> result;

    for (const Halfedge g : halfedgesFrom(v))
    {
        const Face f = mesh_.face(g);
        if (f == Mesh::null_face() || isOf(u, f))
        {
            continue;
        }

        FixedList<Vertex, 3> vertices(verticesOf(f));
        for (Vertex& w : vertices)
        {
            w = w == v ? u : w;
        }
        result.push_back
        (
            triangleOf(vertices[0], vertices[1], vertices[2], nearest_[f])
        );
    }

    return result;
}


bool editedSurface::mayReplace
(
    const Halfedge h,
    std::vector<candidate>& triangles
) const
{
    const Vertex v = mesh_.source(h);
    const Vertex u = mesh_.target(h);
    const scalar least = min(smallestAngle(v), degToRad(goodAngle));
    scalar distance = GREAT;
    scalar deviation = GREAT;

    for (candidate& t : triangles)
    {
        if (smallestAngleOf(t.points) < least || !isNear(t))
        {
            return false;
        }

        for (label k = 0; k < 3; ++k)
        {
            // New edges begin at the target; each is of two triangles
            if
            (
                t.vertices[k] == u
             && !isNear(t.points[k], t.points[(k + 1) % 3], t.nearest)
            )
            {
                return false;
            }
        }

        const triPointRef triangle(t.points[0], t.points[1], t.points[2]);
        distance = min(distance, triangle.nearestPoint(at(v)).distance());
        deviation = min(deviation, given_.deviation(t.nearest));
    }

    return distance <= deviation;
}


bool editedSurface::wouldStretch(const Halfedge h, const scalar maxRatio) const
{
    const Vertex u = mesh_.target(h);

    for (const Halfedge g : halfedgesFrom(mesh_.source(h)))
    {
        const Vertex w = mesh_.target(g);
        if
        (
            w != u
         && mag(at(w) - at(u)) > maxRatio*0.5*(lengths[u] + lengths[w])
        )
        {
            return true;
        }
    }

    return false;
}


std::vector<std::pair<editedSurface::Vertex, label>>
editedSurface::joinedLines(const Halfedge h) const
{
    std::vector<std::pair<Vertex, label>> lines;
    const auto add = [&](const Vertex w, const Halfedge g)
    {
        if (lines_[mesh_.edge(g)] >= 0)
        {
            lines.emplace_back(w, lines_[mesh_.edge(g)]);
        }
    };

    for (const Halfedge g : halfedgesFrom(mesh_.source(h)))
    {
        if (g != h)
        {
            add(mesh_.target(g), g);
        }
    }

    const Halfedge back = mesh_.opposite(h);
    if (mesh_.face(h) != Mesh::null_face())
    {
        add(mesh_.target(mesh_.next(h)), mesh_.next(h));
    }
    if (mesh_.face(back) != Mesh::null_face())
    {
        add(mesh_.source(mesh_.prev(back)), mesh_.prev(back));
    }

    return lines;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool editedSurface::collapse(const Halfedge h, const scalar maxRatio)
{
    const Edge e = mesh_.edge(h);
    const Vertex u = mesh_.target(h);
    if
    (
        isKept(e) || !isAlongLine(h) || wouldStretch(h, maxRatio)
     || !CGAL::Euler::does_satisfy_link_condition(e, mesh_)
    )
    {
        return false;
    }

    std::vector<candidate> triangles(trianglesLeft(h));
    if (!mayReplace(h, triangles) || (guard_ && !guard_->mayCollapse(h)))
    {
        return false;
    }
    if (guard_) guard_->leaveAround(mesh_.source(h));

    const std::vector<std::pair<Vertex, label>> lines(joinedLines(h));
    const point x(at(u));
    const kind kindOf = kinds_[u];
    const scalar wanted = lengths[u];
    const Vertex left = CGAL::Euler::collapse_edge(e, mesh_);
    mesh_.point(left) = x;
    kinds_[left] = kindOf;
    lengths[left] = wanted;

    const auto now = [&](const Vertex w) { return w == u ? left : w; };
    for (const auto& line : lines)
    {
        const Halfedge g = mesh_.halfedge(left, line.first);
        lines_[mesh_.edge(g)] = line.second;
    }
    for (const candidate& t : triangles)
    {
        const Halfedge g =
            mesh_.halfedge(now(t.vertices[0]), now(t.vertices[1]));
        nearest_[mesh_.face(g)] = t.nearest;
        if (guard_) guard_->enter(mesh_.face(g));
    }
    noteChange(left);

    return true;
}

} // End namespace Foam

// ************************************************************************* //
