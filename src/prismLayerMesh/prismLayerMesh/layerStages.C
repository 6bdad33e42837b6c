/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerStages.H"
#include "boxSides.H"
#include "distributeFront.H"
#include "expectedYPlus.H"
#include "levelSets.H"
#include "makePrismLayers.H"
#include "OStringStream.H"
#include "planarColumns.H"
#include "returnMemory.H"
#include "sidePair.H"
#include "stageText.H"
#include "unitConversion.H"
#include "wallClearance.H"
#include "wallPointsError.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The heights that controls and local ask for
static wallHeights heightsOf
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const layerControls& controls,
    const localHeights& local,
    const stageObserver& observer
)
{
    observer.begin("layerSpacing");
    wallHeights heights;
    heights.request = makeLayerSpacing(wall, addressing, controls, local);
    requireCountable(addressing.edges.size(), heights.request.nLayers);
    heights.graded =
        gradedSpacing(heights.request, addressing, controls.transitionRatio);
    heights.room = controls.onLevelSets
      ? uniformSpacing(heights.graded).thickness : heights.graded.thickness;
    observer.end
    (
        text(heights.request.nLayers, " layers\n",
            describe(heights.request, wall, controls).c_str(),
            describeExpected
            (
                wall, heights.graded.firstThickness, local.yPlusPerHeight,
                controls.fromRun.target
            ).c_str())
    );

    return heights;
}


//- The bare front with multiple normals
static layerFront frontOf
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const multipleNormals& normals,
    const stageObserver& observer
)
{
    observer.begin("layerFront");
    layerFront front
    (
        makeBareFront
        (
            wall, addressing, visibility, degToRad(normals.angle),
            normals.single
        )
    );
    observer.end(sizesOf(front));

    return front;
}


//- As makeShare, of all of the wall. The front is bare if several processes
//  share it.
static shareOfWall makeWhole
(
    const wallSurface& wall,
    const layerControls& controls,
    const multipleNormals& normals,
    const localHeights& local,
    const stageObserver& observer,
    const bool isShared
)
{
    observer.begin("wallVisibility");
    wallAddressing addressing(makeWallAddressing(wall));
    if
    (
        isShared
     && (
            emptySides(wall.border).first() >= 0
         || pairsOf(wall.border.sides).size()
        )
    )
    {
        FatalErrorInFunction
            << "-parallel allows neither two dimensions nor cyclic sides. Run"
            << " in serial, then decomposePar" << exit(FatalError);
    }
    checkSidesOf(wall, addressing);
    wallVisibility visibility(makeWallVisibility(wall, addressing));
    shareOfWall whole;
    whole.kinds = kindsOfPoints(wall, addressing, visibility);
    observer.end(sizesOf(whole.kinds));

    whole.heights = heightsOf(wall, addressing, controls, local, observer);
    whole.curvature = inwardCurvature
    (
        wall, addressing, visibility, whole.kinds, whole.heights.room
    );

    layerFront& front = whole.share.front;
    front = frontOf(wall, addressing, visibility, normals, observer);
    if (front.pointsWithoutDirection.size() && normals.angle > 0)
    {
        front = frontOf(wall, addressing, visibility, {0}, observer);
    }
    if (front.pointsWithoutDirection.size())
    {
        throw wallPointsError
        (
            wall, front.pointsWithoutDirection,
            "have no direction from which all their faces are visible, even "
            "with multiple normals",
            adviceOnPoints(wall, addressing, front.pointsWithoutDirection)
        );
    }
    if (!isShared)
    {
        front.complete(std::move(addressing), std::move(visibility));
    }

    return whole;
}


