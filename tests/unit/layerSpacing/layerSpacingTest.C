/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerSpacing.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Sum of the heights one by one, in higher precision
static scalar sumOfHeights(const label n, const scalar h1, const scalar ratio)
{
    long double h = h1, sum = 0;

    for (label i = 0; i < n; ++i)
    {
        sum += h;
        h *= ratio;
    }

    return sum;
}


static scalarField heights
(
    const label n,
    const scalar h1,
    const scalar ratio,
    const scalar room
)
{
    scalarField result(n + 1);
    layerHeights(n, h1, ratio, room, result);

    return result;
}


static layerControls controlsOf(const label n, const scalar h1)
{
    layerControls controls;
    controls.heights.nSurfaceLayers = n;
    controls.heights.firstLayerThickness = h1;

    return controls;
}


static patchLayers patchOf(const keyType& patches, const scalar h1)
{
    patchLayers entry;
    entry.patches = patches;
    entry.heights.firstLayerThickness = h1;
    entry.heights.expansionRatio = 1.5;

    return entry;
}


static layerSpacing spacingOf
(
    const wallSurface& wall,
    const layerControls& controls,
    const localHeights& local = localHeights()
)
{
    return makeLayerSpacing(wall, makeWallAddressing(wall), controls, local);
}


//- The sides x = 0 and x = 1 of a cube are patches of their own
static wallSurface cubeWithPatches()
{
    wallSurface wall(quadCube(3));
    wall.patchNames = wordList({"rest", "wingLeft", "wingRight"});

    forAll(wall.faces, facei)
    {
        const scalar x = wall.faces[facei].centre(wall.points).x();
        wall.patchIDs[facei] = (x < 1e-9 ? 1 : x > 1 - 1e-9 ? 2 : 0);
    }

    return wall;
}

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(totalThickness, isTheSumOfHeights)
{
    for (const label n : {1, 2, 20, 1000})
    {
        for (const scalar ratio : {0.5, 0.99, 1.0, 1 + 1e-12, 1.2, 1.9})
        {
            const scalar sum = sumOfHeights(n, 1e-4, ratio);
            EXPECT_NEAR(totalThickness(n, 1e-4, ratio)/sum, 1, 1e-12);
        }
    }
}


TEST(fittedRatio, givesTheThicknessBack)
{
    for (const label n : {2, 3, 10, 100, 1000})
    {
        for (const scalar s : {1.0001, 1.5, 5.0, 100.0, 1e6, 1e12})
        {
            const scalar ratio = fittedRatio(n, 1e-6, 1e-6*s);
            EXPECT_NEAR(totalThickness(n, 1e-6, ratio)/(1e-6*s), 1, 1e-11);
        }
    }
}


TEST(fittedRatio, isOneForUniformHeights)
{
    for (const label n : {2, 20, 1000})
    {
        EXPECT_NEAR(fittedRatio(n, 0.1, 0.1*n), 1, 1e-14);
        EXPECT_NEAR(fittedRatio(n, 0.1, 0.1*n*(1 + 1e-9)), 1, 1e-8);
    }
}


TEST(fittedRatio, equalsTheRequestedRatio)
{
    for (const scalar ratio : {0.5, 0.9, 1.01, 1.2, 3.0})
    {
        const scalar thickness = totalThickness(30, 1e-5, ratio);

        // Below 1 the sum is flat in the ratio
        EXPECT_NEAR(fittedRatio(30, 1e-5, thickness), ratio, 1e-12);
    }
}


TEST(layerHeights, areAsAskedForWhereThereIsRoom)
{
    const scalarField h(heights(10, 1e-3, 1.2, GREAT));

    EXPECT_EQ(h[0], 0);
    EXPECT_NEAR(h[1], 1e-3, 1e-16);

    for (label i = 2; i <= 10; ++i)
    {
        EXPECT_NEAR((h[i] - h[i - 1])/(h[i - 1] - h[i - 2]), 1.2, 1e-12);
    }
}


TEST(layerHeights, keepTheFirstHeightWhereNLayersOfItFit)
{
    const scalarField h(heights(10, 1e-3, 1.2, 0.015));

    EXPECT_NEAR(h[1], 1e-3, 1e-16);
    EXPECT_EQ(h[10], 0.015);

    const scalar ratio = (h[2] - h[1])/h[1];
    EXPECT_GT(ratio, 1);
    EXPECT_LT(ratio, 1.2);

    for (label i = 3; i <= 10; ++i)
    {
        EXPECT_NEAR((h[i] - h[i - 1])/(h[i - 1] - h[i - 2]), ratio, 1e-10);
    }
}


TEST(layerHeights, areUniformWhereNotEvenThoseFit)
{
    const scalarField h(heights(10, 1e-3, 1.2, 0.005));

    for (label i = 0; i <= 10; ++i)
    {
        EXPECT_NEAR(h[i], 0.0005*i, 1e-16);
    }
}


TEST(layerHeights, dependContinuouslyOnTheRoom)
{
    for (const scalar ratio : {0.8, 1.0, 1.3})
    {
        const scalar asked = totalThickness(10, 1e-3, ratio);
        scalarField before(heights(10, 1e-3, ratio, 1.01*asked));

        for (label i = 0; i <= 1000; ++i)
        {
            const scalar room = (1.01 - 0.001*i)*asked;
            const scalarField h(heights(10, 1e-3, ratio, room));

            EXPECT_LT(max(mag(h - before)), 1.5e-3*asked);
            before = h;
        }
    }
}


TEST(layerHeights, growOutwards)
{
    for (const scalar room : {1e-12, 1e-4, 0.02, 1.0})
    {
        const scalarField h(heights(1000, 1e-5, 1.05, room));

        for (label i = 1; i <= 1000; ++i)
        {
            EXPECT_GT(h[i], h[i - 1]);
        }
        EXPECT_LE(h[1000], room);
    }
}


