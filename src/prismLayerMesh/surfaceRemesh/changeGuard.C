/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "changeGuard.H"
#include "ranges.H"
#include "wallVisibility.H"

#include <algorithm>
#include <CGAL/boost/graph/graph_traits_Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

boundBox changeGuard::boxOf(const Face f) const
{
    boundBox box(boundBox::invertedBox);
    for (const Vertex v : mesh_.vertices_around_face(mesh_.halfedge(f)))
    {
        box.add(mesh_.point(v));
    }

    return box;
}


std::vector<changeGuard::Face> changeGuard::facesAt(const Vertex v) const
{
    std::vector<Face> faces;
    for (const Halfedge h : CGAL::halfedges_around_source(v, mesh_))
    {
        if (mesh_.face(h) != Mesh::null_face())
        {
            faces.push_back(mesh_.face(h));
        }
    }

    return faces;
}


labelledTriangle changeGuard::triangleOf
(
    const Vertex a,
    const Vertex b,
    const Vertex c
) const
{
    labelledTriangle t;
    const Vertex vertices[3] = {a, b, c};
    for (label k = 0; k < 3; ++k)
    {
        t.labels[k] = vertices[k];
        t.points[k] = mesh_.point(vertices[k]);
    }

    return t;
}


changeGuard::triangleList changeGuard::trianglesWith
(
    const Vertex v,
    const label other,
    const point& x
) const
{
    triangleList triangles;
    for (const Halfedge h : CGAL::halfedges_around_source(v, mesh_))
    {
        const Vertex b = mesh_.target(h);
        const Vertex c = mesh_.target(mesh_.next(h));
        if
        (
            mesh_.face(h) != Mesh::null_face()
         && label(b) != other && label(c) != other
        )
        {
            triangles.push_back(triangleOf(v, b, c));
            triangles.back().labels[0] = other;
            triangles.back().points[0] = x;
        }
    }

    return triangles;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

changeGuard::changeGuard(const Mesh& mesh)
:
    mesh_(mesh)
{
    for (const Face f : mesh_.faces())
    {
        enter(f);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void changeGuard::leaveAround(const Vertex v)
{
    for (const Face f : facesAt(v))
    {
        leave(f);
    }
}


void changeGuard::enterAround(const Vertex v)
{
    for (const Face f : facesAt(v))
    {
        enter(f);
    }
}


void changeGuard::leaveBeside(const Halfedge h)
{
    for (const Face f : {mesh_.face(h), mesh_.face(mesh_.opposite(h))})
    {
        if (f != Mesh::null_face())
        {
            leave(f);
        }
    }
}


void changeGuard::enterBeside(const Halfedge h)
{
    for (const Face f : {mesh_.face(h), mesh_.face(mesh_.opposite(h))})
    {
        if (f != Mesh::null_face())
        {
            enter(f);
        }
    }
}


bool changeGuard::mayCollapse(const Halfedge h) const
{
    const Vertex v = mesh_.source(h);
    const Vertex u = mesh_.target(h);

    return mayReplace(trianglesWith(v, u, mesh_.point(u)), facesAt(v));
}


bool changeGuard::mayFlip(const Halfedge h) const
{
    const Halfedge back = mesh_.opposite(h);
    const Vertex c = mesh_.target(mesh_.next(h));
    const Vertex d = mesh_.target(mesh_.next(back));

    return mayReplace
    (
        {
            triangleOf(mesh_.source(h), d, c), triangleOf(mesh_.target(h), c, d)
        },
        {mesh_.face(h), mesh_.face(back)}
    );
}


bool changeGuard::maySplit(const Halfedge h, const point& x) const
{
    triangleList made;
    std::vector<Face> replaced;
    for (const Halfedge g : {h, mesh_.opposite(h)})
    {
        if (mesh_.face(g) == Mesh::null_face())
        {
            continue;
        }
        replaced.push_back(mesh_.face(g));
        for (const Halfedge side : {mesh_.next(g), mesh_.prev(g)})
        {
            const Vertex a = mesh_.source(side);
            made.push_back(triangleOf(a, a, mesh_.target(side)));

            // The label of no vertex
            made.back().labels[0] = -1;
            made.back().points[0] = x;
        }
    }

    return mayReplace(made, replaced);
}


bool changeGuard::mayMove(const Vertex v, const point& x) const
{
    return mayReplace(trianglesWith(v, v, x), facesAt(v));
}


// * * * * * * * * * * * * *  Change Guard Replace * * * * * * * * * * * * * //

static vector normalOf(const labelledTriangle& t)
{
    const vector n((t.points[1] - t.points[0]) ^ (t.points[2] - t.points[0]));

    return n/max(mag(n), VSMALL);
}


//- Whether no direction is in front of all faces with these normals
static bool isBlind(const UList<vector>& normals)
{
    const vector mean(sum(normals));
    const auto isBehind = [&](const vector& n) { return (n & mean) <= 0; };

    return anyOf(normals, isBehind) && makeVisibilityCone(normals).empty();
}


//- Whether two triangles intersect, or have an edge in common at which they are
//  folded onto each other
static bool isConflict
(
    const labelledTriangle& a,
    const labelledTriangle& b,
    const bool mayFold
)
{
    if (intersect(a, b))
    {
        return true;
    }

    label nCommon = 0;
    for (const label i : a.labels)
    {
        nCommon += i == b.labels[0] || i == b.labels[1] || i == b.labels[2];
    }

    return
        !mayFold && nCommon == 2
     && (normalOf(a) & normalOf(b)) < foldCosine();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

vector changeGuard::normalOf(const Face f) const
{
    vector n(Zero);
    const point& x = mesh_.point(mesh_.target(mesh_.halfedge(f)));
    for (const Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(f)))
    {
        n += (mesh_.point(mesh_.source(h)) - x)
          ^ (mesh_.point(mesh_.target(h)) - x);
    }

    return n/max(mag(n), VSMALL);
}


bool changeGuard::isFolded(const Face f) const
{
    const vector n(normalOf(f));
    for (const Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(f)))
    {
        const Face g = mesh_.face(mesh_.opposite(h));
        if (g != Mesh::null_face() && (n & normalOf(g)) < foldCosine())
        {
            return true;
        }
    }

    return false;
}


bool changeGuard::blinds
(
    const triangleList& made,
    const std::vector<Face>& replaced,
    const label v
) const
{
    DynamicList<vector> before;
    DynamicList<vector> after;
    for (const labelledTriangle& t : made)
    {
        if (std::count(t.labels, t.labels + 3, v))
        {
            after.append(Foam::normalOf(t));
        }
    }
    for (const Face f : v < 0 ? replaced : facesAt(Vertex(v)))
    {
        before.append(normalOf(f));
        if (std::find(replaced.begin(), replaced.end(), f) == replaced.end())
        {
            after.append(before.last());
        }
    }

    return isBlind(after) && !isBlind(before);
}


bool changeGuard::meets
(
    const triangleList& triangles,
    const Face f,
    const bool mayFold
) const
{
    // The triangles of a kept polygon are a fan
    const Halfedge first = mesh_.halfedge(f);
    for
    (
        Halfedge h = mesh_.next(first);
        mesh_.target(h) != mesh_.source(first);
        h = mesh_.next(h)
    )
    {
        const labelledTriangle other
        (
            triangleOf(mesh_.source(first), mesh_.source(h), mesh_.target(h))
        );
        const boundBox box(other.box());

        for (const labelledTriangle& t : triangles)
        {
            if (box.overlaps(t.box()) && isConflict(t, other, mayFold))
            {
                return true;
            }
        }
    }

    return false;
}


bool changeGuard::mayReplace
(
    const triangleList& made,
    const std::vector<Face>& replaced
) const
{
    // A collapse may leave nothing of an end of the surface
    if (made.empty())
    {
        return false;
    }

    const bool mayFold =
        anyOf(replaced, [&](const Face f) { return isFolded(f); });
    boundBox box(boundBox::invertedBox);
    for (auto t = made.begin(); t != made.end(); ++t)
    {
        const bool conflicts = std::any_of
        (
            made.begin(), t,
            [&](const labelledTriangle& other)
            {
                return isConflict(*t, other, mayFold);
            }
        );
        if (conflicts || t->degenerate())
        {
            return false;
        }
        box.add(t->box());
    }

    for (const labelledTriangle& t : made)
    {
        const auto blind = [&](const label v)
        {
            return blinds(made, replaced, v);
        };
        if (std::any_of(t.labels, t.labels + 3, blind))
        {
            return false;
        }
    }

    return !grid_.any
    (
        box, [&](const label i)
        {
            const Face f(i);

            return
                std::find(replaced.begin(), replaced.end(), f)
             == replaced.end()
             && meets(made, f, mayFold);
        }
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

changeJournal::changeJournal(Mesh& mesh)
:
    mesh_(mesh),
    changed_(mesh.add_property_map<Vertex, label>("v:changed", 0).first),
    edgeSeen_(mesh.add_property_map<Edge, label>("e:seen", -1).first),
    vertexSeen_(mesh.add_property_map<Vertex, label>("v:seen", -1).first)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void changeJournal::noteAround(const Vertex v)
{
    noteMove(v);
    for (const Halfedge h : CGAL::halfedges_around_source(v, mesh_))
    {
        changed_[mesh_.target(h)] = nChanges_;
    }
}


void changeJournal::noteBeside(const Halfedge h)
{
    ++nChanges_;
    for (const Halfedge side : {h, mesh_.opposite(h)})
    {
        changed_[mesh_.target(side)] = nChanges_;
        changed_[mesh_.target(mesh_.next(side))] = nChanges_;
    }
}


bool changeJournal::isNew(const Edge e)
{
    const label before = edgeSeen_[e];
    edgeSeen_[e] = nChanges_;

    bool result = false;
    for (label i = 0; i < 2; ++i)
    {
        const Halfedge h = mesh_.halfedge(e, i);
        result = result
         || changed_[mesh_.target(h)] > before
         || changed_[mesh_.target(mesh_.next(h))] > before;
    }

    return result;
}


bool changeJournal::isNew(const Vertex v)
{
    const label before = vertexSeen_[v];
    vertexSeen_[v] = nChanges_;

    bool result = changed_[v] > before;
    for (const Halfedge h : CGAL::halfedges_around_source(v, mesh_))
    {
        result = result || changed_[mesh_.target(h)] > before;
    }

    return result;
}

} // End namespace Foam

// ************************************************************************* //
