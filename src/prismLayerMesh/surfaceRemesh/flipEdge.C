/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceChanges.H"
#include "nearGiven.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool flipEdge(editedSurface& surface, const editedSurface::Edge e)
{
    typedef editedSurface::Vertex Vertex;
    const editedSurface::Mesh& mesh = surface.mesh();
    if
    (
        surface.line(e) >= 0 || surface.isKept(e) || mesh.is_border(e)
     || !surface.journal().isNew(e)
    )
    {
        return false;
    }

    const auto h = mesh.halfedge(e);
    const auto back = mesh.opposite(h);
    const Vertex a = mesh.source(h);
    const Vertex b = mesh.target(h);
    const Vertex c = mesh.target(mesh.next(h));
    const Vertex d = mesh.target(mesh.next(back));
    const auto f = mesh.face(h);
    const auto g = mesh.face(back);
    auto first(surface.triangleOf(a, d, c, surface.nearest(f)));
    auto second(surface.triangleOf(b, c, d, surface.nearest(g)));
    const scalar before =
        min(surface.smallestAngle(f), surface.smallestAngle(g));
    const scalar after =
        min(smallestAngleOf(first.points), smallestAngleOf(second.points));
    const givenSurface& given = surface.given();
    if
    (
        after < before + 1e-6
     || mesh.halfedge(c, d).is_valid()
     || !isNear(given, first.points, first.nearest)
     || !isNear(given, second.points, second.nearest)
     || !isNear(given, surface.at(c), surface.at(d), first.nearest)
     || (surface.guard() && !surface.guard()->mayFlip(h))
    )
    {
        return false;
    }
    surface.flip(h, first, second);

    return true;
}

} // End namespace Foam

// ************************************************************************* //
