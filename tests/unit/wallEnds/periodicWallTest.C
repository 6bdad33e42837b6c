/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cyclicSides.H"
#include "openSurfaces.H"
#include "periodicWall.H"
#include "thrownMessage.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using namespace testSurfaces;

//- The point of the waves at a place of the plane
static label pointAt(const wallSurface& wall, const scalar x, const scalar y)
{
    forAll(wall.points, p)
    {
        const point& at = wall.points[p];
        if (mag(at.x() - x) < 1e-9 && mag(at.y() - y) < 1e-9)
        {
            return p;
        }
    }

    return -1;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(alignCyclicSides, pointsGoToWhereTheImagesAre)
{
    wallSurface wall(endedOn(waves(4), cyclicPlanes()));
    const label moved = pointAt(wall, 1, 0.5);
    const label original = pointAt(wall, 0, 0.5);
    wall.points[moved].z() += 1e-6;

    EXPECT_NEAR(alignCyclicSides(wall, 1e-5).largestMove, 1e-6, 1e-15);
    EXPECT_EQ(wall.points[moved], wall.points[original] + vector(1, 0, 0));
}


TEST(alignCyclicSides, refusesAPointWithoutImage)
{
    wallSurface wall(endedOn(waves(4), cyclicPlanes()));
    wall.points[pointAt(wall, 1, 0.5)].z() += 0.05;

    expectWords
    (
        thrownMessage<error>([&]() { alignCyclicSides(wall, 1e-5); }),
        {"left", "right", "(0 0.5"}
    );
}


// The sides have points at other places of the same curve
TEST(alignCyclicSides, bothSidesGetThePointsOfBoth)
{
    wallSurface wall(endedOn(waves(8), cyclicPlanes()));
    const auto isOnRight = [&](const label p)
    {
        return wall.points[p].x() == 1;
    };
    forAll(wall.points, p)
    {
        point& x = wall.points[p];
        if (isOnRight(p) && x.y() > 0.1 && x.y() < 0.9)
        {
            x.y() += x.y() > 0.8 ? 0.0625 : 0.02;
        }
    }
    const label nBefore = wall.points.size();

    const cyclicAlignment aligned(alignCyclicSides(wall, 1e-5));

    // The two that are half an edge apart are added to the other side
    EXPECT_EQ(aligned.nMoved, 6);
    EXPECT_NEAR(aligned.largestMove, 0.01, 1e-9);
    EXPECT_EQ(aligned.nAdded, 2);
    EXPECT_EQ(wall.points.size(), nBefore + 2);
    for (const sidePair& pair : pairsOf(wall.border.sides))
    {
        const Map<label> images(imagesOnBorder(wall, pair, 0));
        EXPECT_EQ(images.size(), pair.first == 0 ? 10 : 9);
    }
    EXPECT_EQ
    (
        outline(wall.faces).size(), label(wall.border.edges.size())
    );
}


TEST(periodicWall, twoPairsHaveEightImages)
{
    const wallSurface given(periodicWaves(4));
    const periodicWall wall(given);

    EXPECT_EQ(wall.surface.faces.size(), 9*given.faces.size());
    EXPECT_EQ(wall.surface.points.size(), 13*13);
    EXPECT_EQ(wall.surface.border.edges.size(), 4*12);

    // The given wall comes first
    forAll(given.faces, facei)
    {
        EXPECT_EQ(wall.surface.faces[facei], given.faces[facei]);
    }
    label nBases = 0;
    forAll(wall.surface.points, p)
    {
        const point image
        (
            wall.motions[wall.motionOfPoint[p]](given.points[wall.bases[p]])
        );
        EXPECT_NEAR(mag(wall.surface.points[p] - image), 0, 1e-15);
        nBases += wall.isBase(p);
    }
    EXPECT_EQ(nBases, 16);
}


TEST(periodicWall, narrowOnesHaveMoreImages)
{
    wallSurface given(periodicWaves(2));
    const periodicWall wall(given);

    EXPECT_EQ(wall.surface.faces.size(), 81*given.faces.size());
    EXPECT_EQ(wall.surface.points.size(), 19*19);
    forAll(wall.surface.points, p)
    {
        const point image
        (
            wall.motions[wall.motionOfPoint[p]](given.points[wall.bases[p]])
        );
        EXPECT_NEAR(mag(wall.surface.points[p] - image), 0, 1e-14);
    }
}


TEST(periodicWall, endsWhereTheImagesEnd)
{
    const periodicWall wall(periodicWaves(4));
    const wallBorder& border = wall.surface.border;

    EXPECT_EQ(border.sides[0].origin.x(), -1);
    EXPECT_EQ(border.sides[1].origin.x(), 2);
    forAll(border.edges, i)
    {
        const sidePatch& side = border.sides[border.edgeSides[i]];
        const edge& e = border.edges[i];
        for (const label p : {e.first(), e.second()})
        {
            EXPECT_NEAR(side.distance(wall.surface.points[p]), 0, 1e-15);
        }
    }
}


TEST(periodicWall, refusesASideThatDoesNotGoOn)
{
    wallSurface wall(periodicWaves(4));
    wall.border.sides[2].type = "patch";
    wall.border.sides[3].type = "patch";
    wall.border.sides[3].normal = normalised(vector(0.1, 1, 0));

    expectWords
    (
        thrownMessage<error>([&]() { periodicWall images(wall); }),
        {"back", "left", "right"}
    );
}

// ************************************************************************* //
