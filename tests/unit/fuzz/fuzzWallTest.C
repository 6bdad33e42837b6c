/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshFuzzCase.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- What is told last of a unit cube in a box
static std::string toldOf(const prismLayerControls& controls)
{
    fuzzCase one;
    one.isAtSides = true;
    std::string last;
    prepareFuzzWall
    (
        one, testSurfaces::cube(2), controls,
        [&](const std::string& what, const std::string& text)
        {
            last = what == "stage" ? what : what + ' ' + text;
        }
    );

    return last;
}


//- The lower side of the box at a height
static prismLayerControls boxAbove(const scalar z)
{
    prismLayerControls controls;
    controls.farField.boundary.type = farBoundaryType::box;
    controls.farField.boundary.box =
        boundBox(point(-1, -1, z), point(2, 2, 2));

    return controls;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(fuzzWall, atSidesErrorsWithAnEntryAreRefusals)
{
    EXPECT_EQ(toldOf(boxAbove(-0.5)), "stage");
    EXPECT_EQ(toldOf(boxAbove(0)), "stage");
    EXPECT_EQ(toldOf(boxAbove(0.5)), "refused throughSide");
    EXPECT_EQ(toldOf(boxAbove(1.5)), "refused beyondSide");

    prismLayerControls unknown(boxAbove(-0.5));
    unknown.layers.patches.resize(1);
    unknown.layers.patches[0].patches = "noPatch";
    EXPECT_EQ(toldOf(unknown).substr(0, 6), "failed");
}


// ************************************************************************* //
