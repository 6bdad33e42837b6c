/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerColumns.H"
#include "diffusionTensor.H"
#include "testStages.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static prismLayerMesh meshOf(const wallSurface& wall)
{
    prismLayerControls controls;
    controls.layers = testSurfaces::layersOf(10, 0.3);
    controls.backgroundMesh.minSheets = 2;

    return testSurfaces::layeredMesh(wall, controls);
}


static scalarField sharesOf(const prismLayerMesh& m)
{
    return straightShares
    (
        m.share.front,
        scalarField
        (
            mag
            (
                scaledGradients
                (
                    m.guide.fields.background, m.guide.fields.isotropic
                )
            ),
            m.share.front.wallPoints
        ),
        m.guide.spacing.at(m.share.front.wallPoints).thickness
    );
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(straightShares, columnsFollowTheFieldInConcaveCorners)
{
    const wallSurface wall(testSurfaces::lBlock(12));
    const prismLayerMesh m(meshOf(wall));
    const scalarField shares(sharesOf(m));
    scalar concave = 0, convex = 0;
    label nConcave = 0, nConvex = 0;

    forAll(shares, c)
    {
        EXPECT_GE(shares[c], 0);
        EXPECT_LE(shares[c], 1);

        const pointKind kind = m.pointKinds[m.share.front.wallPoints[c]];
        if (kind == pointKind::concave)
        {
            ++nConcave;
            concave += shares[c];
        }
        if (kind == pointKind::convex)
        {
            ++nConvex;
            convex += shares[c];
        }
    }

    ASSERT_GT(nConcave, 5);
    ASSERT_GT(nConvex, 20);
    EXPECT_LT(concave/nConcave, 0.1);
    EXPECT_GT(convex/nConvex, 0.4);
}


TEST(straighten, movesSamplesByTheShares)
{
    const pointField starts({point(0, 0, 0), point(1, 0, 0)});
    const scalarField lengths(scalarList({1, 2, 1, 2}));
    const vectorField up(2, vector(0, 0, 1)), aside(2, vector(1, 0, 0));
    const gradientLines straight(makeStraightLines(starts, up, lengths));
    gradientLines lines(makeStraightLines(starts, aside, lengths));
    straighten(straight, scalarField(scalarList({0.25, 1})), lines);

    EXPECT_EQ(lines.points[1], point(1.5, 0, 0.5));
    EXPECT_EQ(lines.points[3], point(1, 0, 2));
}


// ************************************************************************* //
