/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "distributeFront.H"
#include "openSurfaces.H"
#include "testLayers.H"
#include "threadTeam.H"
#include "unitConversion.H"

#include <gtest/gtest.h>

#include <mutex>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static label nDifferentCones(const wallVisibility& a, const wallVisibility& b)
{
    label n = 0;
    forAll(a.cones, c)
    {
        n += a.cones[c].axis != b.cones[c].axis
          || a.cones[c].cosine != b.cones[c].cosine;
    }

    return n;
}


static void expectSameSurface(const wallSurface& a, const wallSurface& b)
{
    EXPECT_EQ(a.points, b.points);
    EXPECT_EQ(a.faces, b.faces);
    EXPECT_EQ(a.patchIDs, b.patchIDs);
    EXPECT_EQ(a.patchNames, b.patchNames);
    EXPECT_EQ(a.border.sides.size(), b.border.sides.size());
    EXPECT_EQ(a.border.edges.size(), b.border.edges.size());
    for (const edge& e : a.border.edges)
    {
        EXPECT_TRUE(b.border.edges.found(e));
    }
}


static void expectSameLabels(const sharedLabels& a, const sharedLabels& b)
{
    EXPECT_EQ(a.whole, b.whole);
    EXPECT_EQ(a.nWhole, b.nWhole);
    EXPECT_EQ(a.isOwn, b.isOwn);
    EXPECT_EQ(a.sent, b.sent);
    EXPECT_EQ(a.received, b.received);
}


static void expectSameShare(const frontShare& a, const frontShare& b)
{
    expectSameLabels(a.columns, b.columns);
    expectSameLabels(a.points, b.points);
    expectSameLabels(a.faces, b.faces);

    expectSameSurface(a.front.surface, b.front.surface);
    EXPECT_EQ(a.front.wallPoints, b.front.wallPoints);
    EXPECT_EQ(a.front.nWallFaces, b.front.nWallFaces);
    EXPECT_TRUE
    (
        a.front.addressing.edges == b.front.addressing.edges
    );
    EXPECT_TRUE
    (
        a.front.addressing.edgeFaces == b.front.addressing.edgeFaces
    );
    EXPECT_EQ(a.front.addressing.pointFaces, b.front.addressing.pointFaces);
    EXPECT_EQ(a.front.addressing.pointPoints, b.front.addressing.pointPoints);
    EXPECT_TRUE
    (
        a.front.addressing.pointSides == b.front.addressing.pointSides
    );

    const wallVisibility& seen = a.front.visibility;
    EXPECT_EQ(seen.cornerNormals, b.front.visibility.cornerNormals);
    EXPECT_EQ(seen.polygonNormals, b.front.visibility.polygonNormals);
    EXPECT_EQ(seen.meanNormals, b.front.visibility.meanNormals);
    EXPECT_EQ(nDifferentCones(seen, b.front.visibility), 0);

    ASSERT_EQ(a.front.constraints.size(), b.front.constraints.size());
    forAll(a.front.constraints, c)
    {
        const vector d(0.3, -0.2, 0.7);
        EXPECT_EQ(a.front.allowed(c, d), b.front.allowed(c, d));
    }
}


//- The border, too, is in the same order
static void expectSameFront(const layerFront& a, const layerFront& b)
{
    expectSameSurface(a.surface, b.surface);
    EXPECT_TRUE(a.surface.border.edges == b.surface.border.edges);
    EXPECT_EQ(a.surface.border.edgeSides, b.surface.border.edgeSides);
    EXPECT_EQ(a.wallPoints, b.wallPoints);
    EXPECT_EQ(a.nWallFaces, b.nWallFaces);
}


//- Each process gets the share that it would take from the whole front, and
//  the master gets the front back
static void expectShares(const wallSurface& wall, const scalar angle)
{
    const wallAddressing addressing(makeWallAddressing(wall));
    const wallVisibility visibility(makeWallVisibility(wall, addressing));
    const layerFront bare
    (
        makeBareFront(wall, addressing, visibility, degToRad(angle))
    );
    layerFront whole(bare);
    whole.complete(addressing, visibility);

    for (const label n : {1, 2, 5, 8})
    {
        const labelList owners(ownersByRange(wall.points.size(), n));
        std::mutex reporting;

        threadTeam::run(n, [&](const threadTeam& processes)
        {
            const frontShare share = distributeFront
            (
                processes.isMaster() ? bare : layerFront(),
                processes.isMaster() ? pointOwners(owners) : pointOwners(),
                processes
            );
            const layerFront back(gatherFront(share, wall, processes));
            const std::lock_guard<std::mutex> lock(reporting);
            expectSameShare
            (
                share, shareOf(whole, owners, n, processes.rank())
            );
            expectSameFront
            (
                back, processes.isMaster() ? whole : layerFront()
            );
        });
    }
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(distributeFront, sharesOfAClosedWall)
{
    expectShares(testSurfaces::sphere(6), 0);
}


TEST(distributeFront, sharesOfPolygons)
{
    expectShares(testSurfaces::quadSphere(4), 0);
}


TEST(distributeFront, sharesWithMultipleNormals)
{
    expectShares(testSurfaces::quadCube(4), 45.1);
    expectShares(testSurfaces::bladeOnEdge(0.5), 0);
}


TEST(distributeFront, sharesOfWallsThatEnd)
{
    expectShares
    (
        testSurfaces::endedOn
        (
            testSurfaces::duct(6), wordList({"inlet", "outlet"})
        ),
        0
    );
    expectShares
    (
        testSurfaces::endedOn
        (
            testSurfaces::halfSphere(6), testSurfaces::halfPlanes()
        ),
        0
    );
}


// ************************************************************************* //
