/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "yPlusHeights.H"
#include "surfacePart.H"
#include "testSurfaces.H"
#include "thrownMessage.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A run on a cube of quads with layers of a height of 0.1, 0.5 in all, and
//  y+ as a function of the place
template<class YPlus>
static wallsOfRun runOn(const wallSurface& surface, const YPlus& yPlusAt)
{
    const label n = surface.faces.size();
    wallsOfRun walls;
    walls.surface = surface;
    walls.firstHeight = scalarField(n, 0.1);
    walls.thickness = scalarField(n, 0.5);
    for (const face& f : surface.faces)
    {
        walls.yPlus.append(yPlusAt(f.centre(surface.points)));
    }

    return walls;
}


static yPlusRun targetOf(const scalar target)
{
    yPlusRun run;
    run.target = target;
    run.folder = "run";

    return run;
}


static const yPlusHeightControls asItIs{0, 0};


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(yPlusHeights, areInProportionToTheTarget)
{
    const wallSurface wall(testSurfaces::cube(5));
    const heightsOfRun heights
    (
        makeHeightsOfRun
        (
            wall,
            runOn(testSurfaces::quadCube(4), [](const point&) { return 4; }),
            targetOf(2)
        )
    );

    forAll(wall.points, p)
    {
        EXPECT_NEAR(heights.first[p], 0.05, 1e-14);
        EXPECT_NEAR(heights.thickness[p], 0.5, 1e-14);
        EXPECT_NEAR(heights.yPlusPerHeight[p], 40, 1e-11);
    }
}


TEST(yPlusHeights, followTheRunOntoOtherFaces)
{
    // y+ is linear along x, so that means of faces and values between points
    // are exact inside of the sides along x
    const wallSurface wall(testSurfaces::cube(7));
    const auto yPlusAt = [](const point& x) { return 1 + x.x(); };
    const heightsOfRun heights
    (
        makeHeightsOfRun
        (
            wall, runOn(testSurfaces::quadCube(10), yPlusAt), targetOf(1),
            asItIs
        )
    );
    label nInside = 0;

    forAll(wall.points, p)
    {
        const scalar x = wall.points[p].x();
        if (x > 0.11 && x < 0.89)
        {
            EXPECT_NEAR(heights.first[p], 0.1/(1 + x), 1e-13);
            ++nInside;
        }
    }
    EXPECT_GT(nInside, 50);
}


TEST(yPlusHeights, areBoundedAtStagnation)
{
    // Zero on the lowest tenth of the wall, 1 elsewhere
    const wallSurface wall(testSurfaces::quadCube(10));
    const wallsOfRun walls
    (
        runOn(wall, [](const point& x) { return x.z() > 0.12 ? 1 : 0; })
    );
    const auto highest = [&](const scalar percent)
    {
        return max
        (
            makeHeightsOfRun
            (
                wall, walls, targetOf(1), yPlusHeightControls{percent, 0}
            ).first
        );
    };

    // The bottom and one of ten rows around it: 7/30 of the area
    EXPECT_GT(highest(20), 1e12);
    EXPECT_NEAR(highest(30), 0.1, 1e-14);
    EXPECT_NEAR(highest(100), 0.1, 1e-14);
}


TEST(yPlusHeights, smoothingLevelsPeaks)
{
    const wallSurface wall(testSurfaces::quadSphere(8));
    const wallsOfRun walls
    (
        runOn(wall, [](const point& x) { return x.x() > 0.9 ? 4 : 1; })
    );
    const auto spreadOf = [&](const label nSmooth)
    {
        const scalarField first
        (
            makeHeightsOfRun
            (
                wall, walls, targetOf(1), yPlusHeightControls{0, nSmooth}
            ).first
        );

        return max(first)/min(first);
    };

    EXPECT_NEAR(spreadOf(0), 4, 1e-12);
    EXPECT_LT(spreadOf(3), 3.9);
    EXPECT_LT(spreadOf(300), 1.1);
}


TEST(yPlusHeights, otherPatchesHaveTheNearestAndNoExpectation)
{
    wallSurface wall(testSurfaces::quadCube(4));
    wallSurface part(wall);
    wall.patchNames = wordList({"body", "new"});
    part.patchNames = wordList({"body"});
    bitSet old(wall.faces.size());
    forAll(wall.faces, facei)
    {
        const bool isNew = wall.faces[facei].centre(wall.points).z() > 0.9;
        wall.patchIDs[facei] = isNew ? 1 : 0;
        old.set(facei, !isNew);
    }
    keepFaces(old, part);
    const heightsOfRun heights
    (
        makeHeightsOfRun
        (
            wall, runOn(part, [](const point&) { return 4; }), targetOf(1)
        )
    );

    forAll(wall.points, p)
    {
        const point& x = wall.points[p];
        const bool isInside =
            x.z() > 0.9 && mag(x.x() - 0.5) < 0.4 && mag(x.y() - 0.5) < 0.4;
        EXPECT_NEAR(heights.first[p], 0.025, 1e-14);
        EXPECT_NEAR(heights.yPlusPerHeight[p], isInside ? 0 : 40, 1e-11);
    }
}


TEST(yPlusHeights, otherBodyIsRefused)
{
    const wallSurface wall(testSurfaces::quadCube(4));
    const auto errorAt = [&](const scalar scale)
    {
        const wallsOfRun walls
        (
            runOn
            (
                testSurfaces::quadCube(4, scale),
                [](const point&) { return 1; }
            )
        );

        return thrownMessage<error>([&]()
        {
            makeHeightsOfRun(wall, walls, targetOf(1));
        });
    };

    EXPECT_EQ(errorAt(1), "");
    expectWords
    (
        errorAt(0.001), {"run", "yPlus.from", "m away", "other units"}
    );
}


// ************************************************************************* //
