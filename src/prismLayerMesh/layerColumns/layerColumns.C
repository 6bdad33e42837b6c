/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerColumns.H"
#include "columnControls.H"
#include "HashSet.H"
#include "limitGradient.H"
#include "wallSmoother.H"

#include <algorithm>

namespace Foam
{

scalarField straightShares
(
    const layerFront& front,
    const scalarField& slopes,
    const scalarField& thickness,
    const columnTeam& team
)
{
    const scalar from = columnControls::concaveSlope;
    const scalar to = columnControls::convexSlope;
    scalarField shares(min(max((slopes - from)/(to - from), 0.0), 1.0));

    wallSmoother(front.surface, front.addressing).smooth
    (
        sqr(columnControls::slopeSmoothing*thickness),
        columnControls::maxScalarPasses,
        shares,
        team
    );

    return shares;
}


void straighten
(
    const gradientLines& straight,
    const scalarField& shares,
    gradientLines& lines
)
{
    forAll(lines.points, i)
    {
        const scalar share = shares[i/lines.nSamples];
        lines.points[i] += share*(straight.points[i] - lines.points[i]);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalar layerColumns::stretch(const label c, const scalar height) const
{
    // The length is height*(maxStretch + ...), which always grows with it
    const scalar excess =
        max(columnControls::nearWallStretch - maxStretch, scalar(0));
    const scalar halfWay = columnControls::nearWallHeight*edgeLengths[c];

    return maxStretch + excess/(1 + height/halfWay);
}


vector layerColumns::axisOffset
(
    const wallVisibility& visibility,
    const label c,
    const scalar height
) const
{
    const vector& axis = visibility.cones[c].axis;

    return axis/max(visibility.heightCosine(c, axis), 1/stretch(c, height));
}


layerColumns layerColumns::at(const labelUList& columns) const
{
    layerColumns result;
    result.nLayers = nLayers;
    result.heights.setSize(columns.size()*nLayers);
    result.offsets.setSize(columns.size()*nLayers);
    forAll(columns, c)
    {
        const label from = columns[c]*nLayers;
        SubList<scalar>(result.heights, nLayers, c*nLayers) =
            SubList<scalar>(heights, nLayers, from);
        SubList<vector>(result.offsets, nLayers, c*nLayers) =
            SubList<vector>(offsets, nLayers, from);
    }
    result.maxThickness = scalarField(maxThickness, columns);
    result.causes = List<squeezeCause>
    (
        UIndirectList<squeezeCause>(causes, columns)
    );
    result.edgeLengths = scalarField(edgeLengths, columns);
    result.maxStretch = maxStretch;
    result.onLevelSets = onLevelSets;

    return result;
}


label layerColumns::layerAt(const label c, const scalar height) const
{
    const scalar* first = heights.cdata() + c*nLayers;

    return std::lower_bound(first, first + nLayers, height) - first;
}


vector layerColumns::interpolated
(
    const vectorField& values,
    const label c,
    const scalar height
) const
{
    const scalar* first = heights.cdata() + c*nLayers;
    const label i = layerAt(c, height);

    if (i == 0 || i == nLayers)
    {
        return values[c*nLayers + max(i - 1, 0)];
    }

    const scalar s = (height - first[i - 1])/(first[i] - first[i - 1]);

    return (1 - s)*values[c*nLayers + i - 1] + s*values[c*nLayers + i];
}


vector columnOffset
(
    const wallVisibility& visibility,
    const label c,
    const vector& direction,
    const scalar stretch
)
{
    const vector& axis = visibility.cones[c].axis;
    vector d = visibility.limited
    (
        c, normalised(direction), columnControls::coneMargin
    );

    // Not so far over that the stretch would take height away
    const scalar smallest = min(1/stretch, visibility.heightCosine(c, axis));
    const scalar cosine = visibility.heightCosine(c, d);

    if (cosine < smallest)
    {
        const scalar s = (smallest - cosine)
           /max(visibility.heightCosine(c, axis) - cosine, VSMALL);
        d = normalised(d + min(s, scalar(1))*(axis - d));
    }

    return d/max(visibility.heightCosine(c, d), 1/stretch);
}


bool isStretched
(
    const wallVisibility& visibility,
    const label c,
    const scalar stretch
)
{
    return
        visibility.heightCosine(c, visibility.cones[c].axis)*stretch
      < 1 - SMALL;
}


// * * * * * * * * * * * * *  Make Layer Columns * * * * * * * * * * * * * * //

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

    #pragma omp parallel for schedule(static, 256)
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

        #pragma omp parallel for schedule(static, 256)
        for (label c = 0; c < nColumns; ++c)
        {
            smoothed[c] += directions[c] - previous[c];
            previous[c] = directions[c];
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
