/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "soundSurface.H"
#include "wallDefects.H"

#include <algorithm>

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
    return std::any_of
    (
        planes.begin(), planes.end(), [&](const sidePatch& plane)
        {
            return plane.hasEdge(x[e.start()], x[e.end()], tolerance);
        }
    );
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool isBeyond
(
    const sidePatch& plane,
    const scalar tolerance,
    const wallSurface& surface
)
{
    return std::any_of
    (
        surface.points.begin(), surface.points.end(),
        [&](const point& x) { return plane.distance(x) > tolerance; }
    );
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
