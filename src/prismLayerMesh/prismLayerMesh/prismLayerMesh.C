/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismLayerMesh.H"
#include "layerStages.H"
#include "returnMemory.H"
#include "stageText.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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
    const bool keepStages
)
{
    prismLayerMesh mesh;
    context.complete();
    mesh.front = makeFront(context, angle, observer);

    if (mesh.front.pointsWithoutDirection.size())
    {
        return mesh;
    }

    scalarField clearance
    (
        makeClearance(context, heights, mesh.front, controls, observer)
    );
    columnGuide guide
    (
        makeColumnGuide
        (
            context, heights, mesh.front, clearance, controls, observer,
            keepStages
        )
    );
    layerColumns columns
    (
        makeColumns(mesh.front, clearance, guide, controls.layers, observer)
    );
    const layerSpacing spacing(guide.spacing.at(mesh.front.wallPoints));
    mesh.noField = guide.noField;

    if (keepStages)
    {
        mesh.guide = std::move(guide);
        mesh.clearance = std::move(clearance);
        mesh.columns = columns;
    }
    else
    {
        guide = columnGuide();
        clearance.clear();
        context.drop();
        returnMemory();
    }

    mesh.made = makeLayers
    (
        context, heights, mesh.front, spacing, columns, controls.quality,
        observer
    );

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
    const bool keepStages
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
            context, heights, angle, controls, observer, keepStages
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

    mesh.certificate = makeCertificate(mesh.made.layers, observer);
    mesh.bounds = controls.quality;
    mesh.faces = faceQualityOfLayers
    (
        mesh.made.layers,
        layerGeometry(mesh.made.layers, mesh.front.addressing), mesh.bounds
    );
    mesh.pointKinds = context.kinds;
    mesh.heights = heights;

    if (keepStages)
    {
        mesh.addressing = std::move(context.addressing);
        mesh.visibility = std::move(context.visibility);
    }
    else
    {
        mesh.addressing = mesh.front.extraColumnPoints().empty()
          ? mesh.front.addressing : makeWallAddressing(wall);
        mesh.front.visibility = wallVisibility();
    }

    return mesh;
}

} // End namespace Foam

// ************************************************************************* //
