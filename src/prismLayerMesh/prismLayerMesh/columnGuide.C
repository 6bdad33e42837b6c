/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnGuide.H"
#include "fieldIslands.H"
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
        spacing.at(front.wallPoints)
    };
}


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
        requestedHeights(spacing.at(columns.wallPoints()))
    );
}


static columnGuide straightGuide
(
    const wallHeights& heights,
    const guidedColumns& columns
)
{
    columnGuide guide;
    guide.spacing = heights.graded;
    guide.noField = "marchingDirections axes needs none";
    guide.fields.failure = guide.noField;
    guide.lines = straightLines(columns, guide.spacing);

    return guide;
}


//- The points of the parts of a closed wall that is large
static labelListList partsOf
(
    const wallSurface& wall,
    const scalarField& radius
)
{
    return wall.border.sides.empty()
      ? divideWall(wall.points, radius, blockControls())
      : labelListList();
}


//- Whether each column that this process makes is an own one with a line in a
//  field
static boolList haveLines
(
    const guidedColumns& columns,
    const columnGuide& guide
)
{
    boolList onPoints(max(columns.whole.wallPoints) + 1, !guide.isDivided);
    for (const labelList& block : guide.blocks)
    {
        UIndirectList<bool>(onPoints, block) = true;
    }

    boolList have(UIndirectList<bool>(onPoints, columns.wallPoints()));
    forAll(have, c)
    {
        have[c] = have[c] && columns.team.isOwn(c);
    }

    return have;
}


//- Lines along a field, straightened where the columns need none
static gradientLines straightened
(
    const guidedColumns& columns,
    const columnGuide& guide,
    columnLines& along
)
{
    const layerSpacing& spacing = guide.spacing;
    const gradientLines straight(straightLines(columns, spacing));
    const boolList have(haveLines(columns, guide));
    const label n = straight.nSamples;
    forAll(along.slopes, c)
    {
        if (!have[c])
        {
            along.slopes[c] = 0;
            SubList<point>(along.lines.points, n, n*c) =
                SubList<point>(straight.points, n, n*c);
        }
    }

    const scalarField thickness(spacing.thickness, columns.wallPoints());
    const scalarField shares
    (
        straightShares(columns.own, along.slopes, thickness, columns.team)
    );
    straighten(straight, shares, along.lines);

    return std::move(along.lines);
}


//- The lines of one field for all of the wall, which the master makes.
//  Collective
static columnLines linesOfOneField
(
    const columnGuide& guide,
    const guidedColumns& columns,
    const lineDirections weighting = lineDirections::unit
)
{
    columnLines all;
    if (columns.team.isMaster())
    {
        all = makeColumnLines
        (
            guide.fields.background, guide.fields.isotropic,
            startsOf(columns.whole, guide.spacing), weighting
        );
    }
    if (columns.team.isAlone())
    {
        return all;
    }

    columnLines own;
    own.lines.nSamples = guide.spacing.nLayers;
    own.lines.points =
        columns.team.fromMaster(all.lines.points, own.lines.nSamples);
    own.slopes = columns.team.fromMaster(all.slopes);

    return own;
}


//- The lines of the isotropic field, the exact and the smooth one: on the lines
//  of the others columns beside concave edges cross. They are straight on
//  convex parts, and everywhere if there is no field.
//  parts: of a large wall, see divideWall
//  islands: see findFieldIslands
//  Where the wall has parts, the context is dropped, unless the stages are kept.
static columnGuide fieldGuide
(
    wallContext& context,
    const wallHeights& heights,
    const guidedColumns& columns,
    const envelopeRadii& radii,
    const labelListList& parts,
    const labelUList& islands,
    const prismLayerControls& controls,
    const stageObserver& observer,
    const bool keepStages
)
{
    columnGuide guide;
    guide.spacing = heights.graded;
    guide.isDivided = parts.size();
    guide.blocks = partsWith(parts, islands);
    columnLines along;

    if ((!guide.isDivided || keepStages) && columns.team.isMaster())
    {
        context.complete();
        guide.envelope = makeEnvelope(context, radii, controls, observer);
        guide.fields =
            makeFields(context, guide.envelope, controls.field, observer);
        guide.field = guide.fields.anisotropic;
    }
    guide.fields.failure = columns.team.textOfMaster(guide.fields.failure);

    if (guide.isDivided)
    {
        if (!keepStages)
        {
            context.drop();
        }
        const dividedWall divided
        {
            context.wall, radii, guide.blocks, blockControls(),
            controls.backgroundMesh, controls.layers.maxStretch
        };
        along = makeLinesOfBlocks
        (
            divided, startsOf(columns.whole, guide.spacing), controls.field,
            observer, guide.noField, columns.team
        );
    }
    else if (guide.fields.failure.empty())
    {
        along = linesOfOneField(guide, columns);
    }
    else
    {
        guide.noField = guide.fields.failure;
        guide.lines = straightLines(columns, guide.spacing);

        return guide;
    }

    guide.lines = straightened(columns, guide, along);

    return guide;
}


//- Gives the spacing of the master to all
static void broadcast(const columnTeam& team, layerSpacing& spacing)
{
    labelList n(1, spacing.nLayers);
    team.broadcast(n);
    spacing.nLayers = n[0];
    team.broadcast(spacing.firstThickness);
    team.broadcast(spacing.ratio);
    team.broadcast(spacing.thickness);
    team.broadcast(spacing.layersAsked);
    team.broadcast(spacing.given);
}


//- The master makes the level sets
static columnGuide levelSetGuide
(
    wallContext& context,
    const wallHeights& heights,
    const guidedColumns& columns,
    const envelopeRadii& radii,
    const prismLayerControls& controls,
    const stageObserver& observer
)
{
    columnGuide guide;

    if (columns.team.isMaster())
    {
        context.complete();
        guide.envelope = makeEnvelope(context, radii, controls, observer);
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
    }
    broadcast(columns.team, guide.spacing);

    guide.lines = controls.layers.alongField
      ? linesOfOneField(guide, columns, lineDirections::agreeing).lines
      : straightLines(columns, guide.spacing);

    return guide;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelList guidedColumns::wallPoints() const
{
    labelList points(own.wallPoints);
    for (label& p : points)
    {
        p = team.wholeColumn(p);
    }

    return points;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

columnGuide makeColumnGuide
(
    wallContext& context,
    const wallHeights& heights,
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
        return straightGuide(heights, columns);
    }

    const envelopeRadii radii
    (
        makeEnvelopeRadii
        (
            context, controls.envelope.scale*heights.room,
            columns.team.ofWholeWall(columns.own.smallest(clearance))
        )
    );
    if (layers.onLevelSets)
    {
        return levelSetGuide
        (
            context, heights, columns, radii, controls, observer
        );
    }

    const labelListList parts(partsOf(context.wall, radii.radius));
    const labelList islands
    (
        parts.size() ? findFieldIslands(context, radii) : labelList()
    );

    return fieldGuide
    (
        context, heights, columns, radii, parts, islands, controls, observer,
        keepStages
    );
}

} // End namespace Foam

// ************************************************************************* //
