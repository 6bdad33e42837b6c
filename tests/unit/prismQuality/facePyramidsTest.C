/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "memoryMesh.H"
#include "prismQuality.H"
#include "testLayers.H"
#include "testSurfaces.H"
#include "Random.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static const label nLevels = 3;

//- Layers whose points are off by up to a share of the layer's height
static prismLayers shaken(const wallSurface& wall, const scalar share)
{
    prismLayers layers
    (
        testSurfaces::straightLayers
        (
            wall, testSurfaces::geometricHeights(nLevels, 0.05, 1.2)
        )
    );

    Random random(5);
    for (point& p : layers.points)
    {
        p += 0.1*share*(random.sample01<vector>() - vector::uniform(0.5));
    }

    return layers;
}


//- Front faces with a cell of the mesh whose centre is not inside
static boolList outlying(const polyMesh& mesh, const label nFrontFaces)
{
    boolList found(nFrontFaces, false);

    forAll(mesh.cells(), celli)
    {
        for (const label facei : mesh.cells()[celli])
        {
            const vector outwards = mesh.faceOwner()[facei] == celli
              ? mesh.faceAreas()[facei] : -mesh.faceAreas()[facei];

            if
            (
                (
                    outwards
                  & (mesh.faceCentres()[facei] - mesh.cellCentres()[celli])
                ) < 0
            )
            {
                found[celli/nLevels] = true;
            }
        }
    }

    return found;
}


TEST(isFlatStack, cellsAMillionTimesLongerThanWideHaveAVolume)
{
    const auto nFlat = [](const scalar width)
    {
        wallSurface wall(testSurfaces::cube(1));
        for (point& p : wall.points)
        {
            p.x() *= width;
        }

        return certify
        (
            testSurfaces::straightLayers
            (
                wall, testSurfaces::geometricHeights(nLevels, width, 1)
            )
        ).flatStacks.size();
    };

    EXPECT_EQ(nFlat(1e-6), 0);
    // A solver's volumes of such cells are of either sign, whatever the order
    // of their points
    EXPECT_GT(nFlat(1e-9), 0);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(facePyramids, agreeWithPolyMesh)
{
    label nOutlying = 0, nInside = 0;

    for (const wallSurface& wall :
        {testSurfaces::sphere(4), testSurfaces::quadSphere(4)})
    {
        for (const scalar share : {0.2, 1.0, 2.0})
        {
            const prismLayers layers(shaken(wall, share));
            const memoryMesh mesh(layers);
            const boolList expected(outlying(mesh(), layers.faces.size()));

            forAll(layers.faces, facei)
            {
                EXPECT_NE(hasPositivePyramids(layers, facei), expected[facei]);
                nOutlying += expected[facei];
                nInside += !expected[facei];
            }

            EXPECT_EQ
            (
                certify(layers).outlyingCentres, findIndices(expected, true)
            );
        }
    }

    EXPECT_GT(nOutlying, 20);
    EXPECT_GT(nInside, 20);
}


TEST(facePyramids, areTheSameFarAway)
{
    prismLayers layers(shaken(testSurfaces::quadSphere(4), 1));
    boolList expected(layers.faces.size());
    forAll(expected, facei)
    {
        expected[facei] = hasPositivePyramids(layers, facei);
    }

    for (point& p : layers.points)
    {
        p += vector(10, 20, -30);
    }

    forAll(expected, facei)
    {
        EXPECT_EQ(hasPositivePyramids(layers, facei), expected[facei]);
    }
}


TEST(facePyramids, noneInCellsWithoutVolume)
{
    for (const scalar height : {0.0, -0.05})
    {
        const prismLayers layers
        (
            testSurfaces::straightLayers
            (
                testSurfaces::cube(2), scalarList({0, height})
            )
        );

        forAll(layers.faces, facei)
        {
            EXPECT_FALSE(hasPositivePyramids(layers, facei));
        }
    }
}


TEST(isFlatStack, layersOfTheHeightOfRoundingAreFlat)
{
    // Far from the origin coordinates are rounded to 1e-13
    const wallSurface wall
    (
        testSurfaces::translated(testSurfaces::cube(2), vector(1000, 0, 0))
    );
    const auto nFlat = [&](const scalar height)
    {
        return certify
        (
            testSurfaces::straightLayers
            (
                wall, testSurfaces::geometricHeights(nLevels, height, 1)
            )
        ).flatStacks.size();
    };

    EXPECT_EQ(nFlat(0.01), 0);
    EXPECT_EQ(nFlat(1e-9), 0);
    EXPECT_EQ(nFlat(1e-13), wall.faces.size());
}


// ************************************************************************* //
