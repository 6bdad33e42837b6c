/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerSpacing.H"
#include "testSurfaces.H"
#include "thrownMessage.H"
#include "OStringStream.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static patchLayers entryFor(const char* name, const heightEntries& heights)
{
    patchLayers entry;
    entry.patches = keyType(name);
    entry.heights = heights;

    return entry;
}


//- A cube of quads with patches low (z < 0.5), high and top (z = 1)
static wallSurface parts(const label n)
{
    wallSurface wall(testSurfaces::quadCube(n));
    wall.patchNames = wordList({"low", "high", "top"});

    forAll(wall.faces, facei)
    {
        const scalar z = wall.faces[facei].centre(wall.points).z();
        wall.patchIDs[facei] = z < 0.5 ? 0 : z < 1 - 1e-9 ? 1 : 2;
    }

    return wall;
}


static layerControls localControls(const label n, const scalar h1)
{
    layerControls controls;
    controls.heights.nSurfaceLayers = n;
    controls.heights.firstLayerThickness = h1;
    controls.heights.expansionRatio = 1.2;

    return controls;
}


static layerSpacing localSpacing
(
    const wallSurface& wall,
    const layerControls& controls,
    const localHeights& local = localHeights()
)
{
    return makeLayerSpacing(wall, makeWallAddressing(wall), controls, local);
}


static std::string errorOf
(
    const wallSurface& wall,
    const layerControls& controls,
    const localHeights& local = localHeights()
)
{
    return thrownMessage<error>([&]() { localSpacing(wall, controls, local); });
}


