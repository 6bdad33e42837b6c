/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// From CGAL
#include <CGAL/boost/graph/graph_traits_Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>

#include "changeJournal.H"

namespace Foam
{

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
