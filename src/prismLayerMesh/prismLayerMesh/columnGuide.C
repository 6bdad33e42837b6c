/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnGuide.H"
#include "blockLines.H"
#include "stageText.H"
#include "straightShares.H"
#include "wallBlocks.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Straight lines of the columns that this process makes
static gradientLines straightLines
(
    const guidedColumns& columns,
    const layerSpacing& spacing
)
{
    return makeStraightLines
    (
        columns.own.surface.points, columns.own.visibility.axes(),
        requestedHeights(spacing.at(columns.own.wallPoints))
    );
}


static columnGuide straightGuide(const guidedColumns& columns)
{
    columnGuide guide;
    guide.spacing = columns.heights.graded;
    guide.noField = "marchingDirections axes needs none";
    guide.fields.failure = guide.noField;
    guide.lines = straightLines(columns, guide.spacing);

    return guide;
}


//- Lines along a field, straightened where the columns need none
static gradientLines straightened
(
    const guidedColumns& columns,
    const layerSpacing& spacing,
    columnLines& along
)
{
    const gradientLines straight(straightLines(columns, spacing));
    const label n = straight.nSamples;
    forAll(along.slopes, c)
    {
        if (!along.isSet[c] || !columns.team.isOwn(c))
        {
            along.slopes[c] = 0;
            SubList<point>(along.lines.points, n, n*c) =
                SubList<point>(straight.points, n, n*c);
        }
    }

    const scalarField thickness(spacing.thickness, columns.own.wallPoints);
    const scalarField shares
    (
        straightShares(columns.own, along.slopes, thickness, columns.team)
    );
    straighten(straight, shares, along.lines);

    return std::move(along.lines);
}


//- On the master: starts of all columns.
//  spacing: at all points of the wall
static columnStarts startsOfAll
(
    const guidedColumns& columns,
    const layerSpacing& spacing
)
{
    const layerFront& front = columns.front;
    const wallVisibility& visibility = front.visibility.cones.size()
      ? front.visibility : columns.whole->context.visibility;

    return columnStarts
    {
        front.wallPoints, visibility.axes(), spacing.at(front.wallPoints)
    };
}


//- The lines of one field for all of the wall, which the master makes.
//  spacing: on the master, at all points of the wall. Collective
static columnLines linesOfOneField
(
    const wallFields& fields,
    const layerSpacing& spacing,
    const guidedColumns& columns,
    const lineDirections weighting = lineDirections::unit
)
{
    const columnTeam& team = columns.team;
    columnLines all;
    if (columns.whole)
    {
        all = makeColumnLines
        (
            fields.background, fields.isotropic, startsOfAll(columns, spacing),
            weighting
        );
    }
    if (team.isAlone())
    {
        return all;
    }

    labelList n(1, all.lines.nSamples);
    team.broadcast(n);
    columnLines own;
    own.lines.nSamples = n[0];
    own.lines.points = team.fromMaster(all.lines.points, n[0]);
    own.slopes = team.fromMaster(all.slopes);
    own.isSet.setSize(own.slopes.size(), true);

    return own;
}


//- On the master: radii at all points of the wall. Collective
static envelopeRadii radiiOfAll
(
    const columnTeam& team,
    const envelopeRadii& radii
)
{
    return envelopeRadii
    {
        scalarField(team.pointsOnMaster(radii.wanted)),
        scalarField(team.pointsOnMaster(radii.room)),
        scalarField(team.pointsOnMaster(radii.radius)),
        scalarField(team.pointsOnMaster(radii.edgeLengths))
    };
}


//- Lines in the fields of blocks. Collective
static columnLines linesOfBlocks
(
    const guidedColumns& columns,
    const envelopeRadii& radii,
    const labelListList& blocks,
    const prismLayerControls& controls,
    const stageObserver& observer,
    columnGuide& guide
)
{
    observer.begin("columnLines");
    const wallSurface& wall = columns.context.wall;
    const dividedWall divided
    {
        columns.team, columns.own, wall, radii, guide.spacing, blocks,
        blockControls(), controls.backgroundMesh, controls.layers.maxStretch
    };
    columnLines lines
    (
        makeColumnLines(divided, controls.field, guide.noField)
    );
    const label nPoints = columns.team.nWallPoints(wall.points.size());
    observer.end(sizesOf(blocks, nPoints, guide.noField));

    return lines;
}


