/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnGuide.H"
#include "columnLines.H"
#include "layerColumns.H"
#include "stageText.H"
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

    #pragma omp parallel for schedule(static, 256)
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
//  spacing: at the points of the wall under the share. Collective
static columnStarts startsOnMaster
(
    const guidedColumns& columns,
    const layerSpacing& spacing
)
{
    const columnTeam& team = columns.team;
    const labelList& wallPoints = columns.own.wallPoints;
    labelList ofWhole(wallPoints);
    for (label& c : ofWhole)
    {
        c = team.wholeColumn(c);
    }

    return columnStarts
    {
        team.columns.onMaster(ofWhole),
        team.columns.onMaster(columns.own.visibility.axes()),
        spacingOnMaster(spacing.at(wallPoints), team.columns)
    };
}


//- The lines of one field for all of the wall, which the master makes.
//  Collective
//  spacing: at the points of the wall under the share
static columnLines linesOfOneField
(
    const wallFields& fields,
    const layerSpacing& spacing,
    const guidedColumns& columns,
    const linesFor use = linesFor::columns
)
{
    const columnTeam& team = columns.team;
    const columnStarts starts(startsOnMaster(columns, spacing));
    columnLines all;
    if (team.isMaster())
    {
        all = makeColumnLines
        (
            fields.background, fields.isotropic, starts, use
        );
    }
    labelList n(1, all.lines.nSamples);
    team.broadcast(n);

    const shareTable& table = team.columns;
    columnLines own;
    own.lines.nSamples = n[0];
    own.lines.points = table.fromMaster(std::move(all.lines.points), n[0]);
    own.lines.energies = table.fromMaster(std::move(all.lines.energies), n[0]);
    own.slopes = table.fromMaster(std::move(all.slopes));
    own.isSet = table.fromMaster(std::move(all.isSet));

    return own;
}


//- On the master: radii at all points of the wall. Collective
static envelopeRadii radiiOnMaster
(
    const columnTeam& team,
    const envelopeRadii& radii
)
{
    return envelopeRadii
    {
        team.points.onMaster(radii.wanted),
        team.points.onMaster(radii.room),
        team.points.onMaster(radii.radius),
        team.points.onMaster(radii.edgeLengths)
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
    const wallSurface& wall = columns.under.wall;
    const dividedWall divided
    {
        columns.team, columns.own, wall, radii, guide.spacing, blocks,
        blockControls(), controls.backgroundMesh, controls.layers.maxStretch
    };
    columnLines lines(makeColumnLines(divided, controls.field, guide.noField));
    const label nPoints = columns.team.points.nWhole(wall.points.size());
    observer.end(sizesOf(blocks, nPoints, guide.noField));

    return lines;
}


namespace
{

//- What the master makes of the whole wall; empty elsewhere
struct fieldsOnMaster
{
    wallFields fields;

    //- If layers end on level sets
    levelSetLayers levelSets;
};

} // End anonymous namespace


//- Collective
static fieldsOnMaster makeFieldsOnMaster
(
    const guidedColumns& columns,
    const envelopeRadii& radii,
    const prismLayerControls& controls,
    const stageObserver& observer
)
{
    const columnTeam& team = columns.team;
    const bool onLevelSets = controls.layers.onLevelSets;
    const envelopeRadii all(radiiOnMaster(team, radii));
    const layerSpacing graded
    (
        onLevelSets
      ? spacingOnMaster(columns.heights.graded, team.points) : layerSpacing()
    );

    fieldsOnMaster made;
    if (team.isMaster())
    {
        const wallContext context(columns.wholeWall);
        made.fields = makeFields
        (
            context, makeEnvelope(context, all, controls, observer),
            controls.field, observer
        );
        if (onLevelSets)
        {
            made.levelSets = makeLevelSets
            (
                context, made.fields, graded, controls, observer
            );
        }
    }

    return made;
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
    const wallBlocks blocks(makeWallBlocks(columns.under, radii, columns.team));
    columnLines along;

    if (!blocks.isDivided || keepStages)
    {
        guide.fields =
            makeFieldsOnMaster(columns, radii, controls, observer).fields;
        guide.field = guide.fields.anisotropic;
    }
    guide.fields.failure = columns.team.textOfMaster(guide.fields.failure);

    if (blocks.isDivided)
    {
        along = linesOfBlocks
        (
            columns, radii, blocks.points, controls, observer, guide
        );
    }
    else if (guide.fields.failure.empty())
    {
        along = linesOfOneField(guide.fields, guide.spacing, columns);
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
    fieldsOnMaster made(makeFieldsOnMaster(columns, radii, controls, observer));
    columnGuide guide;
    guide.fields = std::move(made.fields);
    guide.field = std::move(made.levelSets.field);
    guide.spacing =
        spacingFromMaster(std::move(made.levelSets.spacing), columns.team);
    guide.lines = controls.layers.alongField
      ? linesOfOneField
        (
            guide.fields, guide.spacing, columns, linesFor::levelSets
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
            columns.under.wall, columns.under.addressing,
            controls.envelope.scale*columns.heights.room,
            columns.own.smallest(clearance), columns.team
        )
    );

    return layers.onLevelSets
      ? levelSetGuide(columns, radii, controls, observer)
      : fieldGuide(columns, radii, controls, observer, keepStages);
}

} // End namespace Foam

// ************************************************************************* //
