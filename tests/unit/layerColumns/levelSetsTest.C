/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "levelSetReport.H"
#include "levelSets.H"
#include "openSurfaces.H"
#include "patchReport.H"
#include "ranges.H"
#include "testStages.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static const label nLayers = 6;
static const scalar thickness = 0.2;


static prismLayerControls onLevelSets(const word& tensor = "anisotropic")
{
    prismLayerControls controls;
    controls.layers = testSurfaces::layersOf(nLayers, thickness);
    controls.layers.onLevelSets = true;
    controls.field.tensor = tensor;
    controls.backgroundMesh.minSheets = 3;

    return controls;
}


//- A ball, of which one half is to have other heights
struct halfBall
{
    wallSurface wall;
    prismLayerMesh mesh;

    explicit halfBall(const scalar factor)
    :
        wall(testSurfaces::sphere(16)),
        mesh(make(wall, factor))
    {}

    static prismLayerMesh make(const wallSurface& wall, const scalar factor)
    {
        prismLayerControls controls(onLevelSets());
        controls.layers.regions.setSize(1);
        layerRegion& region = controls.layers.regions[0];
        region.name = "half";
        region.heights.thickness = factor*thickness;
        region.heights.expansionRatio = 1.2;

        localHeights local;
        local.inRegion.setSize(1);
        for (const point& x : wall.points)
        {
            local.inRegion[0].append(x.z() > 0);
        }

        return testSurfaces::layeredMesh(wall, controls, local);
    }

    //- Mean thickness of the level sets around a pole over what is asked for
    //  without a factor
    scalar thicknessAt(const scalar z) const
    {
        scalar sum = 0;
        label n = 0;

        forAll(wall.points, p)
        {
            if (mag(wall.points[p].z() - z) < 0.15)
            {
                sum += mesh.guide.spacing.thickness[p]/thickness;
                ++n;
            }
        }

        return sum/n;
    }
};


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(levelSets, uniformSpacingIsTheLargest)
{
    layerSpacing spacing;
    spacing.nLayers = 4;
    spacing.firstThickness = scalarField(scalarList({0.1, 0.2}));
    spacing.thickness = scalarField(scalarList({1.2, 1}));
    spacing.ratio = scalarField(2, 1.1);

    const layerSpacing uniform(uniformSpacing(spacing));

    for (label p = 0; p < 2; ++p)
    {
        EXPECT_EQ(uniform.firstThickness[p], 0.2);
        EXPECT_EQ(uniform.thickness[p], 1.2);
        EXPECT_NEAR(totalThickness(4, 0.2, uniform.ratio[p]), 1.2, 1e-9);
    }
}


TEST(levelSets, haveTheHeightsAskedForOnASphere)
{
    const wallSurface wall(testSurfaces::sphere(16));
    const prismLayerMesh m(testSurfaces::layeredMesh(wall, onLevelSets()));

    ASSERT_EQ(m.guide.fields.failure, "");
    EXPECT_TRUE(m.columns.onLevelSets);

    const faceHeights heights
    (
        makeFaceHeights(wall, m.request, m.made.layers)
    );
    scalarField first(heights.firstOverRequest), all(heights.totalOverRequest);
    const percentiles spread(makePercentiles(all));
    const percentiles firstSpread(makePercentiles(first));

    EXPECT_NEAR(spread.p50, 1, 0.03);
    EXPECT_GT(spread.p5, 0.8);
    EXPECT_LT(spread.p95, 1.2);
    EXPECT_NEAR(firstSpread.p50, 1, 0.05);
    EXPECT_TRUE(m.certificate.valid());
}


TEST(levelSets, haveTheHeightsAskedForOnAWallThatEnds)
{
    // Lines at the inlet and the outlet stay in these planes
    const wallSurface wall
    (
        testSurfaces::endedOn
        (
            testSurfaces::duct(20), wordList({"inlet", "outlet"})
        )
    );
    prismLayerControls controls(onLevelSets());
    controls.layers = testSurfaces::layersOf(nLayers, 0.05);
    controls.layers.onLevelSets = true;
    const prismLayerMesh mesh(testSurfaces::layeredMesh(wall, controls));

    EXPECT_NEAR(medianOf(mesh.guide.spacing.thickness)/0.05, 1, 0.05);
    EXPECT_GT(min(mesh.guide.spacing.thickness)/0.05, 0.5);
}


TEST(levelSets, energiesDescend)
{
    const wallSurface wall(testSurfaces::lBlock(6));
    const prismLayerMesh m(testSurfaces::layeredMesh(wall, onLevelSets()));
    const scalarField energies
    (
        samplingEnergies
        (
            m.guide.fields.background, m.guide.field, m.visibility.axes(),
            m.pointKinds,
            uniformSpacing(m.request)
        )
    );

    EXPECT_LT(energies[0], 1);
    for (label i = 1; i < nLayers; ++i)
    {
        EXPECT_LT(energies[i], energies[i - 1]);
    }
    EXPECT_GT(energies.last(), 0);
}


//- Least part of the height of their last level set that columns have on
//  concave edges and beside them
static scalar leastReachedInCorners(const wallSurface& wall, const word& tensor)
{
    const prismLayerMesh m
    (
        testSurfaces::layeredMesh(wall, onLevelSets(tensor))
    );
    scalar least = GREAT;

    forAll(wall.points, p)
    {
        if (m.pointKinds[p] != pointKind::concave)
        {
            continue;
        }
        for (const label q : m.addressing.pointPoints[p])
        {
            const vector column
            (
                m.made.layers(q, nLayers) - m.made.layers(q, 0)
            );
            least = min
            (
                least,
                m.visibility.heightCosine(q, column)
               /m.guide.spacing.thickness[q]
            );
        }
    }

    return least;
}


