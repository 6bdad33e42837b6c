/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "soundSurface.H"
#include "ranges.H"
#include "wallDefects.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static bool isOnAny
(
    const UList<sidePatch>& planes,
    const scalar tolerance,
    const pointField& x,
    const edge& e
)
{
    return anyOf(planes, [&](const sidePatch& plane)
    {
        return plane.hasEdge(x[e.start()], x[e.end()], tolerance);
    });
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool isBeyond
(
    const sidePatch& plane,
    const scalar tolerance,
    const wallSurface& surface
)
{
    return anyOf(surface.points, [&](const point& x)
    {
        return plane.distance(x) > tolerance;
    });
}


bool isSoundUpTo
(
    const UList<sidePatch>& planes,
    const scalar tolerance,
    const wallSurface& surface
)
{
    for (const sidePatch& plane : planes)
    {
        if (isBeyond(plane, tolerance, surface))
        {
            return false;
        }
    }

    for (const edge& e : outline(surface.faces))
    {
        if (!isOnAny(planes, tolerance, surface.points, e))
        {
            return false;
        }
    }

    return findWallDefects(surface, planes.size()).empty();
}

} // End namespace Foam

// ************************************************************************* //
