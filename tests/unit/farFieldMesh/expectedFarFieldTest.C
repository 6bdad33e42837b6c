/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "expectedFarField.H"
#include "farFieldMeshControls.H"
#include "mathematicalConstants.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The unit sphere, and layers of a thickness on it
struct ballInFarField
{
    const wallSurface wall;
    const scalar radius;
    farFieldControls controls;

    ballInFarField(const label n, const scalar thickness)
    :
        wall(testSurfaces::sphere(n)),
        radius(1 + thickness)
    {
        controls.type = farFieldType::tet;
        controls.growthRate = 1.2;
    }

    scalar expectedCells() const
    {
        farFieldDomain domain;
        domain.boundary = makeFarBoundary
        (
            controls.boundary, [](const fileName& file) { return file; }
        );
        domain.bounds.largest = controls.maxCellSize;

        return expectedFarCells(wall, radius*wall.points, domain, controls);
    }

    //- The mean length of the edges of the outer surface of the layers
    scalar size() const
    {
        return radius*average(meanEdges(wall, makeWallAddressing(wall)));
    }
};


static scalar ballVolume(const scalar radius)
{
    return 4.0/3*constant::mathematical::pi*pow3(radius);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(expectedFarCells, fillABoxWithCellsOfOneSize)
{
    ballInFarField ball(6, 0.3);
    const scalar size = 0.13;
    ASSERT_GT(ball.size(), size);
    ball.controls.maxCellSize = size;
    ball.controls.boundary.type = farBoundaryType::box;
    ball.controls.boundary.box =
        boundBox(point::uniform(-2), point::uniform(2));

    // The surface has flat faces: a few per cent less volume than a sphere
    const scalar n =
        farFieldTuned.tetsPerCube*(64 - ballVolume(1.3))/pow3(size);
    EXPECT_NEAR(ball.expectedCells(), n, 0.03*n);

    ball.controls.type = farFieldType::hexCore;
    const scalar hexes = n*farFieldTuned.hexesPerCube/farFieldTuned.tetsPerCube;
    EXPECT_NEAR
    (
        ball.expectedCells(),
        hexes + farFieldTuned.tetsPerCoreFace*ball.wall.faces.size(),
        0.03*hexes
    );
}


TEST(expectedFarCells, areTheIntegralOverGrowingSizes)
{
    ballInFarField ball(8, 0.3);
    const scalar outer = 3;
    ball.controls.boundary.type = farBoundaryType::sphere;
    ball.controls.boundary.radius = outer;

    const label nShells = 1000;
    const scalar width = (outer - ball.radius)/nShells;
    scalar nCubes = 0;
    for (label i = 0; i < nShells; ++i)
    {
        const scalar depth = (i + 0.5)*width;
        const scalar size = ball.size() + 0.2*depth;
        nCubes +=
            (
                ballVolume(ball.radius + depth + 0.5*width)
              - ballVolume(ball.radius + depth - 0.5*width)
            )/pow3(size);
    }

    // Edges of the wall differ by some ten per cent
    const scalar n = farFieldTuned.tetsPerCube*nCubes;
    EXPECT_NEAR(ball.expectedCells(), n, 0.08*n);
}


TEST(expectedFarCells, areNoneWithoutAFarField)
{
    ballInFarField ball(4, 0.3);
    ball.controls.type = farFieldType::none;

    EXPECT_EQ
    (
        expectedFarCells
        (
            ball.wall, ball.wall.points, farFieldDomain(), ball.controls
        ),
        0
    );
}


// ************************************************************************* //
