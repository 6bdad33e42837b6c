/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gatherShares.H"
#include "distributeFront.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

layerSpacing spacingFromMaster(layerSpacing whole, const columnTeam& team)
{
    if (team.isAlone())
    {
        return whole;
    }

    labelList nLayers(1, whole.nLayers);
    team.broadcast(nLayers);
    whole.nLayers = nLayers[0];

    return whole.mapped([&](const auto& values, const label nEach)
    {
        return team.points.fromMaster(values, nEach);
    });
}


layerSpacing spacingOnMaster(const layerSpacing& own, const shareTable& table)
{
    return own.mapped([&](const auto& values, const label nEach)
    {
        return table.onMaster(values, nEach);
    });
}


wallHeights heightsFromMaster(wallHeights whole, const columnTeam& team)
{
    return wallHeights
    {
        spacingFromMaster(std::move(whole.request), team),
        spacingFromMaster(std::move(whole.graded), team),
        team.points.fromMaster(std::move(whole.room))
    };
}


prismLayers layersOnMaster
(
    const prismLayers& own,
    const frontShare& share,
    const wallSurface& wall,
    const processTeam& processes
)
{
    prismLayers layers
    (
        layersWithoutPoints
        (
            gatherFront(share, wall, processes), own.nLayers
        )
    );
    layers.points = columnTeam(share, processes).columns.onMaster
    (
        own.points, own.nLayers + 1
    );
    layers.isCut = own.isCut;

    return layers;
}

} // End namespace Foam

// ************************************************************************* //