TEST(levelSets, layersReachThemInTheCornersOfASlit)
{
    // A quarter of two thicknesses wide: lines must end on the sheet in it
    const wallSurface wall(testSurfaces::slitBlock(12, 0.1));

    EXPECT_GT(leastReachedInCorners(wall, "isotropic"), 0.9);
    EXPECT_GT(leastReachedInCorners(wall, "anisotropic"), 0.9);
}


TEST(levelSets, everyLayerIsOnItsLevelSet)
{
    // Above a sphere lines are straight: the field at every layer of the
    // spacing before smoothing has its energy
    const wallSurface wall(testSurfaces::sphere(16));
    const prismLayerMesh m(testSurfaces::layeredMesh(wall, onLevelSets()));
    const layerSpacing uniform(uniformSpacing(m.request));
    const backgroundMesh& mesh = m.guide.fields.background;
    const vectorField axes(m.visibility.axes());
    const scalarField energies
    (
        samplingEnergies(mesh, m.guide.field, axes, m.pointKinds, uniform)
    );
    const layerSpacing sets
    (
        levelSetSpacing(mesh, m.guide.field, m.visibility, energies, uniform)
    );
    ASSERT_EQ(sets.given.size(), wall.points.size()*nLayers);
    const gradientLines lines
    (
        makeGradientLines
        (
            mesh, m.guide.field, identity(mesh.nWallPoints), axes, sets.given
        )
    );

    forAll(lines.energies, i)
    {
        EXPECT_NEAR(lines.energies[i], energies[i % nLayers], 0.02);
    }
}


TEST(levelSets, smoothingKeepsUniformHeights)
{
    const wallSurface wall(testSurfaces::cube(6));
    layerSpacing spacing;
    spacing.nLayers = 2;
    spacing.thickness = scalarField(wall.points.size(), 1);
    spacing.firstThickness = spacing.thickness;
    spacing.ratio = spacing.thickness;
    spacing.given.setSize(2*wall.points.size());
    forAll(spacing.given, i)
    {
        spacing.given[i] = i % 2 ? 0.3 : 0.1;
    }
    scalarField& heights = spacing.given;
    heights[2*40] = 0.2;
    heights[2*40 + 1] = 0.6;

    const layerSpacing smoothed
    (
        smoothedSpacing(spacing, wall, makeWallAddressing(wall), 0.3)
    );

    // The peak is lower, nothing is outside of what was there, and layers
    // stay in proportion
    EXPECT_LT(smoothed.given[2*40], 0.19);
    forAll(smoothed.thickness, p)
    {
        EXPECT_GE(smoothed.given[2*p], 0.1 - SMALL);
        EXPECT_NEAR(smoothed.given[2*p + 1]/smoothed.given[2*p], 3, 1e-9);
        EXPECT_EQ(smoothed.thickness[p], smoothed.given[2*p + 1]);
        EXPECT_EQ(smoothed.firstThickness[p], smoothed.given[2*p]);
    }
}


TEST(levelSets, tensorsMakeThemMoreEvenInAConcaveCorner)
{
    // Between the wall and the last one they are homeomorphic
    const wallSurface wall(testSurfaces::lBlock(16));
    const label concave = int(pointKind::concave);
    List<scalar> first;

    for (const word model : {"isotropic", "anisotropic", "gradientPower"})
    {
        prismLayerControls controls(onLevelSets(model));
        controls.layers = testSurfaces::layersOf(10, 0.3);
        const prismLayerMesh m(testSurfaces::layeredMesh(wall, controls));

        ASSERT_TRUE(hasLevelSetReport(m));
        const levelSetReport report(makeLevelSetReport(m));
        first.append(report.firstOfKind[concave].mean);
        EXPECT_EQ(report.nSaddles, 0);
        EXPECT_TRUE(report.lastLikeWall);
    }

    EXPECT_GT(first[0], 1);
    EXPECT_LT(first[1], 0.8*first[0]);
    EXPECT_LT(mag(std::log(first[2])), 0.5*mag(std::log(first[0])));
}


TEST(localConductivity, movesLevelSetsToLocalHeights)
{
    for (const scalar factor : {0.7, 0.5})
    {
        const halfBall ball(factor);

        EXPECT_NEAR(ball.thicknessAt(-0.85), 1, 0.05);
        EXPECT_NEAR(ball.thicknessAt(0.85), factor, 0.15*factor);
        EXPECT_TRUE(ball.mesh.certificate.valid());
    }
}


TEST(localConductivity, theChangeIsSmooth)
{
    const halfBall ball(0.5);
    scalarField changes
    (
        changesOverEdges
        (
            ball.mesh.addressing.edgeFaces,
            makeFaceHeights
            (
                ball.wall, ball.mesh.request, ball.mesh.made.layers
            )
           .first
        )
    );

    EXPECT_LT(makePercentiles(changes).p99, 1.3);
}


TEST(localConductivity, areNoneWhereHeightsAreTheSame)
{
    const halfBall ball(1);
    const prismLayerMesh plain
    (
        testSurfaces::layeredMesh(ball.wall, onLevelSets())
    );

    EXPECT_EQ(ball.mesh.guide.field, plain.guide.field);
}


// ************************************************************************* //
