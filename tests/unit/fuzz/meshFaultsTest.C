/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "embeddingFault.H"
#include "meshFaults.H"
#include "testLayers.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static prismLayers layersOn(const wallSurface& wall)
{
    return testSurfaces::straightLayers
    (
        wall, testSurfaces::geometricHeights(4, 0.02, 1.2)
    );
}


static void expectFault(const std::string& fault, const char* what)
{
    EXPECT_NE(fault.find(what), std::string::npos) << fault;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(meshFaults, goodLayersHaveNone)
{
    for
    (
        const wallSurface& wall
      : {testSurfaces::cube(3), testSurfaces::quadCube(3)}
    )
    {
        EXPECT_EQ(findMeshFault(wall, layersOn(wall)), "");
        EXPECT_EQ(findEmbeddingFault(wall, layersOn(wall)), "");
    }
}


TEST(meshFaults, cellTurnedInsideOut)
{
    const wallSurface wall(testSurfaces::quadCube(3));
    prismLayers layers(layersOn(wall));
    layers.points[layers.pointLabel(5, 2)] =
        2*layers(5, 0) - layers(5, 3);

    expectFault(findMeshFault(wall, layers), "volume");
}


TEST(meshFaults, pointOfTheWallMoved)
{
    const wallSurface wall(testSurfaces::quadCube(3));
    prismLayers layers(layersOn(wall));
    layers.points[layers.pointLabel(5, 0)] += vector(1e-6, 2e-6, 3e-6);

    expectFault(findMeshFault(wall, layers), "between wall and outer surface");
}


TEST(meshFaults, faceWithoutLayers)
{
    const wallSurface wall(testSurfaces::quadCube(3));
    prismLayers layers(layersOn(wall));
    layers.faces.setSize(layers.faces.size() - 1);
    layers.patchIDs.setSize(layers.faces.size());

    expectFault(findMeshFault(wall, layers), "53 faces on the wall");
}


TEST(meshFaults, outerSurfacesThatMeet)
{
    const wallSurface cube(testSurfaces::quadCube(3));
    const wallSurface wall
    (
        testSurfaces::merge
        (
            cube, testSurfaces::translated(cube, vector(1.1, 0.01, 0.02))
        )
    );

    EXPECT_EQ(findMeshFault(wall, layersOn(wall)), "");
    expectFault(findEmbeddingFault(wall, layersOn(wall)), "self-intersecting");
}


// ************************************************************************* //
