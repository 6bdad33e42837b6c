/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismLayerMesh.H"
#include "layerStages.H"
#include "returnMemory.H"
#include "stageText.H"

#include <memory>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A front, and what this process makes of it
struct dividedFront
{
    const layerFront& whole;
    const std::unique_ptr<const frontShare> share;
    const columnTeam team;

    dividedFront(const layerFront& front, const processTeam* processes)
    :
        whole(front),
        share
        (
            processes
          ? new frontShare
            (
                makeFrontShare
                (
                    front,
                    ownersByRange(max(front.wallPoints) + 1, processes->size()),
                    processes->size(), processes->rank()
                )
            )
          : nullptr
        ),
        team(share ? columnTeam(*share, *processes) : columnTeam())
    {}

    guidedColumns columns() const
    {
        return guidedColumns{whole, share ? share->front : whole, team};
    }
};


//- On the master the layers of all processes, in place of those of its share
static void gatherLayers
(
    const dividedFront& front,
    madeLayers& made,
    layerCertificate& certificate
)
{
    const columnTeam& team = front.team;
    if (team.isAlone())
    {
        return;
    }

    prismLayers& layers = made.layers;
    const faceList own(layers.faces);
    layers.points = team.onMaster(layers.points, layers.nLayers + 1);
    made.thickness = team.onMaster(made.thickness);
    made.causes = team.onMaster(made.causes);
    certificate.worstJacobian =
        team.facesOnMaster(certificate.worstJacobian, own);
    for (label& facei : certificate.outlyingCentres)
    {
        facei = team.wholeFace(facei);
    }
    certificate.outlyingCentres = team.gather(certificate.outlyingCentres);
    sort(certificate.outlyingCentres);

    const wallSurface& surface = front.whole.surface;
    layers.faces = surface.faces;
    layers.patchIDs =
        SubList<label>(surface.patchIDs, front.whole.nWallFaces);
    layers.border = surface.border;
    layers.extraColumnPoints = front.whole.extraColumnPoints();
}


//- Certifies the layers of all processes, and gathers them on the master
static void certifyAll
(
    const dividedFront& front,
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
        layers, layerGeometry(layers, front.columns().own.addressing), bounds,
        front.team
    );
    gatherLayers(front, mesh.made, mesh.certificate);
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

    const dividedFront divided(mesh.front, processes);
    const guidedColumns front(divided.columns());
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

    if (keepStages)
    {
        mesh.columns = columns;
    }
    else
    {
        mesh.guide = columnGuide();
        mesh.clearance.clear();
        context.drop();
        returnMemory();
    }

    mesh.made = makeLayers
    (
        context, heights, front, spacing, columns, controls.quality, observer
    );
    if (mesh.made.certified.pointsWithoutHeight.empty())
    {
        certifyAll(divided, controls.quality, observer, mesh);
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
