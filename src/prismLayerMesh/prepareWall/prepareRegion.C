/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prepareWall.H"
#include "equalPoints.H"
#include "splitAtSidePatches.H"
#include "surfacePart.H"
#include "wallChanges.H"

namespace Foam
{

//- Gives points the coordinates that they have on a surface, where rounding has
//  moved them
static void restorePoints
(
    const equalPoints& known,
    const pointField& surface,
    pointField& points
)
{
    for (point& x : points)
    {
        if (known.find(x) < 0)
        {
            x = surface[findMin(scalarField(magSqr(surface - x)))];
        }
    }
}


wallSurface prepareRegion
(
    const spaceRegion& region,
    const prismLayerControls& controls
)
{
    wallReading untold;
    wallSurface surface(region.surface);
    mergePatches(surface);
    wallSurface wall
    (
        splitAtSidePatches
        (
            surface, controls.surface, controls.layers, untold
        )
    );

    // Side patches have moved points into their planes, which are means
    const pointField& given = region.surface.points;
    equalPoints known;
    forAll(given, p)
    {
        known.insert(given[p], p);
    }
    restorePoints(known, given, wall.points);
    for (sidePatch& side : wall.border.sides)
    {
        restorePoints(known, given, side.points);
    }
    renumberWall(wall);

    return wall;
}

} // End namespace Foam

// ************************************************************************* //
