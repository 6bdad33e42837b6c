/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerSpacing.H"
#include "limitGradient.H"
#include "pointHeights.H"
#include "ranges.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Share of the area of the wall on which an automatic number of layers is
//  enough for the last of them to be as high as asked for
static const scalar automaticShare = 0.95;


static bool hasRelativeSizes(const layerControls& controls)
{
    const auto isRelative = [](const auto& entry)
    {
        return entry.heights.relativeSizes;
    };

    return
        isRelative(controls)
     || anyOf(controls.patches, isRelative)
     || anyOf(controls.regions, isRelative);
}


//- Number of layers until the last one is as high as asked for, at points that
//  have a share of the area of the wall
static label automaticNumber
(
    const wallSurface& wall,
    const List<heightSeries>& heights,
    const scalarField& finalHeights
)
{
    scalarField areas(heights.size(), 0);

    for (const face& f : wall.faces)
    {
        const scalar share = f.mag(wall.points)/f.size();

        for (const label p : f)
        {
            areas[p] += share;
        }
    }

    List<std::pair<scalar, label>> numbers(heights.size());

    forAll(heights, p)
    {
        const heightSeries& series = heights[p];

        if (series.expansionRatio <= 1)
        {
            FatalErrorInFunction
                << "With nSurfaceLayers auto the expansionRatio must be more"
                << " than 1; it is " << series.expansionRatio
                << " at the point " << wall.points[p] << exit(FatalError);
        }

        const scalar growth =
            max(finalHeights[p]/series.firstLayerThickness, 1.0);

        numbers[p].first = 1 + ::log(growth)/::log(series.expansionRatio);
        numbers[p].second = p;
    }

    std::sort(numbers.begin(), numbers.end());

    scalar left = automaticShare*sum(areas);
    label i = 0;
    while (i + 1 < numbers.size() && (left -= areas[numbers[i].second]) > 0)
    {
        ++i;
    }

    // Rounded up, so that ratios are lowered rather than raised
    const label n = ::ceil(numbers[i].first - 1e-6);

    return min(n, heightSeries::maxLayers);
}


//- Lower the ratio where the last of n layers would be higher than asked for
static void limitFinalHeight
(
    const label n,
    const scalar finalHeight,
    heightSeries& heights
)
{
    heights.n = n;

    if (n > 1)
    {
        const scalar growth =
            max(finalHeight/heights.firstLayerThickness, 1.0);

        heights.expansionRatio =
            min(heights.expansionRatio, ::pow(growth, 1.0/(n - 1)));
    }
}


//- The ratio with which n layers have first height and thickness of fewer, or
//  are uniform
static scalar ratioOfMore(const label n, const heightSeries& fewer)
{
    const scalar h1 = fewer.firstLayerThickness;
    const scalar thickness = totalThickness(fewer.n, h1, fewer.expansionRatio);

    return thickness > n*h1
      ? fittedRatio(n, h1, thickness)
      : min(fewer.expansionRatio, scalar(1));
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

scalarField localEdgeLengths
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const scalar growth
)
{
    scalarField lengths(meanEdges(wall, addressing));
    limitRatio(addressing, growth, lengths);

    return lengths;
}


layerSpacing makeLayerSpacing
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const layerControls& controls,
    const localHeights& local
)
{
    scalarField edges;
    if (controls.automatic() || hasRelativeSizes(controls))
    {
        edges = localEdgeLengths(wall, addressing, controls.transitionRatio);
    }

    const pointHeights asked(wall, addressing, controls, local, edges);
    List<heightSeries> heights(wall.points.size());
    label n = 1;

    forAll(heights, p)
    {
        heights[p] = asked.of(p);
        n = max(n, heights[p].n);
    }

    if (controls.automatic())
    {
        const scalarField finalHeights(controls.finalAspect*edges);
        n = automaticNumber(wall, heights, finalHeights);

        forAll(heights, p)
        {
            limitFinalHeight(n, finalHeights[p], heights[p]);
        }
    }

    layerSpacing spacing;
    spacing.nLayers = n;
    spacing.firstThickness.setSize(heights.size());
    spacing.ratio.setSize(heights.size());
    spacing.thickness.setSize(heights.size());
    spacing.layersAsked.setSize(heights.size());

    forAll(heights, p)
    {
        const heightSeries& series = heights[p];
        const scalar h1 = series.firstLayerThickness;
        const scalar ratio =
            series.n < n ? ratioOfMore(n, series) : series.expansionRatio;

        spacing.firstThickness[p] = h1;
        spacing.ratio[p] = ratio;
        spacing.thickness[p] = totalThickness(n, h1, ratio);
        spacing.layersAsked[p] = series.n;
    }

    return spacing;
}

} // End namespace Foam

// ************************************************************************* //
