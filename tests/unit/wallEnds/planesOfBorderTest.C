/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planesOfBorder.H"
#include "openSurfaces.H"
#include "testSurfaces.H"
#include "transformField.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(planesOfBorder, closedSurfaceHasNone)
{
    EXPECT_TRUE(planesOfBorder(sphere(4)).empty());
}


TEST(planesOfBorder, borderOnTwoSidesOfTheBox)
{
    const List<sidePatch> planes(planesOfBorder(quarterCube(4)));

    ASSERT_EQ(planes.size(), 2);
    EXPECT_EQ(planes[0].name, "yMin");
    EXPECT_EQ(planes[0].normal, vector(0, -1, 0));
    EXPECT_EQ(planes[1].name, "zMin");
    EXPECT_EQ(planes[1].normal, vector(0, 0, -1));
}


TEST(planesOfBorder, obliquePlaneIsThatOfItsPart)
{
    wallSurface half(halfSphere(6));
    const tensor turn(Foam::rotationTensor(vector(0, 0, 1), vector(1, 2, 2)/3));
    half.points = Foam::transform(turn, half.points);
    half.points += vector(100, 0, 0);

    const List<sidePatch> planes(planesOfBorder(half));

    ASSERT_EQ(planes.size(), 1);
    EXPECT_EQ(planes[0].name, "plane0");
    EXPECT_NEAR(planes[0].distance(point(100, 0, 0)), 0, 1e-12);
    EXPECT_NEAR(mag(planes[0].normal + vector(1, 2, 2)/3), 0, 1e-12);
}


TEST(planesOfBorder, noneIfAnEdgeIsOnNoPlane)
{
    wallSurface half(halfSphere(6));
    half.points[outline(half.faces)[0].start()].z() = 0.01;

    EXPECT_TRUE(planesOfBorder(half).empty());
}


TEST(planesOfBorder, planeThatCutsTheSurfaceIsNone)
{
    // The half sphere's border, and a sphere beyond it
    wallSurface half(halfSphere(6));
    const label n = half.points.size();
    const wallSurface other(sphere(4));
    half.points.append(other.points + vector(0, 0, -3));
    half.points.append(other.points + vector(0, 0, 3));

    for (const label start : {n, n + other.points.size()})
    {
        for (face f : other.faces)
        {
            for (label& p : f)
            {
                p += start;
            }
            half.faces.append(f);
        }
    }

    EXPECT_TRUE(planesOfBorder(half).empty());
}


TEST(planesOfBorder, sheetEndsOnTheSidesAroundIt)
{
    EXPECT_EQ(planesOfBorder(sheet(3, 0.5)).size(), 4);
}


// ************************************************************************* //
