/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// From CGAL
#include <CGAL/boost/graph/Euler_operations.h>

#include "editedSurface.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Points that split edges are no further from the middle than this share of
//  the length
static constexpr scalar farFromMiddle = 0.25;

//- Edges beside one that is split are no longer than this share of it
static constexpr scalar shorter = 0.95;


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


point editedSurface::middleOf(const Edge e, label& line) const
{
    const Halfedge h = mesh_.halfedge(e);
    const point middle(0.5*(at(mesh_.source(h)) + at(mesh_.target(h))));
    point x;
    line = lines_[e];

    if (line >= 0)
    {
        line = given_.findLine(line, middle, x);
        return x;
    }

    const Face f = mesh_.face(h);
    const Face g = mesh_.face(mesh_.opposite(h));
    point y;
    given_.findFace(nearest_[f], middle, reachOf(pointsOf(f)), x);
    given_.findFace(nearest_[g], middle, reachOf(pointsOf(g)), y);

    return magSqr(x - middle) <= magSqr(y - middle) ? x : y;
}


bool editedSurface::splits(const Edge e, const point& x) const
{
    const Halfedge h = mesh_.halfedge(e);
    const point middle(0.5*(at(mesh_.source(h)) + at(mesh_.target(h))));
    if (mag(x - middle) > farFromMiddle*length(e))
    {
        return false;
    }

    for (const Halfedge g : {h, mesh_.opposite(h)})
    {
        if
        (
            mesh_.face(g) != Mesh::null_face()
         && mag(x - at(mesh_.target(mesh_.next(g)))) > shorter*length(e)
        )
        {
            return false;
        }
    }

    return true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool editedSurface::split(const Edge e)
{
    if (isKept(e))
    {
        return false;
    }

    label line;
    const point x(middleOf(e, line));
    if (!splits(e, x) || (guard_ && !guard_->maySplit(mesh_.halfedge(e), x)))
    {
        return false;
    }

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
    noteChange(v);

    return true;
}

} // End namespace Foam

// ************************************************************************* //
