/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sharedFront.H"
#include "returnMemory.H"
#include "sharedPiece.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The share of this process in a front
static std::shared_ptr<const frontShare> shareOf
(
    const wallContext& context,
    const layerFront& front,
    const processTeam& processes
)
{
    const label n = processes.size();

    return std::make_shared<const frontShare>
    (
        makeFrontShare
        (
            front,
            front.isBare() ? context.addressing : front.addressing,
            front.isBare() ? context.visibility : front.visibility,
            ownersByRange(context.wall.points.size(), n), n, processes.rank()
        )
    );
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

std::shared_ptr<const frontShare> completeFront
(
    const wallContext& context,
    const processTeam* processes,
    layerFront& front
)
{
    std::shared_ptr<const frontShare> share;
    if (processes)
    {
        share = shareOf(context, front, *processes);
        wallVisibility axes;
        axes.cones =
            front.isBare() ? context.visibility.cones : front.visibility.cones;
        front.visibility = std::move(axes);
        front.addressing = wallAddressing();
        returnMemory();
    }
    else
    {
        front.complete(context.addressing, context.visibility);
    }

    return share;
}


prismLayers gatherLayers
(
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
        layers = wholeLayers(front, nLayers);
        layers.points = all;
    }

    return layers;
}

} // End namespace Foam

// ************************************************************************* //
