/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "editedSurface.H"
#include "cgalMeshes.H"
#include "givenSurface.H"

#include <CGAL/boost/graph/Euler_operations.h>

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void editedSurface::fill(const edgeHashSet& kept)
{
    const wallSurface& surface = given_.surface();
    addFaces(surface, mesh_);

    if (mesh_.number_of_faces() != std::size_t(surface.faces.size()))
    {
        FatalErrorInFunction
            << "The surface is not oriented and manifold" << exit(FatalError);
    }

    for (const Face f : mesh_.faces())
    {
        const label facei = f;
        patches_[f] = surface.patchIDs[facei];
        nearest_[f] = surface.faces[facei].size() == 3 ? facei : -1;
    }

    for (const Vertex v : mesh_.vertices())
    {
        kinds_[v] =
            given_.isCorner(v) || mesh_.is_isolated(v) ? kind::fixed
          : given_.isOnLine(v) ? kind::onLine
          : kind::inside;
    }

    isKeptLine_.setSize(given_.lines().size());
    forAll(given_.lines(), l)
    {
        const edge& e = given_.lines()[l];
        isKeptLine_[l] = kept.found(e);
        lines_[mesh_.edge(mesh_.halfedge(Vertex(e[0]), Vertex(e[1])))] = l;
    }

    for (const Edge e : mesh_.edges())
    {
        if (isKept(e))
        {
            kinds_[mesh_.vertex(e, 0)] = kind::fixed;
            kinds_[mesh_.vertex(e, 1)] = kind::fixed;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

editedSurface::editedSurface
(
    const givenSurface& given,
    const bool guarded,
    const edgeHashSet& kept
)
:
    given_(given),
    journal_(mesh_)
{
    lengths = mesh_.add_property_map<Vertex, scalar>("v:length", GREAT).first;
    kinds_ = mesh_.add_property_map<Vertex, kind>("v:kind").first;
    lines_ = mesh_.add_property_map<Edge, label>("e:line", -1).first;
    nearest_ = mesh_.add_property_map<Face, label>("f:nearest", -1).first;
    patches_ = mesh_.add_property_map<Face, label>("f:patch", 0).first;
    fill(kept);

    guard_.reset(guarded ? new changeGuard(mesh_) : nullptr);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool editedSurface::isKept(const Edge e) const
{
    if (lines_[e] >= 0 && isKeptLine_[lines_[e]])
    {
        return true;
    }

    for (label side = 0; side < 2; ++side)
    {
        const Face f = mesh_.face(mesh_.halfedge(e, side));
        if (f != Mesh::null_face() && nearest_[f] < 0)
        {
            return true;
        }
    }

    return false;
}


FixedList<editedSurface::Vertex, 3> editedSurface::verticesOf(Face f) const
{
    FixedList<Vertex, 3> result;
    const Halfedge h = mesh_.halfedge(f);
    result[0] = mesh_.source(h);
    result[1] = mesh_.target(h);
    result[2] = mesh_.target(mesh_.next(h));

    return result;
}


FixedList<point, 3> editedSurface::pointsOf(const Face f) const
{
    FixedList<point, 3> result;
    const FixedList<Vertex, 3> vertices(verticesOf(f));
    for (label k = 0; k < 3; ++k)
    {
        result[k] = at(vertices[k]);
    }

    return result;
}


editedSurface::candidate editedSurface::triangleOf
(
    const Vertex a,
    const Vertex b,
    const Vertex c,
    const label nearest
) const
{
    candidate result;
    result.vertices[0] = a;
    result.vertices[1] = b;
    result.vertices[2] = c;
    for (label k = 0; k < 3; ++k)
    {
        result.points[k] = at(result.vertices[k]);
    }
    result.nearest = nearest;

    return result;
}


scalar editedSurface::length(const Edge e) const
{
    return mag(at(mesh_.vertex(e, 0)) - at(mesh_.vertex(e, 1)));
}


scalar editedSurface::ratio(const Edge e) const
{
    return 2*length(e)
       /(lengths[mesh_.vertex(e, 0)] + lengths[mesh_.vertex(e, 1)]);
}


scalar editedSurface::smallestAngle(const Face f) const
{
    return smallestAngleOf(pointsOf(f));
}


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


scalar editedSurface::width(const Face f) const
{
    label nLines = 0;
    scalar longest = 0;
    for (const Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(f)))
    {
        if (kinds_[mesh_.target(h)] == kind::inside)
        {
            return GREAT;
        }
        nLines += lines_[mesh_.edge(h)] >= 0;
        longest = max(longest, length(mesh_.edge(h)));
    }

    const FixedList<point, 3> x(pointsOf(f));

    return
        nLines > 1 || nearest_[f] < 0
      ? GREAT
      : mag((x[1] - x[0]) ^ (x[2] - x[0]))/longest;
}


wallSurface editedSurface::surface() const
{
    wallSurface result;
    result.patchNames = given_.surface().patchNames;
    result.patchTypes = given_.surface().patchTypes;
    setFaces(mesh_, result);
    result.patchIDs.setSize(result.faces.size());
    label n = 0;

    for (const Face f : mesh_.faces())
    {
        result.patchIDs[n++] = patches_[f];
    }

    return result;
}


edgeList editedSurface::features(const scalar maxCosine) const
{
    labelList labels(mesh_.num_vertices(), -1);
    label n = 0;
    for (const Vertex v : mesh_.vertices())
    {
        labels[v] = n++;
    }

    DynamicList<edge> result;
    for (const Edge e : mesh_.edges())
    {
        if (lines_[e] >= 0 && given_.lineCosine(lines_[e]) <= maxCosine)
        {
            const Halfedge h = mesh_.halfedge(e);
            result.append
            (
                edge(labels[mesh_.source(h)], labels[mesh_.target(h)])
            );
        }
    }

    return edgeList(std::move(result));
}


labelList editedSurface::nearestFaces() const
{
    DynamicList<label> result(mesh_.number_of_faces());
    for (const Face f : mesh_.faces())
    {
        result.append(nearest_[f]);
    }

    return labelList(std::move(result));
}


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
        given_.findFace(nearest_[f], (x[0] + x[1] + x[2])/3.0, reachOf(x), y);
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
    kinds_[v] =
        line < 0 ? kind::inside
      : isKeptLine_[line] ? kind::fixed
      : kind::onLine;
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
