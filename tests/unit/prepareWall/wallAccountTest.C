/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallAccount.H"
#include "openSurfaces.H"
#include "surfacePart.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::testSurfaces;

//- A surface with a patch of its own
static wallSurface named(wallSurface surface, const word& patch)
{
    surface.patchNames = wordList(1, patch);
    surface.patchIDs = labelList(surface.faces.size(), Zero);

    return surface;
}


//- Share of an area by fate
static scalar shareOf(const areaAccount& account, const areaFate fate)
{
    return account.area(fate)/account.area();
}


//- Without faces whose centre is above a height
static wallSurface cutAbove(const wallSurface& surface, const scalar height)
{
    bitSet kept(surface.faces.size());
    forAll(surface.faces, i)
    {
        kept.set(i, surface.faces[i].centre(surface.points).z() < height);
    }
    wallSurface left(surface);
    keepFaces(kept, left);

    return left;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(wallAccount, allOfAnUnchangedSurfaceIsKept)
{
    const wallSurface given(named(sphere(6), "ball"));
    const wallAccount same(makeWallAccount(given));
    const wallAccount measured(makeWallAccount(given, given, {}));

    for (const wallAccount& a : {same, measured})
    {
        EXPECT_EQ(shareOf(a.all, areaFate::kept), 1);
        EXPECT_EQ(describeLosses(a, wordRes(), 0.01), "");
        EXPECT_EQ(a.patches[0].patch, "ball");
    }
    // Samples stand for equal areas, but for less than one at the end
    EXPECT_NEAR(measured.all.area(), same.all.area(), 1e-4*same.all.area());
}


TEST(wallAccount, aMissingFaceIsLostAtItsPlace)
{
    const wallSurface given(named(cube(4), "body"));
    const wallAccount account
    (
        makeWallAccount(given, cutAbove(given, 1 - SMALL), {})
    );

    // One face of six, but for what is near to its rim
    EXPECT_NEAR(account.all.lostShare(), 1/6.0, 2e-3);
    EXPECT_EQ(account.all.place.z(), 1);
    EXPECT_NEAR(account.all.farthest, 0.5, 0.02);
    const string text(describeLosses(account, wordRes(), 0.01));
    EXPECT_NE(text.find("part of the patch body"), std::string::npos) << text;
    const wordRes accepted(List<wordRe>(1, wordRe("bo.*", wordRe::REGEX)));
    EXPECT_EQ(describeLosses(account, accepted, 0.01), "");
    EXPECT_EQ(describeLosses(account, wordRes(), 0.2), "");
}


TEST(wallAccount, aSmallPartIsNotNearToWhatItStoodOn)
{
    const auto withBolt = [](const scalar size)
    {
        const wallSurface body(named(cube(4, 100), "body"));
        const wallSurface bolt
        (
            named(translated(cube(1, size), vector(50, 50, 100)), "bolt")
        );

        return makeWallAccount(merge(body, bolt), body, {});
    };

    // Its size is about the tolerance of the whole
    const wallAccount account(withBolt(2));
    EXPECT_GT(account.tolerance, 0.1);
    EXPECT_EQ(account.missingPatches, wordList({"bolt"}));
    EXPECT_GT(account.parts[1].lostShare(), 0.7);
    EXPECT_EQ(account.parts[0].lostShare(), 0);

    // A stray facet is no error
    const wallAccount stray(withBolt(0.05));
    EXPECT_TRUE(stray.missingPatches.empty());
    EXPECT_EQ(describeLosses(stray, wordRes(), 0.01), "");
    EXPECT_GT(stray.parts[1].lostShare(), 0.7);
}


TEST(wallAccount, whatIsInsideOfABodyOrTouchesItIsNotLost)
{
    // The second cube is a third inside of the first, the third one touches it
    const wallSurface first(named(cube(4), "first"));
    const wallSurface inside
    (
        named(translated(cube(4, 0.5), vector(0.25, 0.25, 0.25)), "inside")
    );
    const wallSurface touching
    (
        named(translated(cube(4, 0.5), vector(1, 0.25, 0.25)), "touching")
    );
    const wallSurface given(merge(merge(first, inside), touching));
    wallSurface outer(merge(first, cutAbove(touching, 0.74)));
    const wallAccount account(makeWallAccount(given, outer, {}));

    EXPECT_EQ(shareOf(account.patches[1], areaFate::inside), 1);
    EXPECT_TRUE(account.missingPatches.empty());
    EXPECT_EQ(shareOf(account.patches[0], areaFate::kept), 1);

    // The top of the third cube is gone
    EXPECT_NEAR(shareOf(account.patches[2], areaFate::lost), 1/6.0, 0.01);
    EXPECT_EQ
    (
        shareOf
        (
            makeWallAccount
            (
                merge(first, touching),
                merge(first, beyond(touching, 0, 1.01)), {}
            ).patches[1], areaFate::lost
        ), 0
    );
}


TEST(wallAccount, aBodyInAFluidIsLostWhereTheFluidIsInside)
{
    const wallSurface room(named(reversed(cube(4, 3)), "room"));
    const wallSurface body
    (
        named(translated(cube(4), vector(1, 1, 1)), "body")
    );
    accountControls controls;
    controls.fluidOutside = false;
    const wallAccount inside
    (
        makeWallAccount(merge(room, body), room, controls)
    );
    EXPECT_EQ(inside.patches[1].lostShare(), 1);

    // Half of a body beyond the wall of the room is not beside its fluid
    const wallSurface through
    (
        named(translated(cube(8), vector(1, 1, 2.375)), "body")
    );
    const wallAccount beside
    (
        makeWallAccount
        (
            merge(room, through), merge(room, cutAbove(through, 3)), controls
        )
    );
    EXPECT_EQ(beside.patches[1].lostShare(), 0);
    EXPECT_GT(shareOf(beside.patches[1], areaFate::inside), 0.3);
}


TEST(wallAccount, whatIsBeyondAPlaneOrInItIsNotLost)
{
    const wallSurface given(named(cube(4), "body"));
    accountControls controls;
    sidePatch lid;
    lid.origin = point(0, 0, 0.5);
    lid.normal = vector(0, 0, 1);
    controls.planes.append(lid);
    const wallAccount account
    (
        makeWallAccount(given, cutAbove(given, 0.5), controls)
    );

    EXPECT_EQ(account.all.lostShare(), 0);
    EXPECT_NEAR(shareOf(account.all, areaFate::beyond), 0.5, 2e-3);
}


TEST(wallAccount, aFoundationIsBehindItsGround)
{
    // The sheet ends on four planes; a house goes through it
    const wallSurface ground(named(sheet(4, 0), "ground"));
    const boundBox box(ground.points, false);
    const point c(box.centre());
    const wallSurface house
    (
        named(translated(cube(4, 0.2), vector(c.x(), c.y(), -0.1)), "house")
    );
    accountControls controls;
    for (const scalar side : {-1.0, 1.0})
    {
        for (const direction d : {vector::X, vector::Y})
        {
            sidePatch plane;
            plane.origin = side < 0 ? box.min() : box.max();
            plane.normal[d] = side;
            controls.planes.append(plane);
        }
    }
    const wallAccount account
    (
        makeWallAccount
        (
            merge(ground, house), merge(ground, beyond(house, 2, 0)), controls
        )
    );

    EXPECT_EQ(account.all.lostShare(), 0);
    EXPECT_GT(shareOf(account.patches[1], areaFate::inside), 0.3);
}

// ************************************************************************* //
