/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wholeWall.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The layers of all processes without their points
static prismLayers layersOn
(
    const wallSurface& surface,
    const layerFront& front,
    const label nLayers
)
{
    prismLayers layers;
    layers.nLayers = nLayers;
    layers.extraColumnPoints = front.extraColumnPoints();
    layers.faces = surface.faces;
    layers.patchIDs = SubList<label>(surface.patchIDs, front.nWallFaces);
    layers.patchNames = surface.patchNames;
    layers.patchTypes = surface.patchTypes;
    layers.border = surface.border;

    return layers;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

layerSpacing spacingOnShare(const layerSpacing& whole, const columnTeam& team)
{
    labelList numbers({whole.nLayers, label(whole.given.size() > 0)});
    team.broadcast(numbers);

    layerSpacing own;
    own.nLayers = numbers[0];
    own.firstThickness = team.pointsFromMaster(whole.firstThickness);
    own.ratio = team.pointsFromMaster(whole.ratio);
    own.thickness = team.pointsFromMaster(whole.thickness);
    own.layersAsked = team.pointsFromMaster(whole.layersAsked);
    if (numbers[1])
    {
        own.given = team.pointsFromMaster(whole.given, own.nLayers);
    }

    return own;
}


wallHeights heightsOnShare(const wallHeights& whole, const columnTeam& team)
{
    return wallHeights
    {
        spacingOnShare(whole.request, team),
        spacingOnShare(whole.graded, team),
        scalarField(team.pointsFromMaster(whole.room))
    };
}


const wallSurface& surfaceOfFront
(
    const wallSurface& wall,
    const layerFront& front
)
{
    return front.surface.faces.empty() ? wall : front.surface;
}


prismLayers gatherLayers
(
    const wallSurface& wall,
    const layerFront& front,
    const pointField& points,
    const label nLayers,
    const columnTeam& team
)
{
    const pointField all(team.onMaster(points, nLayers + 1));
    prismLayers layers;
    if (team.isMaster())
    {
        layers = layersOn(surfaceOfFront(wall, front), front, nLayers);
        layers.points = all;
    }

    return layers;
}

} // End namespace Foam

// ************************************************************************* //
