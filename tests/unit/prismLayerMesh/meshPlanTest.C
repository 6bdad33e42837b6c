/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshPlan.H"
#include "prismLayerMesh.H"
#include "testStages.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static meshPlan planOf
(
    const wallSurface& wall,
    const prismLayerControls& controls
)
{
    return makeMeshPlan(wall, controls, localHeights(), farFieldDomain(), 1);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(meshPlan, hasTheLayersOfTheMeshWithMultipleNormals)
{
    const wallSurface wall(testSurfaces::wedgeBlock(3, 30));
    prismLayerControls controls;
    controls.layers = testSurfaces::layersOf(4, 0.02);
    controls.layers.multipleNormalsAngle = 60;
    const meshPlan plan(planOf(wall, controls));

    EXPECT_GT(plan.nFrontFaces, wall.faces.size());
    EXPECT_EQ
    (
        plan.nLayerCells(),
        testSurfaces::layeredMesh(wall, controls).certificate.nCells
    );
}


TEST(meshPlan, hasAColumnOfPolygonsOnEachPoint)
{
    const wallSurface wall(testSurfaces::sphere(5));
    prismLayerControls controls;
    controls.layers = testSurfaces::layersOf(4, 0.1);
    controls.polygons = true;

    EXPECT_EQ(planOf(wall, controls).nLayerCells(), 4*wall.points.size());
}


TEST(meshPlan, hasACostForEachCellAndThread)
{
    meshPlan plan;
    plan.nWallFaces = 1000;
    plan.nFrontFaces = 1000;
    plan.nLayers = 10;
    const scalar bytes = plan.peakBytes();
    const scalar seconds = plan.seconds();
    plan.nThreads = 2;
    EXPECT_NEAR
    (
        plan.seconds(), (1 - 0.5*planTuned.parallelShare)*seconds, 1e-12
    );

    plan.nThreads = 1;
    plan.farCells = 1e6;
    EXPECT_NEAR
    (
        plan.peakBytes() - bytes, 1e6*planTuned.bytesPerFarCell, 1
    );
    EXPECT_NEAR
    (
        plan.seconds() - seconds, 1e6*planTuned.secondsPerFarCell, 1e-9
    );
}


// ************************************************************************* //
