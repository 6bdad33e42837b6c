/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readWallSurface.H"
#include "openSurfaces.H"
#include "stitchSurface.H"
#include "wallDefects.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- With points of its own for each face
static wallSurface loose(const wallSurface& surface)
{
    wallSurface result(surface);
    result.points.clear();

    forAll(surface.faces, facei)
    {
        for (label& p : result.faces[facei])
        {
            result.points.append(surface.points[p]);
            p = result.points.size() - 1;
        }
    }

    return result;
}


static label countOf(const repairSteps& steps, const std::string& what)
{
    for (const repairStep& step : steps)
    {
        if (step.what.find(what) != std::string::npos)
        {
            return step.count;
        }
    }

    return 0;
}


static void close(wallSurface& surface, repairSteps& steps)
{
    closeGaps(surface, 1e-3, 0.6, List<sidePatch>(), 1e-4, steps);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(stitchFaces, looseFacesAreJoinedAndStayQuadrilaterals)
{
    wallSurface surface(loose(quadCube(2)));
    surface.faces[3].flip();
    repairSteps steps;
    stitchFaces(surface, steps);

    EXPECT_EQ(surface.points.size(), 26);
    EXPECT_EQ(surface.faces.size(), 24);
    for (const face& f : surface.faces)
    {
        EXPECT_EQ(f.size(), 4);
    }
    EXPECT_EQ(countOf(steps, "equal points"), 96 - 26);
    EXPECT_EQ(countOf(steps, "faces turned"), 1);

    orientWallSurface(surface, true);
    EXPECT_TRUE(findWallDefects(surface).empty());
    EXPECT_NEAR(testSurfaces::enclosedVolume(surface), 1, 1e-12);
}


TEST(stitchFaces, duplicatesAndFacesWithoutAreaAreRemoved)
{
    wallSurface surface(cube(2));
    face turned(surface.faces[7]);
    turned.flip();
    const face twin(surface.faces[11]);
    surface.faces.append(turned);
    surface.faces.append(twin);
    surface.faces.append(face({0, 1, 0}));
    repairSteps steps;
    stitchFaces(surface, steps);

    EXPECT_EQ(surface.faces.size(), 48);
    EXPECT_EQ(countOf(steps, "on the same points"), 2);
    EXPECT_EQ(countOf(steps, "without area"), 1);
    EXPECT_TRUE(findWallDefects(surface).empty());
}


TEST(stitchFaces, pointsAreSplitWhereBodiesTouch)
{
    // Two cubes with a corner in common
    wallSurface surface(merge(cube(1), translated(cube(1), vector(1, 1, 1))));
    repairSteps steps;
    stitchFaces(surface, steps);

    EXPECT_EQ(surface.faces.size(), 24);
    EXPECT_EQ(surface.points.size(), 16);
    EXPECT_EQ(countOf(steps, "points added"), 1);
}


TEST(closeGaps, gapsWithOtherPointsAreClosed)
{
    // The lid is apart, and has other points on its edges
    wallSurface lid(beyond(cube(3), vector::Z, 0.99));
    lid.points += vector(0, 0, 1e-4);
    DynamicList<face> sides;
    const wallSurface whole(cube(2));
    for (const face& f : whole.faces)
    {
        if (f.centre(whole.points).z() < 0.99)
        {
            sides.append(f);
        }
    }
    wallSurface pot(whole);
    pot.faces = sides;
    pot.patchIDs.setSize(sides.size());

    wallSurface surface(merge(pot, lid));
    repairSteps steps;
    stitchFaces(surface, steps);
    EXPECT_FALSE(findWallDefects(surface).empty());
    close(surface, steps);

    EXPECT_GT(countOf(steps, "across gaps"), 0);
    EXPECT_EQ(countOf(steps, "holes filled"), 0);
    EXPECT_TRUE(findWallDefects(surface).empty());
    EXPECT_NEAR(testSurfaces::enclosedVolume(surface), 1, 2e-4);
}


TEST(closeGaps, smallHolesAreFilledAndLargeOnesAreLeft)
{
    for (const label n : {4, 2})
    {
        // A hole of four triangles: 0.35 or 0.71 across
        wallSurface surface(cube(n));
        surface.faces.setSize(surface.faces.size() - 2);
        surface.patchIDs.setSize(surface.faces.size());
        repairSteps steps;
        close(surface, steps);

        EXPECT_EQ(countOf(steps, "holes filled"), n == 4 ? 1 : 0);
        EXPECT_EQ(findWallDefects(surface).empty(), n == 4);
    }
}


TEST(closeGaps, singleTrianglesAreRemoved)
{
    wallSurface surface(cube(2));
    const label n = surface.points.size();
    for (const point& x : {point(0, 0, 2), point(0.3, 0, 2), point(0, 0.3, 2)})
    {
        surface.points.append(x);
    }
    surface.faces.append(face({n, n + 1, n + 2}));
    repairSteps steps;
    close(surface, steps);

    EXPECT_EQ(countOf(steps, "single triangles"), 1);
    EXPECT_EQ(countOf(steps, "holes filled"), 0);
    EXPECT_EQ(surface.faces.size(), 48);
    EXPECT_EQ(surface.points.size(), n);
}


TEST(closeGaps, bordersOnSidePlanesStayOpen)
{
    wallSurface surface(halfSphere(4));
    surface.points *= 0.1;
    repairSteps steps;
    closeGaps(surface, 1e-3, 10, halfPlanes(), 1e-6, steps);

    EXPECT_EQ(surface.faces.size(), 96);
    EXPECT_TRUE(steps.empty());
}


TEST(uniteBodies, overlappingBodiesBecomeOne)
{
    wallSurface surface
    (
        merge(cube(3), translated(cube(2), vector(0.6, 0.3, 0.2)))
    );
    repairSteps steps;
    uniteBodies(surface, true, 1e-4, steps);

    EXPECT_EQ(countOf(steps, "united"), 1);
    EXPECT_TRUE(findWallDefects(surface).empty());
    EXPECT_NEAR
    (
        testSurfaces::enclosedVolume(surface), 2 - 0.4*0.7*0.8, 1e-12
    );
}


TEST(uniteBodies, bodiesWithinOthersAreRemoved)
{
    const wallSurface inner(translated(cube(2, 0.5), vector(0.2, 0.2, 0.2)));

    for (const bool turned : {false, true})
    {
        wallSurface surface(merge(cube(3), turned ? reversed(inner) : inner));
        repairSteps steps;
        uniteBodies(surface, true, 1e-4, steps);

        EXPECT_EQ(countOf(steps, "united"), 1);
        EXPECT_EQ(surface.faces.size(), 108);
        EXPECT_NEAR(testSurfaces::enclosedVolume(surface), 1, 1e-12);
    }
}


TEST(uniteBodies, bodiesApartStayApart)
{
    wallSurface surface(merge(cube(2), translated(cube(2), vector(1.1, 0, 0))));
    repairSteps steps;
    uniteBodies(surface, true, 1e-4, steps);

    EXPECT_TRUE(steps.empty());
    EXPECT_EQ(surface.faces.size(), 96);
    EXPECT_NEAR(testSurfaces::enclosedVolume(surface), 2, 1e-12);
}


TEST(uniteBodies, touchingBodiesBecomeOne)
{
    wallSurface surface
    (
        merge(cube(2), translated(cube(2, 0.5), vector(1, 0.25, 0.25)))
    );
    repairSteps steps;
    uniteBodies(surface, true, 1e-4, steps);

    EXPECT_EQ(countOf(steps, "united"), 1);
    EXPECT_TRUE(findWallDefects(surface).empty());
    EXPECT_NEAR(testSurfaces::enclosedVolume(surface), 1.125, 1e-12);
}


TEST(uniteBodies, lowStepsBetweenBodiesAreRemoved)
{
    // Bars one upon the other, that overlap by 1e-6 where they cross
    wallSurface surface
    (
        merge(cube(1), translated(cube(1), vector(1e-6, 0.5, 1 - 1e-6)))
    );
    repairSteps steps;
    uniteBodies(surface, true, 1e-4, steps);

    EXPECT_EQ(countOf(steps, "united"), 1);
    EXPECT_TRUE(findWallDefects(surface).empty());
    EXPECT_NEAR(testSurfaces::enclosedVolume(surface), 2, 1e-4);

    for (const face& f : surface.faces)
    {
        for (const edge& e : f.edges())
        {
            EXPECT_GT(e.mag(surface.points), 1e-4);
        }
    }
}


TEST(uniteBodies, bodiesOnAnOpenSheetBecomePartsOfIt)
{
    // Houses of 0.1 x 0.1 x 0.1, of which a fifth is in the ground; the sheet
    // keeps its border, and houses that overlap become one
    wallSurface surface(sheet(6, 0));
    for (const scalar x : {0.15, 0.32, 0.51, 0.54, 0.73})
    {
        const wallSurface house(cube(1, 0.1));
        surface = merge(surface, translated(house, point(x, 0.4, -0.02)));
    }
    const scalar border = outline(surface.faces).size();
    repairSteps steps;
    EXPECT_EQ(uniteBodies(surface, true, 1e-4, steps), "");

    EXPECT_EQ(countOf(steps, "united"), 5);
    EXPECT_EQ(outline(surface.faces).size(), border);
    EXPECT_TRUE(findWallDefects(surface, true).empty());

    // Roofs lie as high as the ground that they cover: walls alone are added
    scalar area = 0;
    for (const face& f : surface.faces)
    {
        area += f.mag(surface.points);
    }
    EXPECT_NEAR(area, 1 + 0.08*(3*0.4 + 2*0.13 + 2*0.1), 1e-12);
    EXPECT_GT(min(surface.points.component(vector::Z)), -1e-12);
}


TEST(uniteBodies, bodiesInAFluidInsideAreCutOutOfIt)
{
    // A foot on the floor, a block that overlaps it and is at a wall, and a
    // ball in the air
    const wallSurface ball(sphere(4, 0.1));
    wallSurface surface(cube(2));
    for
    (
        const wallSurface& body
      : {
            translated(cube(1, 0.25), vector(0.4, 0.3, 0)),
            translated(cube(1, 0.375), vector(0.35, 0, 0.2)),
            translated(ball, vector(0.5, 0.5, 0.8))
        }
    )
    {
        surface = merge(surface, body);
    }
    repairSteps steps;
    uniteBodies(surface, false, 1e-4, steps);
    orientWallSurface(surface, false);

    const scalar common = 0.25*0.075*0.05;
    const scalar solid = pow3(0.25) + pow3(0.375) - common;

    EXPECT_EQ(countOf(steps, "united"), 1);
    EXPECT_EQ(countOf(steps, "cut out"), 1);
    EXPECT_TRUE(findWallDefects(surface).empty());
    const scalar fluid = 1 - solid - testSurfaces::enclosedVolume(ball);
    EXPECT_NEAR(testSurfaces::enclosedVolume(surface), -fluid, 1e-12);
}


// ************************************************************************* //
