/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// From CGAL
#include <CGAL/boost/graph/graph_traits_Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>

#include "changeGuard.H"

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

} // End namespace Foam

// ************************************************************************* //
