/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// From CGAL
#include <CGAL/boost/graph/Euler_operations.h>

#include "editedSurface.H"
#include "nearGiven.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void editedSurface::divide(const Halfedge a, const Halfedge b)
{
    const Face old = mesh_.face(a);
    const Halfedge h = CGAL::Euler::split_face(a, b, mesh_);
    lines_[mesh_.edge(h)] = -1;

    for (const Face f : {mesh_.face(h), mesh_.face(mesh_.opposite(h))})
    {
        nearest_[f] = nearest_[old];
        patches_[f] = patches_[old];
        tie(f);
    }
    if (guard_) guard_->enterBeside(h);
}


void editedSurface::tie(const Face f)
{
    const FixedList<point, 3> x(pointsOf(f));
    point y;
    nearest_[f] =
        given_.findFace
        (
            nearest_[f], (x[0] + x[1] + x[2])/3.0, reachOf(x), y
        );
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

void editedSurface::split(const Edge e, const point& x, const label line)
{
    const Halfedge h = mesh_.halfedge(e);
    const Vertex a = mesh_.source(h);
    const Vertex b = mesh_.target(h);
    if (guard_) guard_->leaveBeside(h);
    const Halfedge before = CGAL::Euler::split_edge(h, mesh_);
    const Halfedge after = mesh_.next(before);
    const Vertex v = mesh_.target(before);
    mesh_.point(v) = x;
    lengths[v] = 0.5*(lengths[a] + lengths[b]);
    kinds_[v] = line >= 0 ? kind::onLine : kind::inside;
    lines_[mesh_.edge(before)] = line;
    lines_[mesh_.edge(after)] = line;

    for (const Halfedge in : {before, mesh_.opposite(after)})
    {
        if (mesh_.face(in) != Mesh::null_face())
        {
            divide(in, mesh_.next(mesh_.next(in)));
        }
    }
    journal_.noteAround(v);
}


void editedSurface::collapse
(
    const Halfedge h,
    const std::vector<candidate>& triangles
)
{
    const Vertex u = mesh_.target(h);
    if (guard_) guard_->leaveAround(mesh_.source(h));

    const std::vector<std::pair<Vertex, label>> lines(joinedLines(h));
    const point x(at(u));
    const kind kept = kinds_[u];
    const scalar wanted = lengths[u];
    const Vertex left = CGAL::Euler::collapse_edge(mesh_.edge(h), mesh_);
    mesh_.point(left) = x;
    kinds_[left] = kept;
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
    journal_.noteAround(left);
}


void editedSurface::flip
(
    const Halfedge h,
    const candidate& first,
    const candidate& second
)
{
    const Vertex a = mesh_.source(h);
    if (guard_) guard_->leaveBeside(h);
    CGAL::Euler::flip_edge(h, mesh_);
    if (guard_) guard_->enterBeside(h);

    journal_.noteBeside(h);
    for (const Halfedge side : {h, mesh_.opposite(h)})
    {
        const Vertex w = mesh_.target(mesh_.next(side));
        nearest_[mesh_.face(side)] = (w == a ? first : second).nearest;
    }
}


void editedSurface::move(const Vertex v, const point& x)
{
    if (guard_) guard_->leaveAround(v);
    mesh_.point(v) = x;
    journal_.noteMove(v);
    for (const Halfedge h : halfedgesFrom(v))
    {
        if (mesh_.face(h) != Mesh::null_face())
        {
            tie(mesh_.face(h));
        }
    }
    if (guard_) guard_->enterAround(v);
}

} // End namespace Foam

// ************************************************************************* //
