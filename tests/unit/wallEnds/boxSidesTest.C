/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boxSides.H"
#include "openSurfaces.H"
#include "thrownMessage.H"

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

TEST(boxSides, sideWithABorderIsASidePlane)
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


TEST(boxSides, upperSidesPointUp)
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


TEST(boxSides, haveTheNamesOfTheirPatches)
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


TEST(boxSides, planesThatAreGivenStayAlone)
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


TEST(boxSides, bodyThatStandsOnASideOrGoesThroughIt)
{
    const auto names = [](const wallSurface& surface, const scalar ground)
    {
        wordList all;
        const farBoundaryControls around
        (
            box(point(-1, -1, ground), point(2, 2, 3))
        );
        for (const sidePatch& side : withBoxSides(surface, {}, around))
        {
            all.append(side.name);
        }
        return all;
    };

    EXPECT_EQ(names(quadCube(2), 0), wordList({"zMin"}));
    EXPECT_EQ(names(quadCube(2), 0.3), wordList({"zMin"}));
    EXPECT_TRUE(names(quadCube(2), -0.3).empty());
    EXPECT_TRUE(names(halfCube(4), -1).empty());
}


TEST(boxSides, whatIsBeyondAPlaneThatIsGivenDoesNotCount)
{
    const List<sidePatch> middle
    (
        1, symmetryPlane("middle", point(0.5, 0, 0), vector(1, 0, 0))
    );
    const List<sidePatch> planes
    (
        withBoxSides
        (
            quadCube(2), middle,
            box(point(-1, -1, -1), point(0.7, 2, 3))
        )
    );

    ASSERT_EQ(planes.size(), 1);
    EXPECT_EQ(planes[0].name, "middle");
}


TEST(boxSides, noneOfASphere)
{
    farBoundaryControls sphere;
    sphere.type = farBoundaryType::sphere;
    sphere.radius = 3;
    EXPECT_EQ(withBoxSides(halfCube(4), halfPlanes(), sphere).size(), 1);
}


TEST(boxSides, theBoxBeginsBehindAFloor)
{
    const point low(0, 0, 0.5);
    const point high(1, 1, 3);
    const farBoundaryControls around(box(low, high));
    const List<sidePatch> planes(withBoxSides(sheet(3, 0.5), {}, around));
    const boundBox behind(boxBehind(sheet(3, 0.5), around));

    EXPECT_EQ(planes.size(), 4);
    for (const sidePatch& plane : planes)
    {
        EXPECT_NE(plane.name, "zMin");
    }
    EXPECT_EQ(behind.max(), high);
    EXPECT_EQ(behind.min().x(), 0);
    EXPECT_LT(behind.min().z(), 0.4);

    // It stands there
    const farBoundaryControls onGround(box(point(-1, -1, 0), point(2, 2, 3)));
    EXPECT_EQ(boxBehind(quadCube(2), onGround).min(), point(-1, -1, 0));
}


TEST(boxSides, errorsNameTheSideAndTheDistance)
{
    const List<sidePatch> ground
    (
        1, symmetryPlane("ground", point(0, 0, 0.25), vector(0, 0, -1))
    );
    expectWords
    (
        thrownMessage<Foam::error>
        (
            [&]() { requireInFront(quadCube(2), ground); }
        ),
        {"through the side plane ground", "0.25 m", "repair stitch"}
    );
    requireInFront(halfCube(2), halfPlanes());

    // Its upper face is in the side
    List<sidePatch> above(halfPlanes());
    above[0].origin.z() = 1;
    expectWords
    (
        thrownMessage<Foam::error>
        (
            [&]() { requireInFront(quadCube(2), above); }
        ),
        {"all beyond the side plane", "1 m", "Move the side out"}
    );

    const auto errorIn = [](const scalar ground)
    {
        return thrownMessage<Foam::error>([&]()
        {
            requireInBox
            (
                quadCube(2), box(point(-1, -1, ground), point(2, 2, 3))
            );
        });
    };
    expectWords(errorIn(0), {"touches the side zMin"});
    expectWords(errorIn(0.125), {"beyond the side zMin", "0.125 m"});
    EXPECT_EQ(errorIn(-0.125), "");
}


TEST(boxSides, withoutABorderTheyAreNoSidePlanes)
{
    const List<sidePatch> planes
    (
        sidesOf(boundBox(point(-1, -1, 0), point(2, 2, 3)))
    );
    const auto namesOf = [&](const label nGiven)
    {
        wordList names;
        for
        (
            const sidePatch& plane
          : withoutBareSides(halfCube(4), planes, nGiven)
        )
        {
            names.append(plane.name);
        }

        return names;
    };

    EXPECT_EQ(namesOf(0), wordList({"zMin"}));
    EXPECT_EQ(namesOf(2), wordList({"xMin", "xMax", "zMin"}));
}


TEST(boxSides, facesOfClosedBodiesInSidesGo)
{
    const label n = 3;
    wallSurface body(quadCube(n));
    const List<sidePatch> ground
    (
        1, symmetryPlane("ground", point(0, 0, 0), vector(0, 0, -1))
    );

    EXPECT_EQ(removeFacesInSides(body, ground), n*n);
    EXPECT_EQ(body.faces.size(), 5*n*n);
    EXPECT_EQ(outline(body.faces).size(), 4*n);

    wallSurface open(sheet(n, 0));
    EXPECT_EQ(removeFacesInSides(open, ground), 0);
}


TEST(boxSides, aHalfStandsOnAnotherSide)
{
    // Open at z = 0, with faces in y = 0 that reach the side z = 0: no floor,
    // because its normals point out of the box there
    const wallSurface half(halfCube(4));
    const farBoundaryControls around(box(point(-1, 0, 0), point(2, 2, 3)));
    const List<sidePatch> planes(withBoxSides(half, {}, around));
    ASSERT_EQ(planes.size(), 2);
    EXPECT_EQ(boxBehind(half, around).min(), point(-1, 0, 0));

    wallSurface body(half);
    EXPECT_EQ(removeFacesInSides(body, planes), 8);
    for (const label side : {0, 1})
    {
        EXPECT_EQ
        (
            withoutBareSides(body, planes, 0)[side].name, planes[side].name
        );
    }

    // With the fluid inside the same faces are a wall
    EXPECT_EQ(removeFacesInSides(body = half, planes, false), 0);
}


// ************************************************************************* //