//- The room in front of the columns that this process makes. In a team the
//  search has the part of the wall that the balls may meet, in mirrors too.
static scalarField clearanceOf
(
    const guidedColumns& columns,
    const scalarField& reach,
    const scalar maxStretch
)
{
    const layerFront& front = columns.own;
    const auto clearanceBy = [&](const wallSearch& search)
    {
        return makeWallClearance
        (
            front.surface, search, front.visibility, reach, maxStretch
        );
    };

    if (columns.team.isAlone())
    {
        return clearanceBy(wallSearch(columns.wholeWall));
    }

    // A ball is up to maxStretch reaches away, and one reach wide; in a mirror
    // it is two more reaches away
    const bool hasMirrors = front.surface.border.sides.size();
    const scalar farthest = (maxStretch + (hasMirrors ? 3 : 1))*max(reach);

    // Collective, also if a process has no columns
    const surfacePart near
    (
        wallPartInBoxes
        (
            front, columns.team, boxesAround(front.surface.points, farthest)
        )
    );

    return reach.empty() ? reach : clearanceBy(wallSearch(near.surface));
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

shareOfWall makeShare
(
    const wallSurface& wall,
    const layerControls& controls,
    const multipleNormals& normals,
    const localHeights& local,
    const stageObserver& observer,
    const processTeam& processes
)
{
    shareOfWall whole
    (
        processes.onMaster([&]()
        {
            return makeWhole
            (
                wall, controls, normals, local, observer,
                processes.size() > 1
            );
        })
    );
    returnMemory();

    shareOfWall own;
    own.share = shareOf(std::move(whole.share.front), whole.kinds, processes);
    const columnTeam team(own.share, processes);
    own.kinds = team.points.fromMaster(std::move(whole.kinds));
    own.curvature = team.points.fromMaster(std::move(whole.curvature));
    own.heights = heightsFromMaster(std::move(whole.heights), team);

    return own;
}


scalarField makeClearance
(
    const guidedColumns& front,
    const prismLayerControls& controls,
    const stageObserver& observer
)
{
    observer.begin("wallClearance");
    const scalarField reach
    (
        2*controls.envelope.scale
       *scalarField(front.heights.room, front.own.wallPoints)
    );
    const scalar maxStretch = controls.layers.maxStretch;
    scalarField clearance(clearanceOf(front, reach, maxStretch));
    const wallSurface& own = front.own.surface;
    boundByPlanes
    (
        freeSides(controls.farField.boundary, own.border.sides), own.points,
        front.own.visibility, clearance, maxStretch
    );
    const scalar least = min(front.team.gather(scalarList(1, min(clearance))));
    observer.end(text("room from ", least, " m"));

    return clearance;
}


layerColumns makeColumns
(
    const guidedColumns& front,
    const scalarField& clearance,
    const columnGuide& guide,
    const layerControls& controls,
    const stageObserver& observer
)
{
    observer.begin("layerColumns");
    const layerColumns columns
    (
        makeLayerColumns
        (
            front.own, clearance, guide.spacing.at(front.own.wallPoints),
            guide.lines, controls, front.team
        )
    );
    observer.end
    (
        text(front.team.columns.nWhole(front.own.wallPoints.size()), " columns")
    );

    return columns;
}


madeLayers makeLayers
(
    const layerFront& front,
    const List<pointKind>& kinds,
    const layerSpacing& request,
    const layerSpacing& spacing,
    const layerColumns& columns,
    const prismLayerControls& controls,
    const columnTeam& team,
    const stageObserver& observer
)
{
    observer.begin("prismLayers");
    layerMoveControls moves;
    moves.quality = controls.quality;
    moves.isCut = controls.farField.isWanted();
    moves.freeSides =
        freeSides(controls.farField.boundary, front.surface.border.sides);
    madeLayers made(makePrismLayers(front, spacing, columns, moves, team));

    if (made.certified.pointsWithoutHeight.empty())
    {
        if (team.isAlone())
        {
            makePlanar
            (
                columnsAcross
                (
                    front.surface.faces, front.surface.border,
                    front.surface.points
                ),
                made.layers
            );
        }
        nameCauses
        (
            front, kinds, request.at(front.wallPoints), spacing, columns, made
        );
    }
    observer.end(sizesOf(made, team.faces.nWhole(front.surface.faces.size())));

    return made;
}


//- Refuses cells that a solver takes for flat: there is no room for more
static void refuseFlatStacks
(
    const prismLayers& layers,
    const layerCertificate& certificate,
    const columnTeam& team
)
{
    const labelList& flat = certificate.flatStacks;
    const label nFlat = team.sum(flat.size());
    if (nFlat)
    {
        string place;
        if (flat.size())
        {
            OStringStream os;
            const label c = layers.faces[flat[0]][0];
            os  << ", at " << layers(c, 0);
            place = os.str();
        }
        FatalErrorInFunction
            << "Cells of the layers on " << nFlat << " faces are flat but for"
            << " rounding" << place.c_str() << nl
            << "Walls are too near to each other there, or faces are too long"
            << " and narrow: move walls apart, unite them, or remesh the"
            << " surface" << exit(FatalError);
    }
}


layerCertificate makeCertificate
(
    const prismLayers& layers,
    const columnTeam& team,
    const stageObserver& observer
)
{
    observer.begin("prismQuality");
    layerCertificate certificate(certify(layers, team));
    certificate.nCells = team.sum(certificate.nCells);
    certificate.nStacksNotPositive = team.sum(certificate.nStacksNotPositive);
    certificate.nOverlaps = team.sum(certificate.nOverlaps);
    observer.end(sizesOf(certificate));

    if (!certificate.valid())
    {
        FatalErrorInFunction
            << "The layers could not be certified: the cells on "
            << certificate.nStacksNotPositive << " faces are not positive, and "
            << certificate.nOverlaps << " pairs of outer faces intersect" << nl
            << "This is a fault of harmonicPrismMesh: please report it with the"
            << " case" << exit(FatalError);
    }
    refuseFlatStacks(layers, certificate, team);

    return certificate;
}


farFieldMesh makeFarField
(
    const prismLayers& layers,
    farFieldDomain domain,
    const farFieldControls& controls,
    const stageObserver& observer
)
{
    observer.begin("farFieldMesh");
    const farFieldMesh far
    (
        makeFarFieldMesh(layers, std::move(domain), controls)
    );
    observer.end(sizesOf(far));

    return far;
}


void requireHeights
(
    const wallSurface& wall,
    const certification& certified,
    const processTeam& processes
)
{
    if (certified.pointsWithoutHeight.empty())
    {
        return;
    }
    if (processes.isMaster())
    {
        throw wallPointsError
        (
            wall, certified.pointsWithoutHeight,
            certified.cause == squeezeCause::intersection
          ? "have columns whose outer faces intersect at any thickness"
          : "have columns whose cells are not positive at any thickness",
            "Remesh the surface there (surface.remesh), move apart walls that"
            " nearly touch, or go around these places (surface.repair wrap)."
        );
    }
    processes.any(false);
}

} // End namespace Foam

// ************************************************************************* //
