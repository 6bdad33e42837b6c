/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetBoundary.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(outerTriangles, quadsAreCutWhereTheyAreHigh)
{
    // Warped by moving single corners in and out
    wallSurface surface(testSurfaces::quadCube(4, 4));
    forAll(surface.points, p)
    {
        surface.points[p] *= 1 + 0.01*(p % 3 - 1);
    }

    labelList faceOf;
    const faceList triangles(outerTriangles(surface, faceOf));
    EXPECT_EQ(triangles.size(), 2*surface.faces.size());

    wallSurface cut(surface);
    cut.faces = triangles;
    EXPECT_TRUE(testSurfaces::isClosed(cut));

    forAll(surface.faces, facei)
    {
        const face& f = triangles[2*facei];
        const face& g = triangles[2*facei + 1];
        EXPECT_EQ(faceOf[2*facei], facei);

        // No corner of the second triangle is above the first one
        for (const label p : g)
        {
            EXPECT_LE
            (
                (surface.points[p] - surface.points[f[0]])
              & f.areaNormal(surface.points),
                1e-12
            );
        }
    }
}


TEST(outerTriangles, trianglesStay)
{
    const wallSurface surface(testSurfaces::cube(2));
    labelList faceOf;

    EXPECT_EQ(outerTriangles(surface, faceOf), surface.faces);
    EXPECT_EQ(faceOf, identity(surface.faces.size()));
}


TEST(pointBelow, isInACellThatLeansAtItsFirstPoint)
{
    // The plane of the first triangle is z = 1 + y: the point below its first
    // corner is in front of it
    prismLayers layers;
    layers.nLayers = 1;
    layers.points = pointField
    ({
        {0, -0.3, 0.8}, {0, 0, 1}, {1, 0, 0.8}, {1, 0, 1},
        {1, 1, 0.8}, {1, 1, 2}, {0, 1, 0.8}, {0, 1, 1}
    });
    layers.faces = faceList({face({0, 1, 2, 3})});

    for (const face& f : {face({0, 1, 2}), face({1, 2, 0}), face({2, 0, 1})})
    {
        const point x(pointBelow(f, layers));
        EXPECT_LT(x.z(), 1 + x.y());
    }
}


// ************************************************************************* //
