/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchReport.H"
#include "testLayers.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(makeFaceHeights, equalTheHeightsOfCells)
{
    const wallSurface wall(testSurfaces::quadCube(4));
    const label n = 3;
    const scalarList levels(testSurfaces::geometricHeights(n, 0.01, 1.5));
    const prismLayers layers(testSurfaces::straightLayers(wall, levels));

    layerSpacing request;
    request.nLayers = n;
    request.firstThickness = scalarField(wall.points.size(), 0.02);
    request.ratio = scalarField(wall.points.size(), 1.2);
    request.thickness = scalarField(wall.points.size(), 0.095);

    const faceHeights heights(makeFaceHeights(wall, request, layers));
    label nExact = 0;

    forAll(wall.faces, facei)
    {
        EXPECT_NEAR(heights.areas[facei], 1.0/16, 1e-14);

        // In the middle of a side, where columns are normal to it
        const point x(wall.faces[facei].centre(wall.points));
        const label nInner =
            (mag(x.x() - 0.5) < 0.2) + (mag(x.y() - 0.5) < 0.2)
          + (mag(x.z() - 0.5) < 0.2);

        if (nInner == 2)
        {
            ++nExact;
            EXPECT_NEAR(heights.first[facei], 0.01, 1e-14);
            EXPECT_NEAR(heights.firstOverRequest[facei], 0.5, 1e-12);
            EXPECT_NEAR(heights.totalOverRequest[facei], 0.5, 1e-12);
            EXPECT_NEAR
            (
                heights.growthOverRequest[facei*(n - 1) + 1], 1.25, 1e-10
            );
        }
    }

    EXPECT_EQ(nExact, 6*4);
}


TEST(changesOverEdges, areTheLargerOverTheSmaller)
{
    const wallSurface wall(testSurfaces::quadCube(2));
    const wallAddressing addressing(makeWallAddressing(wall));
    scalarField values(wall.faces.size(), 1.0);
    values[5] = 0.25;

    label nChanges = 0;
    for (const scalar change : changesOverEdges(addressing.edgeFaces, values))
    {
        EXPECT_TRUE(change == 1 || change == 4);
        nChanges += change == 4;
    }

    EXPECT_EQ(nChanges, 4);
}


// ************************************************************************* //
