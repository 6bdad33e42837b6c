/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismLayerMesh.H"
#include "distributeFront.H"
#include "layerStages.H"
#include "returnMemory.H"
#include "stageText.H"
#include "wallPartsInBoxes.H"

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
static void dropStages(const guidedColumns& columns, prismLayerMesh& mesh)
{
    mesh.guide = columnGuide();
    mesh.clearance.clear();
    columns.context.drop();
    if (columns.whole && !columns.team.isAlone())
    {
        columns.whole->context.drop();
        columns.whole->heights = wallHeights();
        mesh.front.visibility = wallVisibility();
    }
    returnMemory();
}


//- The layers of the columns of this process, until they are certified, unless
//  points have no layers
static void makeLayersOnColumns
(
    const guidedColumns& columns,
    const prismLayerControls& controls,
    const stageObserver& observer,
    const bool keepStages,
    prismLayerMesh& mesh
)
{
    mesh.clearance = makeClearance(columns, controls, observer);
    mesh.guide = makeColumnGuide
    (
        columns, mesh.clearance, controls, observer, keepStages
    );
    layerColumns made
    (
        makeColumns
        (
            columns, mesh.clearance, mesh.guide, controls.layers, observer
        )
    );
    const layerSpacing spacing
    (
        mesh.guide.spacing.at(columns.own.wallPoints)
    );
    mesh.noField = mesh.guide.noField;

    mesh.columns = keepStages ? made : layerColumns();
    if (!keepStages)
    {
        dropStages(columns, mesh);
    }

    mesh.made =
        makeLayers(columns, spacing, made, controls.quality, observer);
    if (mesh.made.certified.pointsWithoutHeight.empty())
    {
        certifyMesh(columns, controls.quality, observer, mesh);
    }
}


//- The processes of points. Columns near edges take more time than others.
static pointOwners ownersOf
(
    const List<pointKind>& kinds,
    const processTeam& processes
)
{
    boolList isOnEdge(kinds.size());
    forAll(kinds, p)
    {
        isOnEdge[p] = kinds[p] != pointKind::flat;
    }

    return balancedOwners(isOnEdge, processes.size());
}


//- Drops what the shares of a front have. The surface of a bare front is the
//  surface of the wall.
static void keepColumnsOnly(layerFront& front)
{
    wallVisibility cones;
    cones.cones = front.visibility.cones;
    if (front.isBare())
    {
        front.surface = wallSurface();
    }
    front.visibility = std::move(cones);
    front.addressing = wallAddressing();
}


//- As makeLayersOnColumns, on the share of this process. Collective
static void makeLayersOnShare
(
    wholeWall* whole,
    const prismLayerControls& controls,
    const stageObserver& observer,
    const processTeam& processes,
    prismLayerMesh& mesh
)
{
    pointOwners owners;
    if (whole)
    {
        owners = ownersOf(whole->context.kinds, processes);
        whole->context.drop();
        returnMemory();
    }
    mesh.share = distributeFront(mesh.front, owners, processes);
    if (whole)
    {
        keepColumnsOnly(mesh.front);
    }
    returnMemory();

    const columnTeam team(mesh.share.get(), &processes);
    const layerFront& own = mesh.share->front;
    const wallSurface wall(wallOfFront(own));
    const List<pointKind> noKinds;
    const scalarField noCurvature;
    const wallHeights noHeights;
    wallContext context
    (
        wall,
        team.pointsFromMaster(whole ? whole->context.kinds : noKinds),
        scalarField
        (
            team.pointsFromMaster
            (
                whole ? whole->context.curvature : noCurvature
            )
        )
    );
    mesh.heights = heightsOnShare(whole ? whole->heights : noHeights, team);
    makeLayersOnColumns
    (
        guidedColumns{own, team, context, mesh.heights, whole, mesh.front},
        controls, observer, false, mesh
    );
}


//- The mesh on a front with multiple normals at angles below one [deg], as far
//  as layers are possible there. Collective.
//  whole: null on a process that is not the master
static prismLayerMesh makeLayersOnFront
(
    wholeWall* whole,
    const scalar angle,
    const prismLayerControls& controls,
    const localHeights& local,
    const stageObserver& observer,
    const bool keepStages,
    const processTeam* processes
)
{
    prismLayerMesh mesh;
    if (whole)
    {
        whole->context.complete();
        if (whole->heights.request.nLayers == 0)
        {
            whole->heights =
                makeHeights(whole->context, controls.layers, local, observer);
        }
        mesh.front = makeFront(whole->context, angle, observer);
    }
    if (processes)
    {
        processes->broadcast(mesh.front.pointsWithoutDirection);
    }

    if (mesh.front.pointsWithoutDirection.size())
    {
        return mesh;
    }

    if (processes)
    {
        makeLayersOnShare(whole, controls, observer, *processes, mesh);
        return mesh;
    }

    wallContext& context = whole->context;
    mesh.front.complete(context.addressing, context.visibility);
    makeLayersOnColumns
    (
        guidedColumns
        {
            mesh.front, columnTeam::alone(), context, whole->heights, whole,
            mesh.front
        },
        controls, observer, keepStages, mesh
    );

    return mesh;
}


static bool hasLayers(const prismLayerMesh& mesh)
{
    return mesh.front.pointsWithoutDirection.empty()
        && mesh.made.certified.pointsWithoutHeight.empty();
}


//- What the only process keeps of the wall
static void takeFromWall
(
    wholeWall& whole,
    const bool keepStages,
    prismLayerMesh& mesh
)
{
    wallContext& context = whole.context;
    mesh.heights = std::move(whole.heights);
    if (keepStages)
    {
        mesh.addressing = std::move(context.addressing);
        mesh.visibility = std::move(context.visibility);
    }
    else
    {
        mesh.addressing = mesh.front.extraColumnPoints().empty()
          ? mesh.front.addressing : makeWallAddressing(context.wall);
        mesh.front.visibility = wallVisibility();
    }
}


//- Throws the error of points without layers. Processes that are not the master
//  do not know where these points are: they get the error of the master.
static void endWithoutLayers
(
    wholeWall* whole,
    const prismLayerMesh& mesh,
    const processTeam* processes
)
{
    if (!whole)
    {
        processes->any(false);
        return;
    }
    whole->context.complete();

    throw errorOfPoints
    (
        whole->context, mesh.front, mesh.made.certified
    );
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
    autoPtr<wholeWall> whole;
    if (!processes || processes->isMaster())
    {
        observer.begin("wallVisibility");
        whole.reset(new wholeWall(wall));
        observer.end(sizesOf(whole->context.kinds));
    }
    const auto makeMesh = [&](const scalar angle)
    {
        return makeLayersOnFront
        (
            whole.get(), angle, controls, local, observer, keepStages,
            processes
        );
    };

    prismLayerMesh mesh(makeMesh(controls.layers.multipleNormalsAngle));
    if (!hasLayers(mesh) && controls.layers.multipleNormalsAngle > 0)
    {
        mesh = prismLayerMesh();
        mesh = makeMesh(0);
    }
    if (!hasLayers(mesh))
    {
        endWithoutLayers(whole.get(), mesh, processes);
    }
    if (whole)
    {
        mesh.pointKinds = whole->context.kinds;
    }
    if (!processes)
    {
        takeFromWall(whole(), keepStages, mesh);
    }

    return mesh;
}

} // End namespace Foam

// ************************************************************************* //
