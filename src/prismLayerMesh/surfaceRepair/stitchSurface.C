/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stitchSurface.H"
#include "ranges.H"
#include "readWallSurface.H"
#include "unions.H"
#include "wallDefects.H"

namespace Foam
{

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


// * * * * * * * * * * * * * *  Stitch Surface * * * * * * * * * * * * * * * //

static void refuseBodies(const string& why)
{
    FatalErrorInFunction
        << "The bodies of the surface cannot be united: " << why.c_str() << nl
        << "Unite them in CAD, or go around them with surface.repair wrap"
        << exit(FatalError);
}


//- Replaces a surface by the exact union of the bodies of another one, if the
//  latter is balanced and the union comes to its end. Returns whether it did.
//  unitedSteps: the steps that made the other surface
static bool takeExactUnion
(
    wallSurface united,
    repairSteps unitedSteps,
    const scalar gap,
    wallSurface& surface,
    repairSteps& steps
)
{
    mergeEqualPoints(united, unitedSteps);

    if (!isBalanced(united) || !uniteBalanced(united, gap, unitedSteps).empty())
    {
        return false;
    }
    surface = united;
    steps = unitedSteps;
    orientWallSurface(surface, true);

    return true;
}


void stitchSurface
(
    const stitchControls& controls,
    wallSurface& surface,
    repairSteps& steps
)
{
    const scalar gap = controls.gap;
    const wallSurface given(surface);
    const auto isSound = [&]()
    {
        return isSoundUpTo(controls.planes, controls.tolerance, surface);
    };

    stitchFaces(surface, steps);
    orientWallSurface(surface, true);

    if (!isSound())
    {
        closeGaps
        (
            surface, gap, controls.hole, controls.planes, controls.tolerance,
            steps
        );
        orientWallSurface(surface, true);
    }
    if (isSound())
    {
        return;
    }

    const wallSurface closed(surface);
    const repairSteps closedSteps(steps);
    const string failure =
        uniteBodies(surface, controls.fluidOutside, gap, steps);

    if (failure.empty() && (isSound() || !controls.fluidOutside))
    {
        return;
    }

    const bool isUnited =
        controls.fluidOutside
     && (
            takeExactUnion(given, repairSteps(), gap, surface, steps)
         || takeExactUnion(closed, closedSteps, gap, surface, steps)
        );
    if (!isUnited && !failure.empty())
    {
        refuseBodies(failure);
    }
}

} // End namespace Foam

// ************************************************************************* //