TEST(layerHeights, oneLayerIsTheRoomOrTheRequest)
{
    EXPECT_EQ(heights(1, 1e-3, 1.2, 1)[1], 1e-3);
    EXPECT_EQ(heights(1, 1e-3, 1.2, 1e-4)[1], 1e-4);
}


TEST(makeLayerSpacing, isUniformWithoutPatches)
{
    const layerSpacing spacing
    (
        spacingOf(cubeWithPatches(), controlsOf(20, 1e-4))
    );

    EXPECT_EQ(spacing.nLayers, 20);
    EXPECT_EQ(min(spacing.firstThickness), 1e-4);
    EXPECT_EQ(max(spacing.firstThickness), 1e-4);
    EXPECT_EQ(max(spacing.ratio), 1.2);
    EXPECT_NEAR(max(spacing.thickness), sumOfHeights(20, 1e-4, 1.2), 1e-15);
}


TEST(makeLayerSpacing, thinnestPatchCountsAtAPoint)
{
    const wallSurface wall(cubeWithPatches());
    layerControls controls(controlsOf(20, 1e-4));
    controls.patches = List<patchLayers>
    ({
        patchOf(keyType("wing.*", keyType::REGEX), 1e-3),
        patchOf(keyType("wingRight"), 1e-5)
    });

    const layerSpacing spacing(spacingOf(wall, controls));

    forAll(wall.points, p)
    {
        const point& x = wall.points[p];
        const bool inside =
            min(x.y(), x.z()) > 1e-9 && max(x.y(), x.z()) < 1 - 1e-9;
        const bool left = (x.x() < 1e-9), right = (x.x() > 1 - 1e-9);

        EXPECT_EQ
        (
            spacing.firstThickness[p],
            right ? 1e-5 : left && inside ? 1e-3 : 1e-4
        );
        EXPECT_EQ(spacing.ratio[p], right || (left && inside) ? 1.5 : 1.2);
    }
}


TEST(makeLayerSpacing, lastMatchWins)
{
    const wallSurface wall(cubeWithPatches());
    layerControls controls(controlsOf(20, 1e-4));
    controls.patches = List<patchLayers>
    ({
        patchOf(keyType("wingLeft"), 1e-5),
        patchOf(keyType(".*", keyType::REGEX), 1e-6)
    });

    const layerSpacing spacing(spacingOf(wall, controls));
    EXPECT_EQ(max(spacing.firstThickness), 1e-6);
}


TEST(makeLayerSpacing, entryWithoutPatchDoesNotCount)
{
    // As of a patch that a side plane has cut off
    layerControls controls(controlsOf(20, 1e-4));
    controls.patches = List<patchLayers>
    (
        1,
        patchOf(keyType("tail.*", keyType::REGEX), 1e-5)
    );
    const layerSpacing spacing(spacingOf(cubeWithPatches(), controls));

    EXPECT_EQ(min(spacing.firstThickness), 1e-4);
}


TEST(gradedSpacing, leavesOneRequestAsItIs)
{
    const wallSurface wall(cubeWithPatches());
    const layerSpacing asked(spacingOf(wall, controlsOf(20, 1e-4)));
    const layerSpacing graded
    (
        gradedSpacing(asked, makeWallAddressing(wall), 1.2)
    );

    EXPECT_EQ(graded.firstThickness, asked.firstThickness);
    EXPECT_EQ(graded.ratio, asked.ratio);
    EXPECT_EQ(graded.thickness, asked.thickness);
}


TEST(gradedSpacing, growsByTheFactorAtMost)
{
    const wallSurface wall(cubeWithPatches());
    const wallAddressing addressing(makeWallAddressing(wall));
    layerControls controls(controlsOf(20, 1e-4));
    controls.patches = List<patchLayers>
    ({
        patchOf(keyType("wingLeft"), 1e-3),
        patchOf(keyType("wingRight"), 1e-5)
    });

    const layerSpacing asked(spacingOf(wall, controls));
    const layerSpacing graded(gradedSpacing(asked, addressing, 1.2));
    label nLower = 0;

    for (const edge& e : addressing.edges)
    {
        for (const scalarField* h : {&graded.firstThickness, &graded.thickness})
        {
            const scalar a = (*h)[e.start()], b = (*h)[e.end()];
            EXPECT_LE(max(a, b), 1.2*min(a, b)*(1 + SMALL));
        }
    }

    forAll(wall.points, p)
    {
        const scalar h1 = graded.firstThickness[p];
        const bool right = wall.points[p].x() > 1 - 1e-9;

        EXPECT_LE(h1, asked.firstThickness[p]);
        EXPECT_LE(graded.thickness[p], asked.thickness[p]);
        EXPECT_TRUE(!right || h1 == asked.firstThickness[p]);
        EXPECT_NEAR
        (
            totalThickness(20, h1, graded.ratio[p])/graded.thickness[p],
            1,
            1e-10
        );
        nLower += h1 < asked.firstThickness[p];
    }

    EXPECT_GT(nLower, 10);
}


TEST(gradedSpacing, oneLayer)
{
    const wallSurface wall(cubeWithPatches());
    layerControls controls(controlsOf(1, 1e-4));
    controls.patches = List<patchLayers>(1, patchOf(keyType("wingLeft"), 1));

    const layerSpacing graded
    (
        gradedSpacing
        (
            spacingOf(wall, controls), makeWallAddressing(wall), 2
        )
    );

    EXPECT_EQ(graded.firstThickness, graded.thickness);
    EXPECT_EQ(min(graded.thickness), 1e-4);
}


// ************************************************************************* //
