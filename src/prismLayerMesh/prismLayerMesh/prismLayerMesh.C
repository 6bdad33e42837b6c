/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismLayerMesh.H"
#include "layerStages.H"
#include "returnMemory.H"
#include "sharedFront.H"
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

    mesh.share = completeFront(context, processes, mesh.front);
    if (mesh.share)
    {
        context.visibility = wallVisibility();
    }
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

} // End namespace Foam

// ************************************************************************* //
