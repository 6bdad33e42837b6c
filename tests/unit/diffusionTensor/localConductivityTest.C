/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "localConductivity.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- Layers of the same heights on one point of the wall
static layerSpacing spacingOf
(
    const label n,
    const scalar first,
    const scalar thickness
)
{
    layerSpacing spacing;
    spacing.nLayers = n;
    spacing.firstThickness = scalarField(1, first);
    spacing.thickness = scalarField(1, thickness);
    spacing.ratio = scalarField(1, 1);

    if (n > 1)
    {
        spacing.ratio = fittedRatio(n, first, thickness);
    }

    return spacing;
}


//- Conductivity of a tetrahedron between two depths, in a gap of 2, of one
//  layer with the energy 0.5: of height 1 on all of the wall, of the given
//  height locally
static scalar conductivityBetween
(
    const scalar depthA,
    const scalar depthB,
    const scalar height
)
{
    backgroundMesh mesh;
    mesh.points = pointField(4, point(Zero));
    mesh.gaps = scalarField(4, 2);
    mesh.tets = List<tetCell>(1, tetCell(0, 1, 2, 3));

    List<wallSearch::foot> feet(4);
    for (wallSearch::foot& foot : feet)
    {
        foot.points = label(0);
        foot.weights = scalar(0);
        foot.weights[0] = 1;
        foot.distance = 0.5*(depthA + depthB);
    }
    feet[0].distance = depthA;
    feet[1].distance = depthB;

    return localConductivities
    (
        mesh, feet, scalarField(1, 0.5), spacingOf(1, 1, 1),
        spacingOf(1, height, height)
    )[0];
}


//- The height that one correction makes of 0.5, which was asked for, where the
//  uniform height is 1
static scalar correctedHalf(const scalar reached)
{
    const layerSpacing half(spacingOf(1, 0.5, 0.5));

    return correctedTarget
    (
        half, half, spacingOf(1, reached, reached), spacingOf(1, 1, 1)
    ).thickness[0];
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(localConductivities, areRatiosOfSlopes)
{
    // Slopes: 1/2 above a flat wall; 1 up to the height 0.5, then 1/3
    EXPECT_NEAR(conductivityBetween(0.1, 0.3, 0.5), 0.5, 1e-14);
    EXPECT_NEAR(conductivityBetween(0.3, 0.1, 0.5), 0.5, 1e-14);
    EXPECT_NEAR(conductivityBetween(1.2, 1.5, 0.5), 1.5, 1e-14);
}


TEST(localConductivities, areHarmonicMeansOverDepths)
{
    // The field of the local heights falls by 0.2 + 0.1 between these depths
    EXPECT_NEAR(conductivityBetween(0.3, 0.8, 0.5), 0.25/0.3, 1e-14);
}


TEST(localConductivities, areOneForUniformHeights)
{
    EXPECT_EQ(conductivityBetween(0.1, 0.3, 1), 1);
}


TEST(correctedTarget, isScaledByWhatWasReached)
{
    EXPECT_NEAR(correctedHalf(0.5), 0.5, 1e-15);
    EXPECT_NEAR(correctedHalf(0.55), 0.5*0.5/0.55, 1e-15);
    EXPECT_NEAR(correctedHalf(0.45), 0.5*0.5/0.45, 1e-15);
}


TEST(correctedTarget, changesByBoundedFactors)
{
    EXPECT_NEAR(correctedHalf(1), 0.5*conductivityControls::leastChange, 1e-15);
    EXPECT_NEAR
    (
        correctedHalf(0.1), 0.5*conductivityControls::mostChange, 1e-15
    );
}


TEST(correctedTarget, leavesUniformHeights)
{
    const layerSpacing uniform(spacingOf(3, 0.2, 1));
    const layerSpacing corrected
    (
        correctedTarget(uniform, uniform, spacingOf(3, 0.1, 0.7), uniform)
    );

    EXPECT_EQ(corrected.firstThickness[0], 0.2);
    EXPECT_EQ(corrected.thickness[0], 1);
}


TEST(correctedTarget, isAGeometricProgression)
{
    const layerSpacing asked(spacingOf(3, 0.15, 0.5));
    const layerSpacing corrected
    (
        correctedTarget
        (
            asked, asked, spacingOf(3, 0.16, 0.45), spacingOf(3, 0.2, 1)
        )
    );

    EXPECT_NEAR(corrected.firstThickness[0], 0.15*0.15/0.16, 1e-15);
    EXPECT_NEAR(corrected.thickness[0], 0.5*0.5/0.45, 1e-15);
    EXPECT_NEAR
    (
        totalThickness(3, corrected.firstThickness[0], corrected.ratio[0]),
        corrected.thickness[0], 1e-9
    );
}


// ************************************************************************* //
