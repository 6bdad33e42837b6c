/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "openSurfaces.H"
#include "minimalControls.H"
#include "Random.H"
#include "thrownMessage.H"

#include <gtest/gtest.h>

using namespace Foam;
using testSurfaces::symmetryPlane;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Planes with a common point, none of them normal to another
static List<sidePatch> obliquePlanes()
{
    const point x(0.3, -0.2, 0.7);

    return List<sidePatch>
    ({
        symmetryPlane("a", x, normalised(vector(1, 0.4, -0.2))),
        symmetryPlane("b", x, normalised(vector(0.3, 1, 0.5))),
        symmetryPlane("c", x, normalised(vector(-0.1, 0.6, 1)))
    });
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(sidePatch, distanceIsNegativeInTheFluid)
{
    const sidePatch side(symmetryPlane("a", point(1, 2, 3), vector(0, 0, -1)));

    EXPECT_EQ(side.distance(point(7, 8, 5)), -2);
    EXPECT_EQ(side.distance(point(7, 8, 2)), 1);
}


TEST(sidePatch, reflectionsAreOfPointsAndVectors)
{
    const sidePatch side(symmetryPlane("a", point(1, 2, 3), vector(0, 0, -1)));

    EXPECT_EQ(side.reflected(vector(1, 2, 3)), vector(1, 2, -3));
    EXPECT_EQ(side.reflectedPoint(point(1, 2, 5)), point(1, 2, 1));
}


TEST(sidePatch, outlineRunsRoundTheFaces)
{
    const wallSurface sheet(testSurfaces::sheet(3, 0));
    const edgeList edges(outline(sheet.faces));
    ASSERT_EQ(edges.size(), 12);

    // The area to the left of the edges
    vector area(Zero);
    labelList nEnds(sheet.points.size(), Zero);
    for (const edge& e : edges)
    {
        area += 0.5*(sheet.points[e.start()] ^ sheet.points[e.end()]);
        ++nEnds[e.start()];
        --nEnds[e.end()];
    }
    EXPECT_LT(mag(area - vector(0, 0, 1)), 1e-15);
    EXPECT_EQ(nEnds, labelList(sheet.points.size(), Zero));
    EXPECT_TRUE(outline(testSurfaces::cube(2).faces).empty());
}


TEST(sidePatch, onAllIsTheNearestPointInThePlanes)
{
    const List<sidePatch> sides(obliquePlanes());
    Random random(21);

    for (label i = 0; i < 20; ++i)
    {
        const point x(random.sample01<vector>());

        const point onOne(onAll(sides, labelList({0}), x));
        EXPECT_LT(mag(sides[0].distance(onOne)), 1e-15);
        EXPECT_LT(mag((x - onOne) ^ sides[0].normal), 1e-15);

        const point onTwo(onAll(sides, labelList({0, 1}), x));
        EXPECT_LT(mag(sides[0].distance(onTwo)), 1e-15);
        EXPECT_LT(mag(sides[1].distance(onTwo)), 1e-15);
        EXPECT_LT
        (
            mag((x - onTwo) & (sides[0].normal ^ sides[1].normal)), 1e-15
        );

        const point onThree(onAll(sides, labelList({0, 1, 2}), x));
        EXPECT_LT(mag(onThree - sides[0].origin), 1e-14);
    }
}


TEST(sidePatch, onAllTakesAPlaneTwice)
{
    List<sidePatch> sides(obliquePlanes());
    sides[1] = sides[0];
    sides[1].normal *= -1;
    const point x(0.1, 0.2, 0.3);

    EXPECT_EQ
    (
        onAll(sides, labelList({0, 1}), x), onAll(sides, labelList({0}), x)
    );
    EXPECT_EQ(onAll(sides, labelList(), x), x);
}


TEST(sidePatch, pointSidesAreOfTheEdgesFromAndToAPoint)
{
    wallBorder border;
    border.edges = edgeList({edge(4, 7), edge(7, 9), edge(9, 4)});
    border.edgeSides = labelList({0, 1, 1});
    const Map<labelPair> sides(border.pointSides());

    EXPECT_EQ(sides.size(), 3);
    EXPECT_EQ(sides[4], labelPair(0, 1));
    EXPECT_EQ(sides[7], labelPair(1, 0));
    EXPECT_EQ(sides[9], labelPair(1, 1));
}


TEST(sidePatch, namesAreNotThoseOfTheWall)
{
    List<sidePatch> sides(1, symmetryPlane("a", point::zero, vector(0, 0, -1)));

    EXPECT_NO_THROW(checkSides(sides, wordList({"wall"})));
    expectWords
    (
        thrownMessage<error>([&]() { checkSides(sides, wordList({"a"})); }),
        {"side patch a", "patch of the wall"}
    );
}


TEST(sidePatch, oneNameHasOneType)
{
    List<sidePatch> sides
    ({
        symmetryPlane("a", point::zero, vector(0, 0, -1)),
        symmetryPlane("a", point::zero, vector(1, 0, 0))
    });
    sides[0].type = "empty";
    sides[1].type = "cyclic";
    expectWords
    (
        thrownMessage<error>([&]() { checkSides(sides, wordList()); }),
        {"name a", "empty", "cyclic", "Rename"}
    );
}


TEST(sidePatch, symmetryPlanesAreInOnePlane)
{
    List<sidePatch> sides
    ({
        symmetryPlane("a", point::zero, vector(0, 0, -1)),
        symmetryPlane("a", point(1, 0, 0), vector(0, 0, -1))
    });
    sides[0].type = sides[1].type = "symmetryPlane";
    EXPECT_NO_THROW(checkSides(sides, wordList()));

    sides[1].normal = vector(1, 0, 0);
    expectWords
    (
        thrownMessage<error>([&]() { checkSides(sides, wordList()); }),
        {"several planes", "type symmetry"}
    );

    sides[0].type = sides[1].type = "symmetry";
    EXPECT_NO_THROW(checkSides(sides, wordList()));
}


// ************************************************************************* //
