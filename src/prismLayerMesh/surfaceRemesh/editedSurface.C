/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "editedSurface.H"
#include "cgalMeshes.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void editedSurface::fill()
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
            given_.isCorner(v) ? kind::fixed
          : given_.isOnLine(v) ? kind::onLine
          : kind::inside;
    }

    forAll(given_.lines(), l)
    {
        const edge& e = given_.lines()[l];
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

editedSurface::editedSurface(const givenSurface& given, const bool guarded)
:
    given_(given),
    journal_(mesh_)
{
    lengths = mesh_.add_property_map<Vertex, scalar>("v:length", GREAT).first;
    kinds_ = mesh_.add_property_map<Vertex, kind>("v:kind").first;
    lines_ = mesh_.add_property_map<Edge, label>("e:line", -1).first;
    nearest_ = mesh_.add_property_map<Face, label>("f:nearest", -1).first;
    patches_ = mesh_.add_property_map<Face, label>("f:patch", 0).first;
    fill();

    guard_.reset(guarded ? new changeGuard(mesh_) : nullptr);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool editedSurface::isKept(const Edge e) const
{
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

} // End namespace Foam

// ************************************************************************* //
