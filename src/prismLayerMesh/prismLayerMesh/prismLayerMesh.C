/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismLayerMesh.H"
#include "layerStages.H"
#include "returnMemory.H"
#include "sharedPiece.H"
#include "stageText.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Certifies the layers, and counts the faces beyond the bounds
static void certifyMesh
(
    const guidedColumns& front,
    const qualityControls& bounds,
    const stageObserver& observer,
    prismLayerMesh& mesh
)
{
    const prismLayers& layers = mesh.made.layers;
    mesh.certificate = makeCertificate(layers, front.team, observer);
    mesh.bounds = bounds;
    mesh.faces = faceQualityOfLayers
    (
        layers, layerGeometry(layers, front.own.addressing), bounds, front.team
    );
}


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


//- Completes a front that may be bare. In a team the share has all that is
//  around its columns, and the whole front the axes of the columns alone.
static void complete
(
    const wallContext& context,
    const processTeam* processes,
    prismLayerMesh& mesh
)
{
    layerFront& front = mesh.front;
    if (processes)
    {
        mesh.share = shareOf(context, front, *processes);
        wallVisibility axes;
        axes.cones =
            front.isBare() ? context.visibility.cones : front.visibility.cones;
        front.visibility = std::move(axes);
        front.addressing = wallAddressing();
        returnMemory();
    }
    else if (front.isBare())
    {
        front.addressing = context.addressing;
        front.visibility = context.visibility;
    }
}


//- Drops what the layers do not need
static void dropStages(wallContext& context, prismLayerMesh& mesh)
{
    mesh.guide = columnGuide();
    mesh.clearance.clear();
    context.drop();
    if (mesh.share)
    {
        mesh.front.visibility = wallVisibility();
    }
    returnMemory();
}


//- The mesh on a front with multiple normals at angles below one [deg], as far
//  as layers are possible there. Unless the stages are kept, the context is
//  dropped on the way.
static prismLayerMesh makeLayersOnFront
(
    wallContext& context,
    const wallHeights& heights,
    const scalar angle,
    const prismLayerControls& controls,
    const stageObserver& observer,
    const bool keepStages,
    const processTeam* processes
)
{
    prismLayerMesh mesh;
    context.complete();
    mesh.front = makeFront(context, angle, observer);

    if (mesh.front.pointsWithoutDirection.size())
    {
        return mesh;
    }

    complete(context, processes, mesh);
    const columnTeam team(mesh.share.get(), processes);
    const guidedColumns front
    {
        mesh.front, processes ? mesh.share->front : mesh.front, team
    };
    mesh.clearance = makeClearance(context, heights, front, controls, observer);
    mesh.guide = makeColumnGuide
    (
        context, heights, front, mesh.clearance, controls, observer, keepStages
    );
    layerColumns columns
    (
        makeColumns
        (
            front, mesh.clearance, mesh.guide, controls.layers, observer
        )
    );
    const layerSpacing spacing(mesh.guide.spacing.at(front.wallPoints()));
    mesh.noField = mesh.guide.noField;

    mesh.columns = keepStages ? columns : layerColumns();
    if (!keepStages)
    {
        dropStages(context, mesh);
    }

    mesh.made = makeLayers
    (
        context, heights, front, spacing, columns, controls.quality, observer
    );
    if (mesh.made.certified.pointsWithoutHeight.empty())
    {
        certifyMesh(front, controls.quality, observer, mesh);
    }

    return mesh;
}


static bool hasLayers(const prismLayerMesh& mesh)
{
    return mesh.front.pointsWithoutDirection.empty()
        && mesh.made.certified.pointsWithoutHeight.empty();
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

prismLayerMesh makePrismLayerMesh
(
    const wallSurface& wall,
    const prismLayerControls& controls,
    const localHeights& local,
    const stageObserver& observer,
    const bool keepStages,
    const processTeam* processes
)
{
    observer.begin("wallVisibility");
    wallContext context(wall);
    observer.end(sizesOf(context.kinds));

    const wallHeights heights
    (
        makeHeights(context, controls.layers, local, observer)
    );
    const auto makeMesh = [&](const scalar angle)
    {
        return makeLayersOnFront
        (
            context, heights, angle, controls, observer, keepStages, processes
        );
    };

    prismLayerMesh mesh(makeMesh(controls.layers.multipleNormalsAngle));
    if (!hasLayers(mesh) && controls.layers.multipleNormalsAngle > 0)
    {
        mesh = makeMesh(0);
    }
    if (!hasLayers(mesh))
    {
        context.complete();
        throw errorOfPoints(context, mesh.front, mesh.made.certified);
    }

    mesh.pointKinds = context.kinds;
    mesh.heights = heights;

    if (keepStages)
    {
        mesh.addressing = std::move(context.addressing);
        mesh.visibility = std::move(context.visibility);
    }
    else if (!processes)
    {
        mesh.addressing = mesh.front.extraColumnPoints().empty()
          ? mesh.front.addressing : makeWallAddressing(wall);
        mesh.front.visibility = wallVisibility();
    }

    return mesh;
}


prismLayers gatherLayers(const prismLayerMesh& mesh, const columnTeam& team)
{
    const prismLayers& own = mesh.made.layers;

    return gatherLayers(mesh.front, own.points, own.nLayers, team);
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
