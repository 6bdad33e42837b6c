/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "expectedYPlus.H"
#include "testSurfaces.H"
#include "thrownMessage.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A cube with patches low (z < 0.5) and high
static wallSurface halves()
{
    wallSurface wall(testSurfaces::quadCube(4));
    wall.patchNames = wordList({"low", "high"});

    forAll(wall.faces, facei)
    {
        wall.patchIDs[facei] =
            wall.faces[facei].centre(wall.points).z() < 0.5 ? 0 : 1;
    }

    return wall;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(expectedYPlus, bandsAreThoseOfWallFunctionsOrOfTheTarget)
{
    EXPECT_EQ(yPlusBand(1).min(), 0.5);
    EXPECT_EQ(yPlusBand(1).max(), 1.5);
    EXPECT_EQ(yPlusBand(29).max(), 43.5);

    for (const scalar target : {30, 50, 300})
    {
        EXPECT_EQ(yPlusBand(target).min(), 30);
        EXPECT_EQ(yPlusBand(target).max(), 300);
    }
}


TEST(expectedYPlus, percentilesAreByWeight)
{
    const scalarField values({3, 1, 2});
    const scalarField weights({1, 2, 7});

    EXPECT_EQ(weightedPercentile(values, weights, 0), 1);
    EXPECT_EQ(weightedPercentile(values, weights, 19), 1);
    EXPECT_EQ(weightedPercentile(values, weights, 21), 2);
    EXPECT_EQ(weightedPercentile(values, weights, 89), 2);
    EXPECT_EQ(weightedPercentile(values, weights, 91), 3);
    EXPECT_EQ(weightedPercentile(values, weights, 100), 3);
}


TEST(expectedYPlus, sharesAreByArea)
{
    const wallSurface wall(halves());
    scalarField yPlus(wall.faces.size(), 1);
    label n = 0;

    // A quarter of the faces above, which are all alike
    forAll(yPlus, facei)
    {
        yPlus[facei] = wall.patchIDs[facei] == 1 && n++ % 4 == 0 ? 1.6 : 1;
    }

    expectWords
    (
        describeYPlus(wall, yPlus, 1),
        {
            "1 (5 %), 1 (50 %), 1.6 (95 %)",
            "low: y+ from 0.5 to 1.5 on 100 % of the area",
            "high: y+ from 0.5 to 1.5 on 75 % of the area"
        }
    );
}


TEST(expectedYPlus, isOfTheFacesOnWhichTheRunHasOne)
{
    const wallSurface wall(halves());
    const scalarField heights(wall.points.size(), 0.1);
    scalarField yPlusPerHeight;

    EXPECT_EQ(describeExpected(wall, heights, yPlusPerHeight, 1), "");

    yPlusPerHeight.setSize(wall.points.size());
    forAll(wall.points, p)
    {
        yPlusPerHeight[p] = wall.points[p].z() < 0.6 ? 20 : 0;
    }
    const string text(describeExpected(wall, heights, yPlusPerHeight, 1));

    expectWords
    (
        text, {"2 (1 %)", "2 (99 %)", "low: y+ from 0.5 to 1.5 on 0 %"}
    );
    EXPECT_EQ(text.find("high"), std::string::npos);
}


// ************************************************************************* //