//- The master makes the fields of the whole wall. Collective
static void makeWholeFields
(
    const guidedColumns& columns,
    const envelopeRadii& radii,
    const prismLayerControls& controls,
    const stageObserver& observer,
    columnGuide& guide
)
{
    const envelopeRadii all(radiiOfAll(columns.team, radii));
    if (columns.whole)
    {
        wallContext& context = columns.whole->context;
        context.complete();
        guide.envelope = makeEnvelope(context, all, controls, observer);
        guide.fields =
            makeFields(context, guide.envelope, controls.field, observer);
    }
}


//- The lines of the isotropic field, the exact and the smooth one: on the lines
//  of the others columns beside concave edges cross. They are straight on
//  convex parts, and everywhere if there is no field.
static columnGuide fieldGuide
(
    const guidedColumns& columns,
    const envelopeRadii& radii,
    const prismLayerControls& controls,
    const stageObserver& observer,
    const bool keepStages
)
{
    columnGuide guide;
    guide.spacing = columns.heights.graded;
    const wallBlocks blocks
    (
        makeWallBlocks(columns.context, radii, columns.team)
    );
    columnLines along;

    if (!blocks.isDivided || keepStages)
    {
        makeWholeFields(columns, radii, controls, observer, guide);
        guide.field = guide.fields.anisotropic;
    }
    guide.fields.failure = columns.team.textOfMaster(guide.fields.failure);

    if (blocks.isDivided)
    {
        if (!keepStages)
        {
            columns.context.drop();
        }
        along = linesOfBlocks
        (
            columns, radii, blocks.points, controls, observer, guide
        );
    }
    else if (guide.fields.failure.empty())
    {
        along = linesOfOneField
        (
            guide.fields,
            columns.whole ? columns.whole->heights.graded : layerSpacing(),
            columns
        );
    }
    else
    {
        guide.noField = guide.fields.failure;
        guide.lines = straightLines(columns, guide.spacing);

        return guide;
    }

    guide.lines = straightened(columns, guide.spacing, along);

    return guide;
}


//- The master makes the level sets. Collective
static columnGuide levelSetGuide
(
    const guidedColumns& columns,
    const envelopeRadii& radii,
    const prismLayerControls& controls,
    const stageObserver& observer
)
{
    columnGuide guide;
    layerSpacing spacing;
    makeWholeFields(columns, radii, controls, observer, guide);

    if (columns.whole)
    {
        levelSetLayers onSets
        (
            makeLevelSets
            (
                columns.whole->context, guide.fields,
                columns.whole->heights.graded, controls, observer
            )
        );
        guide.field = std::move(onSets.field);
        spacing = std::move(onSets.spacing);
    }
    guide.spacing = spacingOnShare(spacing, columns.team);

    guide.lines = controls.layers.alongField
      ? linesOfOneField
        (
            guide.fields, spacing, columns, lineDirections::agreeing
        ).lines
      : straightLines(columns, guide.spacing);

    return guide;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

columnGuide makeColumnGuide
(
    const guidedColumns& columns,
    const scalarField& clearance,
    const prismLayerControls& controls,
    const stageObserver& observer,
    const bool keepStages
)
{
    const layerControls& layers = controls.layers;

    if (!layers.alongField && !layers.onLevelSets)
    {
        return straightGuide(columns);
    }

    const envelopeRadii radii
    (
        makeEnvelopeRadii
        (
            columns.context, controls.envelope.scale*columns.heights.room,
            columns.own.smallest(clearance), columns.team
        )
    );

    return layers.onLevelSets
      ? levelSetGuide(columns, radii, controls, observer)
      : fieldGuide(columns, radii, controls, observer, keepStages);
}

} // End namespace Foam

// ************************************************************************* //
