/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "openSurfaces.H"
#include "sidePair.H"
#include "thrownMessage.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using testSurfaces::cyclicPlanes;

static std::string errorOf(const List<sidePatch>& sides)
{
    return thrownMessage<error>([&]() { pairsOf(sides); });
}


//- Two planes through the z axis, the second turned by some degrees
static List<sidePatch> sector(const scalar angle, const scalar given)
{
    const scalar radians = angle*3.14159265358979323846/180;
    List<sidePatch> planes(2);
    for (sidePatch& plane : planes)
    {
        plane.type = "cyclic";
    }
    planes[0].name = "first";
    planes[0].normal = vector(0, -1, 0);
    planes[0].cyclic.partner = "second";
    planes[0].cyclic.axis = vector(0, 0, 2);
    planes[0].cyclic.angle = given;
    planes[1].name = "second";
    planes[1].normal = vector(-::sin(radians), ::cos(radians), 0);

    return planes;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(sidePair, planesWithoutRotationHaveATranslation)
{
    const List<sidePair> pairs(pairsOf(cyclicPlanes()));

    ASSERT_EQ(pairs.size(), 2);
    EXPECT_EQ(pairs[0].first, 0);
    EXPECT_EQ(pairs[0].second, 1);
    EXPECT_EQ(pairs[0].toSecond(point(0, 0.3, 0.1)), point(1, 0.3, 0.1));
    EXPECT_EQ(pairs[1].toSecond(point(0.2, 0, 0.1)), point(0.2, 1, 0.1));
}


TEST(sidePair, bothMayNameEachOther)
{
    List<sidePatch> sides(cyclicPlanes());
    sides[1].cyclic.partner = "left";

    EXPECT_EQ(pairsOf(sides).size(), 2);
}


TEST(sidePair, aRotationTurnsByItsAngleAboutItsAxis)
{
    const List<sidePair> pairs(pairsOf(sector(30, 30)));

    ASSERT_EQ(pairs.size(), 1);
    const point x(pairs[0].toSecond(point(2, 0, 5)));
    EXPECT_NEAR(x.x(), ::sqrt(3.0), 1e-15);
    EXPECT_NEAR(x.y(), 1, 1e-15);
    EXPECT_EQ(x.z(), 5);
}


TEST(sidePair, motionsAreComposedAndInverted)
{
    const rigidMotion turn(pairsOf(sector(30, 30))[0].toSecond);
    const rigidMotion move(pairsOf(cyclicPlanes())[0].toSecond);
    const point x(1, 2, 3);

    EXPECT_NEAR(mag(move.after(turn)(x) - move(turn(x))), 0, 1e-15);
    EXPECT_NEAR(mag(turn.after(move)(x) - turn(move(x))), 0, 1e-15);
    EXPECT_NEAR(mag(turn.after(move).inverse()(turn(move(x))) - x), 0, 1e-14);
}


TEST(sidePair, imagesAreFoundByLabel)
{
    const rigidMotion move(pairsOf(cyclicPlanes())[0].toSecond);
    const pointField points({{1, 0, 0}, {0, 2, 0}, {1, 2, 0}, {0, 0, 0}});
    const auto imagesOf = [&](const labelList& labels, label& lone)
    {
        return imagesByLabel
        (
            labels, labelList({0, 2}),
            [&](const label p) { return points[p]; }, move, 1e-9, lone
        );
    };

    label lone;
    const Map<label> images(imagesOf({1, 3}, lone));
    EXPECT_EQ(lone, -1);
    EXPECT_EQ(images[1], 2);
    EXPECT_EQ(images[3], 0);

    EXPECT_EQ(imagesOf({3, 2}, lone).size(), 1);
    EXPECT_EQ(lone, 2);
    EXPECT_EQ(imagesOf({1}, lone).size(), 1);
    EXPECT_EQ(lone, 1);
}


TEST(sidePair, errorsNameTheSides)
{
    List<sidePatch> lone(cyclicPlanes());
    lone[1].type = "patch";
    expectWords(errorOf(lone), {"left", "partner right"});

    List<sidePatch> unnamed(cyclicPlanes());
    unnamed[0].cyclic.partner = "";
    expectWords(errorOf(unnamed), {"left", "no partner"});

    List<sidePatch> three(cyclicPlanes());
    three[2].cyclic.partner = "right";
    expectWords(errorOf(three), {"front", "right", "another partner"});

    List<sidePatch> tilted(cyclicPlanes());
    tilted[1].normal = normalised(vector(1, 1e-3, 0));
    expectWords(errorOf(tilted), {"left", "right", "the image", "parallel"});

    expectWords(errorOf(sector(30, 31)), {"first", "second", "angle"});
}

// ************************************************************************* //