//- Points with x < 0.5, in one region
static localHeights halfRegion(const wallSurface& wall)
{
    localHeights local;
    local.inRegion.setSize(1);

    for (const point& x : wall.points)
    {
        local.inRegion[0].append(x.x() < 0.5);
    }

    return local;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(localEdgeLengths, areMeansThatGrowByTheFactor)
{
    // A stretched cube: edges of 1 along x, 0.25 along the others
    wallSurface wall(testSurfaces::quadCube(4));
    const wallAddressing addressing(makeWallAddressing(wall));

    for (const scalar length : localEdgeLengths(wall, addressing, 100))
    {
        EXPECT_NEAR(length, 0.25, 1e-14);
    }

    for (point& x : wall.points)
    {
        x.x() *= 4;
    }

    const scalarField free(localEdgeLengths(wall, addressing, 100));
    const scalarField bounded(localEdgeLengths(wall, addressing, 1.1));

    EXPECT_NEAR(min(free), 0.25, 1e-14);
    EXPECT_NEAR(max(free), 0.625, 1e-14);

    for (const edge& e : addressing.edges)
    {
        const scalar a = bounded[e.start()], b = bounded[e.end()];
        EXPECT_LE(max(a, b), 1.1*min(a, b)*(1 + SMALL));
    }
}


TEST(makeLayerSpacing, relativeSizesAreMultiplesOfEdges)
{
    const wallSurface wall(parts(4));
    layerControls controls(localControls(10, 0.1));
    controls.heights.relativeSizes = true;

    const layerSpacing spacing(localSpacing(wall, controls));

    EXPECT_NEAR(min(spacing.firstThickness), 0.025, 1e-14);
    EXPECT_NEAR(max(spacing.firstThickness), 0.025, 1e-14);
}


TEST(makeLayerSpacing, relativeSizesAreMultiplesOfSmallerCells)
{
    const wallSurface wall(parts(4));
    layerControls controls(localControls(10, 0.1));
    controls.heights.relativeSizes = true;

    localHeights local;
    local.largestCells = scalarField(wall.points.size(), GREAT);
    local.largestCells[3] = 0.1;
    const layerSpacing spacing(localSpacing(wall, controls, local));

    EXPECT_NEAR(spacing.firstThickness[3], 0.01, 1e-14);
    EXPECT_NEAR(max(spacing.firstThickness), 0.025, 1e-14);
}


TEST(makeLayerSpacing, metresAndRelativeSizesMix)
{
    const wallSurface wall(parts(4));
    layerControls controls(localControls(10, 1));

    heightEntries relative;
    relative.relativeSizes = true;
    relative.finalLayerThickness = 0.5;
    controls.patches = List<patchLayers>(1, entryFor("top", relative));

    const layerSpacing spacing(localSpacing(wall, controls));

    forAll(wall.points, p)
    {
        EXPECT_NEAR
        (
            spacing.firstThickness[p],
            wall.points[p].z() > 1 - 1e-9 ? 0.125/std::pow(1.2, 9) : 1,
            1e-14
        );
    }
}


TEST(makeLayerSpacing, regionsChangeWhatPatchesHave)
{
    const wallSurface wall(parts(4));
    layerControls controls(localControls(10, 1e-3));

    heightEntries first, ratio;
    first.firstLayerThickness = 1e-4;
    ratio.expansionRatio = 1.5;
    controls.patches = List<patchLayers>(1, entryFor("top", first));
    controls.regions.setSize(1);
    controls.regions[0].name = "half";
    controls.regions[0].heights = ratio;

    const layerSpacing spacing(localSpacing(wall, controls, halfRegion(wall)));

    forAll(wall.points, p)
    {
        const point& x = wall.points[p];

        EXPECT_EQ(spacing.firstThickness[p], x.z() > 1 - 1e-9 ? 1e-4 : 1e-3);
        EXPECT_NEAR(spacing.ratio[p], x.x() < 0.5 ? 1.5 : 1.2, 1e-14);
    }
}


TEST(makeLayerSpacing, regionWithoutPointsIsRefused)
{
    const wallSurface wall(parts(2));
    layerControls controls(localControls(10, 1e-3));
    controls.regions.setSize(1);
    controls.regions[0].name = "nowhere";

    localHeights local(halfRegion(wall));
    local.inRegion[0] = false;

    EXPECT_NE
    (
        errorOf(wall, controls, local).find("in the region nowhere"),
        std::string::npos
    );
}


TEST(makeLayerSpacing, valuesOfFilesReplaceGeneralOnes)
{
    const wallSurface wall(parts(4));
    const layerControls controls(localControls(10, 1));

    localHeights local;
    for (const point& x : wall.points)
    {
        local.firstThickness.append(1e-3*(1 + x.x()));
    }

    const layerSpacing first(localSpacing(wall, controls, local));
    EXPECT_EQ(first.firstThickness, local.firstThickness);
    EXPECT_NEAR(min(first.ratio), 1.2, 1e-14);

    // With the sum of heights too the ratio follows
    local.thickness = 20*local.firstThickness;
    const layerSpacing both(localSpacing(wall, controls, local));
    EXPECT_EQ(both.firstThickness, local.firstThickness);
    EXPECT_NEAR(max(mag(both.thickness/local.thickness - 1)), 0, 1e-12);
    EXPECT_NEAR(max(both.ratio) - min(both.ratio), 0, 1e-12);

    // The sum alone keeps the ratio
    local.firstThickness.clear();
    const layerSpacing total(localSpacing(wall, controls, local));
    EXPECT_NEAR(max(mag(total.thickness/local.thickness - 1)), 0, 1e-12);
    EXPECT_NEAR(max(total.ratio), 1.2, 1e-14);
}


TEST(makeLayerSpacing, valuesOutOfBoundsNameThePlace)
{
    const wallSurface wall(parts(2));
    localHeights local;
    local.firstThickness = scalarField(wall.points.size(), 1e-3);
    local.thickness = scalarField(wall.points.size(), 1e-2);
    local.thickness[7] = 1e-4;

    OStringStream place;
    place << wall.points[7];

    const std::string message(errorOf(wall, localControls(10, 1), local));
    EXPECT_NE(message.find(place.str()), std::string::npos) << message;
    EXPECT_NE(message.find("thickness is 0.0001"), std::string::npos);
}


TEST(makeLayerSpacing, fewerLayersKeepFirstHeightAndThickness)
{
    const wallSurface wall(parts(4));
    layerControls controls(localControls(20, 1e-3));

    heightEntries ten, three;
    ten.nSurfaceLayers = 15;
    three.nSurfaceLayers = 3;
    controls.patches = List<patchLayers>
    ({
        entryFor("top", ten), entryFor("low", three)
    });

    const layerSpacing spacing(localSpacing(wall, controls));

    EXPECT_EQ(spacing.nLayers, 20);
    EXPECT_EQ(min(spacing.firstThickness), 1e-3);
    EXPECT_EQ(max(spacing.firstThickness), 1e-3);

    forAll(wall.points, p)
    {
        const scalar z = wall.points[p].z();

        if (z > 1 - 1e-9)
        {
            EXPECT_EQ(spacing.layersAsked[p], 15);
            EXPECT_NEAR
            (
                spacing.thickness[p]/totalThickness(15, 1e-3, 1.2), 1, 1e-12
            );
            EXPECT_GT(spacing.ratio[p], 1);
        }
        else if (z < 0.51)
        {
            // 20 heights would not fit into three layers' thickness
            EXPECT_EQ(spacing.layersAsked[p], 3);
            EXPECT_EQ(spacing.ratio[p], 1);
            EXPECT_NEAR(spacing.thickness[p], 0.02, 1e-14);
        }
        else
        {
            EXPECT_EQ(spacing.layersAsked[p], 20);
            EXPECT_NEAR(spacing.ratio[p], 1.2, 1e-14);
        }
    }
}


TEST(makeLayerSpacing, automaticNumberReachesTheLengthOfEdges)
{
    const wallSurface wall(testSurfaces::quadCube(4));
    layerControls controls(localControls(0, 1e-3));
    controls.finalAspect = 0.5;

    const layerSpacing spacing(localSpacing(wall, controls));
    const label n = spacing.nLayers;

    // 1.2^26 = 114.5 < 125 < 137.4 = 1.2^27
    EXPECT_EQ(n, 28);

    forAll(wall.points, p)
    {
        EXPECT_EQ(spacing.firstThickness[p], 1e-3);
        EXPECT_NEAR
        (
            spacing.firstThickness[p]*std::pow(spacing.ratio[p], n - 1),
            0.125,
            1e-12
        );
    }
}


TEST(makeLayerSpacing, automaticNumberNeedsGrowth)
{
    const wallSurface wall(testSurfaces::quadCube(2));
    layerControls controls(localControls(0, 1e-3));
    controls.heights.expansionRatio = 1;

    EXPECT_NE
    (
        errorOf(wall, controls).find("must be more than 1"), std::string::npos
    );
}


TEST(describe, saysPatchesAndWhatYPlusGives)
{
    const wallSurface wall(parts(2));
    layerControls controls(localControls(10, 1e-3));
    controls.heights.yPlus = 1;
    controls.heights.Re = 2e6;

    const std::string text
    (
        describe(localSpacing(wall, controls), wall, controls)
    );

    EXPECT_NE(text.find("y+ 1"), std::string::npos) << text;
    EXPECT_NE(text.find("Re 2e+06"), std::string::npos) << text;
    EXPECT_NE(text.find("top: layers 10, first height 0.001 m"),
        std::string::npos) << text;
}


TEST(makeLayerSpacing, heightsOfARunTakeThePlaceOfTheFirstHeight)
{
    const wallSurface wall(parts(4));
    layerControls controls;
    controls.heights.nSurfaceLayers = 5;
    controls.fromRun.target = 1;
    controls.fromRun.folder = "run";
    localHeights local;
    local.firstThickness = scalarField(wall.points.size(), 0.01);

    const auto spacingOf = [&]()
    {
        return localSpacing(wall, controls, local);
    };

    // With the ratio that is given, or its default
    EXPECT_NEAR(spacingOf().ratio[0], 1.2, 1e-14);
    controls.heights.expansionRatio = 1.3;
    EXPECT_NEAR(spacingOf().ratio[0], 1.3, 1e-14);
    EXPECT_EQ(spacingOf().firstThickness[0], 0.01);

    // With a thickness that is given, or was before
    controls.heights.expansionRatio = 0;
    controls.heights.thickness = 0.1;
    EXPECT_NEAR(spacingOf().thickness[0], 0.1, 1e-14);
    local.thickness = scalarField(wall.points.size(), 0.2);
    EXPECT_NEAR(spacingOf().thickness[0], 0.2, 1e-14);
    EXPECT_EQ(spacingOf().firstThickness[0], 0.01);

    local.thickness = 0.005;
    expectWords
    (
        thrownMessage<error>(spacingOf),
        {
            "at the point", "with yPlus, thickness and 5 layers", "0.01",
            "that of the earlier mesh"
        }
    );
}


// ************************************************************************* //
