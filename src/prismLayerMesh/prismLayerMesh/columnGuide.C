/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnGuide.H"
#include "straightShares.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static columnStarts startsOf
(
    const layerFront& front,
    const layerSpacing& spacing
)
{
    return columnStarts
    {
        front.wallPoints, front.visibility.axes(),
        requestedHeights(spacing.at(front.wallPoints))
    };
}


static gradientLines straightLines
(
    const layerFront& front,
    const columnStarts& starts
)
{
    return makeStraightLines
    (
        front.surface.points, starts.directions, starts.arcLengths
    );
}


static columnGuide straightGuide
(
    const wallHeights& heights,
    const layerFront& front
)
{
    columnGuide guide;
    guide.spacing = heights.graded;
    guide.noField = "marchingDirections axes needs none";
    guide.fields.failure = guide.noField;
    guide.lines = straightLines(front, startsOf(front, guide.spacing));

    return guide;
}


//- The points of the blocks of a closed wall that is large
static labelListList blocksOf
(
    const wallSurface& wall,
    const offsetEnvelope& envelope
)
{
    return wall.border.sides.empty()
      ? divideWall(wall.points, envelope.radius, blockControls())
      : labelListList();
}


//- Lines along a field, straightened where the columns of the front need none
static gradientLines straightened
(
    const layerFront& front,
    const gradientLines& straight,
    const layerSpacing& spacing,
    columnLines& along
)
{
    const scalarField thickness(spacing.thickness, front.wallPoints);
    const scalarField shares(straightShares(front, along.slopes, thickness));
    straighten(straight, shares, along.lines);

    return std::move(along.lines);
}


//- The lines of the isotropic field, the exact and the smooth one: on the lines
//  of the others columns beside concave edges cross. They are straight on
//  convex parts, and everywhere if there is no field.
static columnGuide fieldGuide
(
    const wallContext& context,
    const wallHeights& heights,
    const layerFront& front,
    offsetEnvelope&& envelope,
    const prismLayerControls& controls,
    const stageObserver& observer,
    const bool keepStages
)
{
    columnGuide guide;
    guide.spacing = heights.graded;
    guide.envelope = std::move(envelope);
    guide.blocks = blocksOf(context.wall, guide.envelope);
    const columnStarts starts(startsOf(front, guide.spacing));
    columnLines along;

    if (guide.blocks.empty() || keepStages)
    {
        guide.fields =
            makeFields(context, guide.envelope, controls.field, observer);
        guide.field = guide.fields.anisotropic;
    }

    if (guide.blocks.size())
    {
        const dividedWall divided
        {
            context, guide.envelope, guide.blocks, blockControls()
        };
        along = makeLinesOfBlocks
        (
            divided, starts, controls.field, observer, guide.noField
        );
    }
    else if (guide.fields.failure.empty())
    {
        along = makeColumnLines
        (
            guide.fields.background, guide.fields.isotropic, starts
        );
    }
    else
    {
        guide.noField = guide.fields.failure;
        guide.lines = straightLines(front, starts);

        return guide;
    }

    guide.lines = straightened
    (
        front, straightLines(front, starts), guide.spacing, along
    );

    return guide;
}


static columnGuide levelSetGuide
(
    const wallContext& context,
    const wallHeights& heights,
    const layerFront& front,
    offsetEnvelope&& envelope,
    const prismLayerControls& controls,
    const stageObserver& observer
)
{
    columnGuide guide;
    guide.envelope = std::move(envelope);
    guide.fields =
        makeFields(context, guide.envelope, controls.field, observer);

    levelSetLayers onSets
    (
        makeLevelSets
        (
            context, guide.fields, heights.graded, controls, observer
        )
    );
    guide.field = std::move(onSets.field);
    guide.spacing = std::move(onSets.spacing);

    const columnStarts starts(startsOf(front, guide.spacing));
    guide.lines = controls.layers.alongField
      ? makeColumnLines
        (
            guide.fields.background, guide.fields.isotropic, starts,
            lineDirections::agreeing
        ).lines
      : straightLines(front, starts);

    return guide;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

columnGuide makeColumnGuide
(
    wallContext& context,
    const wallHeights& heights,
    const layerFront& front,
    const scalarField& clearance,
    const prismLayerControls& controls,
    const stageObserver& observer,
    const bool keepStages
)
{
    const layerControls& layers = controls.layers;

    if (!layers.alongField && !layers.onLevelSets)
    {
        return straightGuide(heights, front);
    }

    offsetEnvelope envelope
    (
        makeEnvelope
        (
            context, heights.room, front.smallest(clearance), controls, observer
        )
    );

    if (!keepStages && !layers.onLevelSets)
    {
        // Not for the processes that make lines
        context.visibility = wallVisibility();
    }

    return layers.onLevelSets
      ? levelSetGuide
        (
            context, heights, front, std::move(envelope), controls, observer
        )
      : fieldGuide
        (
            context, heights, front, std::move(envelope), controls, observer,
            keepStages
        );
}

} // End namespace Foam

// ************************************************************************* //
