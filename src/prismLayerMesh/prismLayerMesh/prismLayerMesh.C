/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismLayerMesh.H"
#include "layerStages.H"
#include "periodicShare.H"
#include "periodicStages.H"
#include "returnMemory.H"
#include "wallPointsError.H"

#include <optional>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- All stages, see makePrismLayerMesh
struct pipeline
{
    const wallSurface& wall;
    const prismLayerControls& controls;
    const localHeights& local;
    const stageObserver& observer;
    const bool keepStages;
    const processTeam& processes;

    //- The wall with its images, if it ends on cyclic side patches; 'wall' is
    //  their surface then
    const wallSurface& given;
    const std::optional<periodicWall>& images;


    shareOfWall makeShareWith(const multipleNormals& normals) const
    {
        return makeShare
        (
            wall, controls.layers, normals, local, observer, processes
        );
    }


    //- Whether constrain refuses columns of a front: the columns of a sharp
    //  point on a cyclic side cannot all stand in its plane
    bool isRefused(layerFront whole) const
    {
        return constrainToCyclicSides(given, *images, whole).size()
            || pointsWithOtherColumns(*images, whole).size();
    }


    //- The front on the images of a wall with cyclic sides. If its columns are
    //  refused, there is one column at each point on a cyclic side, and then at
    //  each point if need be
    shareOfWall makeShareOfImages(const scalar angle) const
    {
        shareOfWall made(makeShareWith({angle}));
        if (angle > 0 && isRefused(made.share.front))
        {
            made = makeShareWith({angle, images->pointsOnSides(given)});
        }
        if (angle > 0 && isRefused(made.share.front))
        {
            made = makeShareWith({0});
        }

        return made;
    }


    //- Constrains columns to cyclic sides. Refuses points without a direction,
    //  and points that have other columns than their images
    void constrain(layerFront& whole) const
    {
        const auto refuse = [&](const labelList& points, const char* why)
        {
            if (points.size())
            {
                throw wallPointsError(given, points, why);
            }
        };
        refuse
        (
            constrainToCyclicSides(given, *images, whole),
            "have no direction in the plane of their cyclic side patch from"
            " which all their faces are visible"
        );
        refuse
        (
            pointsWithOtherColumns(*images, whole),
            "have other columns than their images beyond a cyclic side patch"
        );
    }


    //- From the wall to columns
    plannedColumns plan(const scalar angle, prismLayerMesh& mesh) const
    {
        shareOfWall start
        (
            images ? makeShareOfImages(angle) : makeShareWith({angle})
        );
        mesh.share = std::move(start.share);
        mesh.pointKinds = std::move(start.kinds);
        if (images)
        {
            constrain(mesh.share.front);
        }
        const layerFront& front = mesh.share.front;
        const columnTeam team(mesh.share, processes);
        const wallUnderShare under(front, mesh.pointKinds, start.curvature);
        const guidedColumns guided{wall, team, front, under, start.heights};

        scalarField clearance(makeClearance(guided, controls, observer));
        columnGuide guide
        (
            makeColumnGuide(guided, clearance, controls, observer, keepStages)
        );
        plannedColumns planned
        {
            makeColumns(guided, clearance, guide, controls.layers, observer),
            guide.spacing.at(front.wallPoints)
        };

        mesh.request = std::move(start.heights.request);
        mesh.noField = guide.noField;
        if (keepStages)
        {
            mesh.addressing = makeWallAddressing(given);
            mesh.visibility = makeWallVisibility(given, mesh.addressing);
            mesh.clearance = std::move(clearance);
            mesh.guide = std::move(guide);
            mesh.columns = planned.columns;
        }

        return planned;
    }


    void makeLayersOn
    (
        const plannedColumns& planned,
        prismLayerMesh& mesh
    ) const
    {
        if (images)
        {
            makePeriodicLayers
            (
                given, *images, planned, controls, observer, mesh
            );
            return;
        }
        mesh.made = makeLayers
        (
            mesh.share.front, mesh.pointKinds, mesh.request, planned.spacing,
            planned.columns, controls, columnTeam(mesh.share, processes),
            observer
        );
    }


    //- The mesh with multiple normals at angles below one [deg]. If points have
    //  no layers, made.certified names them.
    prismLayerMesh make(const scalar angle) const
    {
        prismLayerMesh mesh;
        {
            const plannedColumns planned(plan(angle, mesh));
            returnMemory();
            makeLayersOn(planned, mesh);
        }
        if (mesh.made.certified.pointsWithoutHeight.size())
        {
            return mesh;
        }

        const columnTeam team(mesh.share, processes);
        const prismLayers& layers = mesh.made.layers;
        mesh.certificate = makeCertificate(layers, team, observer);
        mesh.bounds = controls.quality;
        mesh.faces = faceQualityOfLayers
        (
            layers, layerGeometry(layers, mesh.share.front.addressing),
            mesh.bounds, team
        );

        return mesh;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

prismLayerMesh makePrismLayerMesh
(
    const wallSurface& wall,
    const prismLayerControls& controls,
    const localHeights& local,
    const stageObserver& observer,
    const bool keepStages,
    const processTeam& processes
)
{
    const List<sidePatch>& sides = wall.border.sides;
    const bool isPeriodic = pairsOf(sides).size() && processes.size() == 1;
    std::optional<periodicWall> images;
    if (isPeriodic)
    {
        // At places of the given wall, not of an image
        checkSidesOf(wall, makeWallAddressing(wall));
        observer.begin("periodicWall");
        images.emplace(wall);
        observer.end(text(images->surface.faces.size(), " faces with images"));
    }
    const prismLayerControls& onImages = withImages
    (
        controls, sides, isPeriodic ? images->surface.border.sides : sides
    );
    const localHeights ofImages
    (
        isPeriodic ? withImages(local, *images) : localHeights()
    );
    const pipeline stages
    {
        isPeriodic ? images->surface : wall, onImages,
        isPeriodic ? ofImages : local, observer,
        keepStages && processes.size() == 1, processes, wall, images
    };
    const scalar angle = controls.layers.multipleNormalsAngle;

    prismLayerMesh mesh(stages.make(angle));
    if (mesh.made.certified.pointsWithoutHeight.size() && angle > 0)
    {
        mesh = prismLayerMesh();
        mesh = stages.make(0);
    }
    requireHeights(wall, mesh.made.certified, processes);

    return mesh;
}

} // End namespace Foam

// ************************************************************************* //
