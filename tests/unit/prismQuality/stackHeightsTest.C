/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/


#include "layerGeometry.H"
#include "memoryMesh.H"
#include "Random.H"
#include "testLayers.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(stackHeights, volumesOfThePolyMesh)
{
    // Warped sides: the decomposition matters
    const label n = 4;

    for (const wallSurface& wall :
        {testSurfaces::sphere(4), testSurfaces::quadSphere(4)})
    {
        prismLayers layers
        (
            testSurfaces::straightLayers
            (
                wall,
                testSurfaces::geometricHeights(n, 0.1, 1.25)
            )
        );

        Random random(1);
        for (point& p : layers.points)
        {
            p += 0.02*(random.sample01<vector>() - vector::uniform(0.5));
            p += vector(10, 20, -30);
        }

        const memoryMesh mesh(layers);
        stackHeights stack(layers);

        forAll(layers.faces, facei)
        {
            stack.compute(facei);

            for (label i = 0; i < n; ++i)
            {
                scalar area = 0;
                for (const label level : {i, i + 1})
                {
                    face f(layers.faces[facei]);
                    for (label& p : f)
                    {
                        p = layers.pointLabel(p, level);
                    }
                    area += f.mag(layers.points);
                }

                const scalar volume = mesh().cellVolumes()[facei*n + i];

                EXPECT_NEAR(0.5*stack.heights()[i]*area/volume, 1, 1e-11);
            }
        }
    }
}


// ************************************************************************* //
