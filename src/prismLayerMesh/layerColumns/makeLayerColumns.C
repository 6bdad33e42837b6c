/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerColumns.H"
#include "columnControls.H"
#include "limitGradient.H"
#include "wallSmoother.H"
#include "HashSet.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Unit directions from the wall to the samples of layer i
static vectorField lineDirections
(
    const wallSurface& wall,
    const gradientLines& lines,
    const label i
)
{
    vectorField directions(wall.points.size());

    #pragma omp parallel for schedule(static, 256)
    forAll(directions, p)
    {
        directions[p] =
            normalised(lines.points[p*lines.nSamples + i] - wall.points[p]);
    }

    return directions;
}


//- Lower thicknesses until no slope along the wall is above the bound, on all
//  shares: the lowest thickness is the same in any order of steps. Returns the
//  columns that were lowered.
static labelList limitSlope
(
    const layerFront& front,
    const columnTeam& team,
    scalarField& thickness
)
{
    labelHashSet lowered;

    do
    {
        lowered.insert
        (
            limitGradient
            (
                front.surface, front.addressing, layerColumns::maxSlope,
                thickness
            )
        );
    }
    while (team.columns.lower(thickness));

    return lowered.sortedToc();
}


static void setMaxThickness
(
    const layerFront& front,
    const scalarField& clearance,
    const scalarField& asked,
    const columnTeam& team,
    layerColumns& columns
)
{
    columns.maxThickness = min(asked, columnControls::gapShare*clearance);
    columns.causes.setSize(asked.size(), squeezeCause::none);

    forAll(asked, c)
    {
        const scalar stretch = columns.stretch(c, asked[c]);

        if (columns.maxThickness[c] < asked[c])
        {
            columns.causes[c] = squeezeCause::gap;
        }
        else if (isStretched(front.visibility, c, stretch))
        {
            columns.causes[c] = squeezeCause::stretch;
        }
    }

    for (const label c : limitSlope(front, team, columns.maxThickness))
    {
        if (columns.causes[c] == squeezeCause::none)
        {
            columns.causes[c] = squeezeCause::neighbour;
        }
    }
    team.columns.update(columns.causes);
}


//- From layer to layer the smoothed directions take up what the lines turn, and
//  are spread by what the square of the height grows
static void setOffsets
(
    const layerFront& front,
    const gradientLines& lines,
    const columnTeam& team,
    layerColumns& columns
)
{
    const label n = columns.nLayers;
    const label nColumns = front.wallPoints.size();
    const wallSmoother smoother(front.surface, front.addressing);
    vectorField smoothed(nColumns, Zero), previous(nColumns, Zero);
    scalarField variances(nColumns), previousHeights(nColumns, 0);

    columns.offsets.setSize(nColumns*n);

    for (label i = 0; i < n; ++i)
    {
        vectorField directions(lineDirections(front.surface, lines, i));
        team.columns.update(directions);
        smoothed += directions - previous;
        previous = directions;

        #pragma omp parallel for schedule(static, 256)
        for (label c = 0; c < nColumns; ++c)
        {
            const scalar height =
                min(columns.heights[c*n + i], columns.maxThickness[c]);
            variances[c] = sqr(columnControls::smoothingLength)
               *(sqr(height) - sqr(previousHeights[c]));
            previousHeights[c] = height;
        }

        smoother.smooth(variances, columnControls::maxPasses, smoothed, team);

        #pragma omp parallel for schedule(static, 256)
        for (label c = 0; c < nColumns; ++c)
        {
            columns.offsets[c*n + i] = columnOffset
            (
                front.visibility, c, front.allowed(c, smoothed[c]),
                columns.stretch(c, columns.heights[c*n + i])
            );
        }
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

layerColumns makeLayerColumns
(
    const layerFront& front,
    const scalarField& clearance,
    const layerSpacing& spacing,
    const gradientLines& lines,
    const layerControls& controls,
    const columnTeam& team
)
{
    layerColumns columns;
    columns.nLayers = spacing.nLayers;
    columns.heights = requestedHeights(spacing);
    columns.edgeLengths = meanEdges(front.surface, front.addressing);
    columns.maxStretch = controls.maxStretch;
    columns.onLevelSets = controls.onLevelSets;
    team.columns.update(columns.edgeLengths);
    setMaxThickness(front, clearance, spacing.thickness, team, columns);
    setOffsets(front, lines, team, columns);

    return columns;
}

} // End namespace Foam

// ************************************************************************* //
