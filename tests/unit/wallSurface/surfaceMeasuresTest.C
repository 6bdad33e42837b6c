/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceMeasures.H"
#include "openSurfaces.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(surfaceMeasures, ofACubeOfHalvedSquares)
{
    const surfaceMeasures measures(measuresOf(cube(3, 2)));

    EXPECT_NEAR(measures.area, 24, 1e-12);
    EXPECT_NEAR(measures.volume, 8, 1e-12);
    EXPECT_NEAR(measures.smallestAngle, 45, 1e-10);
    EXPECT_EQ(measures.shareWithSmallAngles, 0);
}


TEST(surfaceMeasures, openSurfaceHasNoVolume)
{
    EXPECT_EQ(measuresOf(halfCube(2)).volume, 0);
}


TEST(surfaceMeasures, anglesAreThoseOfEachFace)
{
    wallSurface surface;
    surface.points = pointField({Zero, {1, 0, 0}, {1, 1, 0}, {0, 2, 0}});
    surface.faces = faceList({face({0, 1, 2}), face({0, 2, 3})});

    const scalarField angles(measuresOf(surface).angles);

    EXPECT_NEAR(angles[0], 45, 1e-10);
    EXPECT_NEAR(angles[1], 45, 1e-10);
}


TEST(surfaceMeasures, countNeedles)
{
    wallSurface surface(cube(1));
    for (point& x : surface.points)
    {
        x.z() *= 100;
    }
    const surfaceMeasures measures(measuresOf(surface));

    // All triangles but those of the two small faces
    EXPECT_NEAR(measures.smallestAngle, 0.573, 1e-3);
    EXPECT_NEAR(measures.shareWithSmallAngles, 8.0/12, 1e-12);
}


TEST(surfaceMeasures, ofPatches)
{
    // Two squares in the plane z = 1, and a roof of two that meet at 90 degrees
    wallSurface surface;
    surface.points = pointField
    ({
        {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {2, 0, 1}, {2, 1, 1},
        {2, 0, 2}, {2, 1, 2}
    });
    surface.faces = faceList
    ({
        face({0, 1, 2, 3}), face({1, 4, 5, 2}), face({4, 6, 7, 5}),
        face({0, 1, 2, 3})
    });
    surface.patchNames = wordList({"floor", "none", "corner"});
    surface.patchIDs = labelList({0, 0, 2, 2});
    const List<patchMeasures> patches(measuresOfPatches(surface));

    ASSERT_EQ(patches.size(), 3);
    EXPECT_EQ(patches[0].nFaces, 2);
    EXPECT_NEAR(patches[0].area, 2, 1e-12);
    EXPECT_NEAR(mag(patches[0].centre - point(1, 0.5, 1)), 0, 1e-12);
    EXPECT_NEAR(mag(patches[0].normal - vector(0, 0, 1)), 0, 1e-12);
    EXPECT_EQ(patches[1].nFaces, 0);
    EXPECT_EQ(patches[1].normal, vector(Zero));
    EXPECT_NEAR(mag(patches[2].centre - point(1.25, 0.5, 1.25)), 0, 1e-12);
    EXPECT_EQ(patches[2].normal, vector(Zero));
}


// ************************************************************************* //
