/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "layerColumns.H"
#include "wallClearance.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Share of the clearance that layers may fill; the rest is the far field's
static const scalar gapShare = 0.9;

//- Bound on the gradient of the room along the wall
static const scalar roomSlope = 0.5;

//- Length of the smoothing along the wall over the height
static const scalar smoothingLength = 0.5;

//- Smallest angle to a face, as a share of what the axis of the cone has
static const scalar coneMargin = 0.2;


//- What smoothing on the graph of the wall needs
struct wallGraph
{
    const wallAddressing& addressing;

    //- 1/length^2 of the edge to each of a point's neighbours, scaled to sum 1
    List<scalarField> weights;

    //- Half the weighted mean of length^2 [m^2]: what one full pass adds to
    //  the variance of a peak
    scalarField spread;
};


static wallGraph makeWallGraph
(
    const wallSurface& wall,
    const wallAddressing& addressing
)
{
    const label nPoints = wall.points.size();
    wallGraph graph{addressing, {}, {}};
    graph.weights.setSize(nPoints);
    graph.spread.setSize(nPoints, 0);

    for (label p = 0; p < nPoints; ++p)
    {
        const labelList& neighbours = addressing.pointPoints[p];
        scalarField weights(neighbours.size());

        forAll(neighbours, i)
        {
            weights[i] =
                1/magSqr(wall.points[neighbours[i]] - wall.points[p]);
        }

        graph.weights[p] = weights/sum(weights);
        graph.spread[p] = 0.5*weights.size()/sum(weights);
    }

    return graph;
}


//- Spread values over the square root of variances [m]
static void smooth
(
    const wallGraph& graph,
    const scalarField& variances,
    vectorField& values
)
{
    const scalar fullPass = 0.7;
    const label maxPasses = 4;

    const scalar needed = max(variances/(fullPass*graph.spread));
    const label nPasses =
        min(maxPasses, label(std::ceil(min(needed, scalar(maxPasses)))));

    vectorField old(values.size());
    for (label pass = 0; pass < nPasses; ++pass)
    {
        old = values;

        forAll(values, p)
        {
            const labelList& neighbours = graph.addressing.pointPoints[p];
            vector mean(Zero);
            forAll(neighbours, i)
            {
                mean += graph.weights[p][i]*old[neighbours[i]];
            }

            const scalar share =
                min(fullPass, variances[p]/(nPasses*graph.spread[p]));
            values[p] += share*(mean - old[p]);
        }
    }
}


//- Unit directions from the wall to the samples of layer i
static vectorField lineDirections
(
    const wallSurface& wall,
    const gradientLines& lines,
    const label i
)
{
    vectorField directions(wall.points.size());

    forAll(directions, p)
    {
        directions[p] = normalised
        (
            lines.points[p*lines.nSamples + i] - wall.points[p]
        );
    }

    return directions;
}


static void setRoom
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const scalarField& clearance,
    const layerSpacing& spacing,
    layerColumns& columns
)
{
    const scalarField& asked = spacing.thickness;

    columns.room = min(asked, gapShare*clearance);
    columns.causes.setSize(asked.size(), squeezeCause::none);

    forAll(asked, p)
    {
        if (columns.room[p] < asked[p])
        {
            columns.causes[p] = squeezeCause::gap;
        }
    }

    for
    (
        const label p
      : limitGradient(wall, addressing, roomSlope, columns.room)
    )
    {
        if (columns.causes[p] == squeezeCause::none)
        {
            columns.causes[p] = squeezeCause::neighbour;
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::layerColumns::offset
(
    const label p,
    const scalar height
) const
{
    const scalar* first = heights.cdata() + p*nLayers;
    const label i = std::lower_bound(first, first + nLayers, height) - first;

    if (i == 0)
    {
        return offsets[p*nLayers];
    }
    if (i == nLayers)
    {
        return offsets[p*nLayers + nLayers - 1];
    }

    const scalar s = (height - first[i - 1])/(first[i] - first[i - 1]);

    return (1 - s)*offsets[p*nLayers + i - 1] + s*offsets[p*nLayers + i];
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::scalarField Foam::requestedHeights(const layerSpacing& spacing)
{
    const label n = spacing.nLayers;
    scalarField heights(spacing.thickness.size()*n);
    scalarList column(n + 1);

    forAll(spacing.thickness, p)
    {
        layerHeights
        (
            n,
            spacing.firstThickness[p],
            spacing.ratio[p],
            spacing.thickness[p],
            column
        );
        std::copy(column.begin() + 1, column.end(), heights.begin() + p*n);
    }

    return heights;
}


Foam::layerColumns Foam::makeLayerColumns
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const scalarField& clearance,
    const layerSpacing& spacing,
    const gradientLines& lines,
    const scalar maxStretch
)
{
    const label n = spacing.nLayers;
    const label nPoints = wall.points.size();

    layerColumns columns;
    columns.nLayers = n;
    columns.heights = requestedHeights(spacing);
    columns.offsets.setSize(nPoints*n);
    setRoom(wall, addressing, clearance, spacing, columns);

    // From layer to layer the smoothed directions take up what the lines turn,
    // and are spread by what the square of the height grows
    const wallGraph graph(makeWallGraph(wall, addressing));
    vectorField smoothed(nPoints, Zero), previous(nPoints, Zero);
    scalarField variances(nPoints), previousHeights(nPoints, 0);

    for (label i = 0; i < n; ++i)
    {
        const vectorField directions(lineDirections(wall, lines, i));
        smoothed += directions - previous;
        previous = directions;

        for (label p = 0; p < nPoints; ++p)
        {
            const scalar height =
                min(columns.heights[p*n + i], columns.room[p]);
            variances[p] = sqr(smoothingLength)
               *(sqr(height) - sqr(previousHeights[p]));
            previousHeights[p] = height;
        }

        smooth(graph, variances, smoothed);

        for (label p = 0; p < nPoints; ++p)
        {
            const vector d =
                visibility.limited(p, normalised(smoothed[p]), coneMargin);

            columns.offsets[p*n + i] =
                d/max(visibility.heightCosine(p, d), 1/maxStretch);
        }
    }

    return columns;
}


// ************************************************************************* //
