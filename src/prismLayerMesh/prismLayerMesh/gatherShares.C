/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gatherShares.H"
#include "distributeFront.H"
#include "prismQuality.H"

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


outerSurface outerOnMaster
(
    const prismLayers& own,
    const frontShare& share,
    const wallSurface& wall,
    const processTeam& processes
)
{
    if (processes.size() == 1)
    {
        const wallSurface outer(outerPolygons(own));

        return outerSurface{outer.points, outer.faces};
    }

    // The outermost layer alone
    pointField points(2*own.nColumns());
    for (label c = 0; c < own.nColumns(); ++c)
    {
        points[2*c] = own(c, own.nLayers - 1);
        points[2*c + 1] = own(c, own.nLayers);
    }
    prismLayers last;
    last.nLayers = 1;
    last.isCut = own.isCut;
    last.points = columnTeam(share, processes).columns.onMaster(points, 2);
    last.faces = gatherFront(share, wall, processes).surface.faces;
    const wallSurface outer(outerPolygons(last));

    return outerSurface{outer.points, outer.faces};
}

} // End namespace Foam

// ************************************************************************* //
