/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// From CGAL
#include <CGAL/boost/graph/Euler_operations.h>

#include "editedSurface.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool editedSurface::flip(const Edge e)
{
    const Halfedge h = mesh_.halfedge(e);
    const Halfedge back = mesh_.opposite(h);
    if (lines_[e] >= 0 || isKept(e) || mesh_.is_border(e) || isAsBefore(e))
    {
        return false;
    }
    notFlipped_[e] = nChanges_;

    const Vertex a = mesh_.source(h);
    const Vertex b = mesh_.target(h);
    const Vertex c = mesh_.target(mesh_.next(h));
    const Vertex d = mesh_.target(mesh_.next(back));
    candidate first(triangleOf(a, d, c, nearest_[mesh_.face(h)]));
    candidate second(triangleOf(b, c, d, nearest_[mesh_.face(back)]));
    const scalar before =
        min(smallestAngle(mesh_.face(h)), smallestAngle(mesh_.face(back)));
    const scalar after =
        min(smallestAngleOf(first.points), smallestAngleOf(second.points));
    if
    (
        after < before + 1e-6
     || mesh_.halfedge(c, d) != Mesh::null_halfedge()
     || !isNear(first) || !isNear(second)
     || !isNear(at(c), at(d), first.nearest)
     || (guard_ && !guard_->mayFlip(h))
    )
    {
        return false;
    }

    if (guard_) guard_->leaveBeside(h);
    CGAL::Euler::flip_edge(h, mesh_);
    if (guard_) guard_->enterBeside(h);
    ++nChanges_;
    for (const Vertex v : {a, b, c, d})
    {
        changed_[v] = nChanges_;
    }
    for (const Halfedge side : {h, back})
    {
        const Face f = mesh_.face(side);
        const Vertex w = mesh_.target(mesh_.next(side));
        nearest_[f] = (w == a ? first : second).nearest;
    }

    return true;
}

} // End namespace Foam

// ************************************************************************* //
