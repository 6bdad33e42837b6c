/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "levelSets.H"
#include "columnControls.H"
#include "gradientLines.H"
#include "ranges.H"
#include "wallSmoother.H"
#include "DynamicField.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Arc lengths of the samples of nLines lines, each in geometric progression
static scalarField arcLengths
(
    const scalar first,
    const scalar last,
    const label nLines
)
{
    const label n = columnControls::nSamples;
    scalarField lengths(n*nLines);
    forAll(lengths, i)
    {
        lengths[i] = first*::pow(last/first, (i % n)/scalar(n - 1));
    }

    return lengths;
}


//- Height at which a line has an energy, linear between samples
static scalar heightOf
(
    const gradientLines& lines,
    const label p,
    const wallVisibility& visibility,
    const point& start,
    const scalar energy
)
{
    scalar height = 0, before = 1;

    for (label k = p*lines.nSamples; k < (p + 1)*lines.nSamples; ++k)
    {
        // Where the line ends the energy is that of the envelope
        const scalar after = min(lines.energies[k], before);
        const scalar next =
            max(visibility.heightCosine(p, lines.points[k] - start), height);

        if (after <= energy)
        {
            const scalar s = (before - energy)/max(before - after, VSMALL);

            return height + s*(next - height);
        }

        height = next;
        before = after;
    }

    return height;
}


//- Set first height, thickness and ratio to those of the given heights
static void fitToGiven(layerSpacing& spacing)
{
    spacing.firstThickness = spacing.givenLayer(1);
    spacing.thickness = spacing.givenLayer(spacing.nLayers);

    forAll(spacing.ratio, p)
    {
        spacing.fitRatio(p);
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

layerSpacing uniformSpacing(const layerSpacing& spacing)
{
    const label n = spacing.nLayers;
    const scalar first = max(spacing.firstThickness);
    const scalar thickness = max(spacing.thickness);

    layerSpacing uniform(spacing);
    uniform.firstThickness = first;
    uniform.thickness = thickness;
    uniform.ratio = n > 1 ? fittedRatio(n, first, thickness) : 1;

    return uniform;
}


scalarField samplingEnergies
(
    const backgroundMesh& mesh,
    const scalarField& field,
    const vectorField& directions,
    const List<pointKind>& kinds,
    const layerSpacing& uniform
)
{
    const label n = uniform.nLayers;
    const gradientLines lines
    (
        makeGradientLines
        (
            mesh, field, identity(mesh.nWallPoints), directions,
            requestedHeights(uniform), linesFor::levelSets
        )
    );
    const bool anyFlat = kinds.found(pointKind::flat);
    scalarField energies(n);
    for (label i = 0; i < n; ++i)
    {
        DynamicField<scalar> values;

        for (label p = 0; p < mesh.nWallPoints; ++p)
        {
            if (!anyFlat || kinds[p] == pointKind::flat)
            {
                values.append(lines.energies[p*n + i]);
            }
        }

        energies[i] = medianOf(values);
    }

    return energies;
}


layerSpacing levelSetSpacing
(
    const backgroundMesh& mesh,
    const scalarField& field,
    const wallVisibility& visibility,
    const scalarField& energies,
    const layerSpacing& uniform
)
{
    const label n = uniform.nLayers;
    const scalar first = uniform.firstThickness[0];
    const scalar thickness = uniform.thickness[0];
    const scalarField lengths
    (
        arcLengths
        (
            columnControls::shortest*first, columnControls::longest*thickness,
            mesh.nWallPoints
        )
    );
    const gradientLines lines
    (
        makeGradientLines
        (
            mesh, field, identity(mesh.nWallPoints), visibility.axes(), lengths,
            linesFor::levelSets
        )
    );
    layerSpacing spacing(uniform);
    spacing.given.setSize(mesh.nWallPoints*n);
    const scalar least = columnControls::leastHeight*lengths[0];

    for (label p = 0; p < mesh.nWallPoints; ++p)
    {
        scalar below = 0;

        for (label i = 0; i < n; ++i)
        {
            const scalar height =
                heightOf(lines, p, visibility, mesh.points[p], energies[i]);
            below = max(height, below + least);
            spacing.given[p*n + i] = below;
        }
    }
    fitToGiven(spacing);

    return spacing;
}


layerSpacing smoothedSpacing
(
    const layerSpacing& spacing,
    const wallSurface& wall,
    const wallAddressing& addressing,
    const scalar thickness
)
{
    const wallSmoother smoother(wall, addressing);
    const scalarField variances
    (
        wall.points.size(), sqr(columnControls::levelSetSmoothing*thickness)
    );
    layerSpacing smoothed(spacing);

    for (label i = 1; i <= spacing.nLayers; ++i)
    {
        scalarField logHeights(log(spacing.givenLayer(i)));
        smoother.smooth(variances, columnControls::maxScalarPasses, logHeights);
        smoothed.setGivenLayer(i, exp(logHeights));
    }
    fitToGiven(smoothed);

    return smoothed;
}

} // End namespace Foam

// ************************************************************************* //
