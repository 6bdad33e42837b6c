/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "layerColumns.H"
#include "limitGradient.H"
#include "wallSmoother.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Share of the clearance that layers may fill; the rest is the far field's
static const scalar gapShare = 0.95;

//- Length of the smoothing along the wall over the height
static const scalar smoothingLength = 0.5;

//- Bound on the passes of smoothing for each layer
static const label maxPasses = 4;

//- Bound on the length of a column over its height at the wall, and the height
//  over the length of edges where it is on half of its way to maxStretch
static const scalar nearWallStretch = 10;
static const scalar nearWallHeight = 0.05;

//- Smallest angle to a face, as a share of what the axis of the cone has
static const scalar coneMargin = 0.2;


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
    const wallVisibility& visibility,
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
        else if (isStretched(visibility, p, columns.stretch(p, asked[p])))
        {
            columns.causes[p] = squeezeCause::stretch;
        }
    }

    for
    (
        const label p
      : limitGradient(wall, addressing, layerColumns::maxSlope, columns.room)
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

Foam::scalar Foam::layerColumns::stretch
(
    const label p,
    const scalar height
) const
{
    // The length is height*(maxStretch + ...), which always grows with it
    const scalar excess = max(nearWallStretch - maxStretch, scalar(0));

    return maxStretch + excess/(1 + height/(nearWallHeight*edgeLengths[p]));
}


Foam::vector Foam::layerColumns::axisOffset
(
    const wallVisibility& visibility,
    const label p,
    const scalar height
) const
{
    const vector& axis = visibility.cones[p].axis;

    return axis
       /max(visibility.heightCosine(p, axis), 1/stretch(p, height));
}



Foam::label Foam::layerColumns::layerAt
(
    const label p,
    const scalar height
) const
{
    const scalar* first = heights.cdata() + p*nLayers;

    return std::lower_bound(first, first + nLayers, height) - first;
}


Foam::vector Foam::layerColumns::offset
(
    const label p,
    const scalar height
) const
{
    const scalar* first = heights.cdata() + p*nLayers;
    const label i = layerAt(p, height);

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

Foam::vector Foam::columnOffset
(
    const wallVisibility& visibility,
    const label p,
    const vector& direction,
    const scalar stretch
)
{
    const vector& axis = visibility.cones[p].axis;
    vector d = visibility.limited(p, normalised(direction), coneMargin);

    // Not so far over that the stretch would take height away
    const scalar smallest =
        min(1/stretch, visibility.heightCosine(p, axis));
    const scalar cosine = visibility.heightCosine(p, d);

    if (cosine < smallest)
    {
        const scalar s = (smallest - cosine)
           /max(visibility.heightCosine(p, axis) - cosine, VSMALL);
        d = normalised(d + min(s, scalar(1))*(axis - d));
    }

    return d/max(visibility.heightCosine(p, d), 1/stretch);
}


bool Foam::isStretched
(
    const wallVisibility& visibility,
    const label p,
    const scalar stretch
)
{
    return
        visibility.heightCosine(p, visibility.cones[p].axis)*stretch
      < 1 - SMALL;
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
    columns.edgeLengths = meanEdges(wall, addressing);
    columns.maxStretch = maxStretch;
    setRoom(wall, addressing, visibility, clearance, spacing, columns);

    // From layer to layer the smoothed directions take up what the lines turn,
    // and are spread by what the square of the height grows
    const wallSmoother graph(makeWallSmoother(wall, addressing));
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

        smooth(graph, variances, maxPasses, smoothed);

        for (label p = 0; p < nPoints; ++p)
        {
            columns.offsets[p*n + i] = columnOffset
            (
                visibility, p, smoothed[p],
                columns.stretch(p, columns.heights[p*n + i])
            );
        }
    }

    return columns;
}


// ************************************************************************* //
