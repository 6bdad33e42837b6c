/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prepareWall.H"
#include "disjointSets.H"
#include "splitAtSidePatches.H"
#include "surfacePart.H"
#include "wallChanges.H"

namespace Foam
{

//- Returns the faces of connected pieces that have a face of a wall
static bitSet facesWithWall
(
    const wallSurface& surface,
    const layerControls& layers
)
{
    disjointSets pieces
    (
        connectedPoints(surface.points.size(), surface.faces)
    );
    bitSet hasWall(surface.points.size());
    forAll(surface.faces, i)
    {
        if (!layers.isSide(surface.patchNames[surface.patchIDs[i]]))
        {
            hasWall.set(pieces.find(surface.faces[i][0]));
        }
    }

    bitSet isWith(surface.faces.size());
    forAll(surface.faces, i)
    {
        isWith.set(i, hasWall.test(pieces.find(surface.faces[i][0])));
    }

    return isWith;
}


wallSurface takeFarBoundary(const layerControls& layers, wallSurface& surface)
{
    bitSet isWith(facesWithWall(surface, layers));
    wallSurface far(surface);
    keepFaces(isWith, surface);
    isWith.flip();
    keepFaces(isWith, far);
    mergePatches(far);
    for (const word& name : far.patchNames)
    {
        const word& type = layers.entryOf(name)->type;
        far.patchTypes.append(type.empty() ? word("patch") : type);
    }

    return far;
}


//- Refuses a side patch with another region beyond it
static void requireWallsBetween
(
    const spaceRegions& all,
    const label regioni,
    const layerControls& layers
)
{
    const spaceRegion& region = all.regions[regioni];
    const wallSurface& surface = region.surface;
    forAll(region.faces, facei)
    {
        const word& patch = surface.patchNames[surface.patchIDs[facei]];
        const label other = all.beyond(regioni, facei);
        if (other >= 0 && layers.isSide(patch))
        {
            FatalErrorInFunction
                << "The patch " << patch << " is to have no layers in the"
                << " region " << region.name << ", and the region "
                << all.regions[other].name << " is beyond it, at "
                << surface.faces[facei].centre(surface.points) << nl
                << "A wall between regions has layers, or its region has none"
                << " at all (layers no)" << exit(FatalError);
        }
    }
}


regionWall prepareRegion
(
    spaceRegions& all,
    const label regioni,
    const prismLayerControls& controls
)
{
    requireWallsBetween(all, regioni, controls.layers);
    const spaceRegion& region = all.regions[regioni];
    wallReading untold;
    wallSurface surface(region.surface);
    regionWall made;
    made.far = takeFarBoundary(controls.layers, surface);
    mergePatches(surface);
    if (surface.faces.empty())
    {
        FatalErrorInFunction
            << "The region " << region.name << " has no wall: all of its"
            << " patches are to have no layers" << exit(FatalError);
    }
    wallSurface& wall = made.wall;
    wall = wallSurface
    (
        splitAtSidePatches
        (
            surface, controls.surface, controls.layers, untold
        )
    );

    all.settle(regioni, wall.points);
    for (sidePatch& side : wall.border.sides)
    {
        all.settle(regioni, side.points);
    }
    renumberWall(wall);

    return made;
}

} // End namespace Foam

// ************************************************************************* //
