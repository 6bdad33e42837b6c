/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planesOfBorder.H"
#include "openSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static farBoundaryControls box(const point& low, const point& high)
{
    farBoundaryControls controls;
    controls.type = farBoundaryType::box;
    controls.box = boundBox(low, high);

    return controls;
}


static farPatch patch(const word& name, const word& type, const word& side)
{
    farPatch p;
    p.name = name;
    p.type = type;
    p.sides = wordRes(List<wordRe>(1, wordRe(side)));

    return p;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(boxSidePlanes, sideWithABorderIsASidePlane)
{
    const List<sidePatch> planes
    (
        withBoxSides(halfCube(4), {}, box(point(-1, -1, 0), point(2, 2, 3)))
    );

    ASSERT_EQ(planes.size(), 1);
    EXPECT_EQ(planes[0].name, "zMin");
    EXPECT_EQ(planes[0].type, "patch");
    EXPECT_EQ(planes[0].normal, vector(0, 0, -1));
    EXPECT_EQ(planes[0].distance(point(0.3, 0.4, 0.5)), -0.5);
    EXPECT_TRUE(planes[0].faces.empty());
}


TEST(boxSidePlanes, upperSidesPointUp)
{
    wallSurface hanging(halfCube(4));
    hanging.points *= -1;

    const List<sidePatch> planes
    (
        withBoxSides(hanging, {}, box(point(-3, -3, -3), point(2, 2, 0)))
    );

    ASSERT_EQ(planes.size(), 1);
    EXPECT_EQ(planes[0].name, "zMax");
    EXPECT_EQ(planes[0].normal, vector(0, 0, 1));
}


TEST(boxSidePlanes, haveTheNamesOfTheirPatches)
{
    farBoundaryControls controls(box(point(-1, 0, 0), point(2, 2, 3)));
    controls.patches.append(patch("ground", "wall", "zMin"));
    controls.patches.append(patch("middle", "symmetryPlane", "yMin"));

    const List<sidePatch> planes(withBoxSides(quarterCube(4), {}, controls));

    ASSERT_EQ(planes.size(), 2);
    EXPECT_EQ(planes[0].name, "middle");
    EXPECT_EQ(planes[0].type, "symmetryPlane");
    EXPECT_EQ(planes[1].name, "ground");
    EXPECT_EQ(planes[1].type, "wall");
}


TEST(boxSidePlanes, planesThatAreGivenStayAlone)
{
    const List<sidePatch> planes
    (
        withBoxSides
        (
            quarterCube(4), halfPlanes(),
            box(point(-1, 0, 0), point(2, 2, 3))
        )
    );

    ASSERT_EQ(planes.size(), 2);
    EXPECT_EQ(planes[0].name, "bottom");
    EXPECT_EQ(planes[1].name, "yMin");
}


TEST(boxSidePlanes, noneWithoutABorderThere)
{
    // One touches a side with a face, one is below the border
    EXPECT_TRUE
    (
        withBoxSides(quadCube(2), {}, box(point(-1, -1, 0), point(2, 2, 3)))
       .empty()
    );
    EXPECT_TRUE
    (
        withBoxSides(halfCube(4), {}, box(point(-1, -1, -1), point(2, 2, 3)))
       .empty()
    );

    farBoundaryControls sphere;
    sphere.type = farBoundaryType::sphere;
    sphere.radius = 3;
    EXPECT_EQ(withBoxSides(halfCube(4), halfPlanes(), sphere).size(), 1);
}


// ************************************************************************* //
