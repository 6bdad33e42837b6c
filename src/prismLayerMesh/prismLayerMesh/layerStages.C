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

namespace Foam
{

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
        makeLayerFront
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
    const wallContext& context,
    const wallHeights& heights,
    const layerFront& front,
    const prismLayerControls& controls,
    const stageObserver& observer
)
{
    observer.begin("wallClearance");
    const scalarField clearance
    (
        makeWallClearance
        (
            front.surface, context.search(), front.visibility,
            2*controls.envelope.scale*front.ofColumns(heights.room),
            controls.layers.maxStretch
        )
    );
    observer.end(text("room from ", min(clearance), " m"));

    return clearance;
}


layerColumns makeColumns
(
    const layerFront& front,
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
            front, clearance, guide.spacing.at(front.wallPoints), guide.lines,
            controls
        )
    );
    observer.end(text(front.wallPoints.size(), " columns"));

    return columns;
}


madeLayers makeLayers
(
    const wallContext& context,
    const wallHeights& heights,
    const layerFront& front,
    const layerSpacing& spacing,
    const layerColumns& columns,
    const qualityControls& quality,
    const stageObserver& observer
)
{
    observer.begin("prismLayers");
    layerMoveControls moves;
    moves.quality = quality;
    madeLayers made(makePrismLayers(front, spacing, columns, moves));

    if (made.certified.pointsWithoutHeight.empty())
    {
        nameCauses
        (
            front, context.kinds, heights.request.at(front.wallPoints),
            spacing, columns, made
        );
    }
    observer.end(sizesOf(made));

    return made;
}


layerCertificate makeCertificate
(
    const prismLayers& layers,
    const stageObserver& observer
)
{
    observer.begin("prismQuality");
    const layerCertificate certificate(certify(layers));
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
