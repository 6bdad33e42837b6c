/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerStages.H"
#include "adviceOnPoints.H"
#include "levelSets.H"
#include "nameCauses.H"
#include "stageText.H"
#include "unitConversion.H"
#include "wallClearance.H"
#include "wallPartsInBoxes.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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
        return clearanceBy(columns.context.search());
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
            front, columns.team,
            boxesAround(front.surface.points, farthest)
        )
    );

    return reach.empty() ? reach : clearanceBy(wallSearch(near.surface));
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

wallHeights makeHeights
(
    const wallContext& context,
    const layerControls& controls,
    const localHeights& local,
    const stageObserver& observer
)
{
    observer.begin("layerSpacing");
    wallHeights heights;
    heights.request =
        makeLayerSpacing(context.wall, context.addressing, controls, local);
    requireCountable
    (
        context.addressing.edges.size(), heights.request.nLayers
    );
    heights.graded = gradedSpacing
    (
        heights.request, context.addressing, controls.transitionRatio
    );
    heights.room = controls.onLevelSets
      ? uniformSpacing(heights.graded).thickness : heights.graded.thickness;
    observer.end
    (
        text(heights.request.nLayers, " layers\n",
            describe(heights.request, context.wall, controls).c_str())
    );

    return heights;
}


layerFront makeFront
(
    const wallContext& context,
    const scalar multipleNormalsAngle,
    const stageObserver& observer
)
{
    observer.begin("layerFront");
    const layerFront front
    (
        makeBareFront
        (
            context.wall, context.addressing, context.visibility,
            degToRad(multipleNormalsAngle)
        )
    );
    observer.end(sizesOf(front));

    return front;
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
    const scalarField clearance
    (
        clearanceOf(front, reach, controls.layers.maxStretch)
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
        text(front.team.nColumns(front.own.wallPoints.size()), " columns")
    );

    return columns;
}


madeLayers makeLayers
(
    const guidedColumns& front,
    const layerSpacing& spacing,
    const layerColumns& columns,
    const qualityControls& quality,
    const stageObserver& observer
)
{
    observer.begin("prismLayers");
    layerMoveControls moves;
    moves.quality = quality;
    madeLayers made
    (
        makePrismLayers(front.own, spacing, columns, moves, front.team)
    );

    if (made.certified.pointsWithoutHeight.empty())
    {
        nameCauses
        (
            front.own, front.context.kinds,
            front.heights.request.at(front.own.wallPoints), spacing, columns,
            made
        );
    }
    observer.end
    (
        sizesOf
        (
            made, front.team.nWholeFaces(front.own.surface.faces.size())
        )
    );

    return made;
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
            << "The layers could not be certified" << exit(FatalError);
    }

    return certificate;
}


farFieldMesh makeFarField
(
    const prismLayers& layers,
    const wallAddressing& frontAddressing,
    farFieldDomain domain,
    const farFieldControls& controls,
    const stageObserver& observer
)
{
    observer.begin("farFieldMesh");
    const farFieldMesh far
    (
        makeFarFieldMesh(layers, frontAddressing, std::move(domain), controls)
    );
    observer.end(sizesOf(far));

    return far;
}


wallPointsError errorOfPoints
(
    const wallContext& context,
    const layerFront& front,
    const certification& certified
)
{
    const labelList& points = front.pointsWithoutDirection;

    if (points.size())
    {
        return wallPointsError
        (
            context.wall, points,
            "have no direction from which all their faces are visible, even "
            "with multiple normals",
            adviceOnPoints(context.wall, context.addressing, points)
        );
    }

    return wallPointsError
    (
        context.wall, certified.pointsWithoutHeight,
        certified.cause == squeezeCause::intersection
      ? "have columns whose outer faces intersect at any thickness"
      : "have columns whose cells are not positive at any thickness"
    );
}

} // End namespace Foam

// ************************************************************************* //
