/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidSide.H"
#include "boxSides.H"
#include "openSurfaces.H"
#include "thrownMessage.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::testSurfaces;

static wallSurfaceControls inside(const point& x)
{
    wallSurfaceControls controls;
    controls.hasInside = true;
    controls.inside = x;

    return controls;
}


//- A sheet over the unit square and a cube of 0.2 whose base is at a height
static wallSurface houseAt(const scalar height)
{
    return merge
    (
        sheet(4, 0), translated(cube(2, 0.2), vector(0.4, 0.4, height))
    );
}


//- The sides of the unit square
static List<sidePatch> walls()
{
    const List<sidePatch> sides
    (
        sidesOf(boundBox(point(0, 0, -1), point(1, 1, 1)))
    );

    return SubList<sidePatch>(sides, 4);
}


//- The normal of the sheet after turnSheets
static vector turned
(
    wallSurface surface,
    const wallSurfaceControls& controls,
    string& said
)
{
    turnSheets(surface, walls(), controls, true, said);

    return surface.faces[0].unitNormal(surface.points);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(fluidSide, aPointTells)
{
    const wallSurface both(merge(cube(2), reversed(cube(2, 0.5))));
    EXPECT_TRUE(isFluidOutside(both, {}, wallSurfaceControls()));
    EXPECT_TRUE(isFluidOutside(both, {}, inside(point(2, 0, 0))));
    EXPECT_FALSE(isFluidOutside(both, {}, inside(point(0.7, 0.7, 0.7))));

    // Below a half on its plane, and in it
    const wallSurface half(halfCube(4));
    const List<sidePatch> planes
    (
        withBoxSides
        (
            half, {},
            []()
            {
                farBoundaryControls boundary;
                boundary.type = farBoundaryType::box;
                boundary.box = boundBox(point(-1, -1, 0), point(2, 2, 3));
                return boundary;
            }()
        )
    );
    EXPECT_FALSE(isFluidOutside(half, planes, inside(point(0.5, 0.5, 0.1))));
    EXPECT_TRUE(isFluidOutside(half, planes, inside(point(0.5, 0.5, 2))));
}


TEST(fluidSide, aSurfaceWithGapsEnclosesAPoint)
{
    // Half of the faces are turned, and one is missing
    wallSurface open(cube(2));
    for (label i = 0; i < open.faces.size(); i += 2)
    {
        open.faces[i].flip();
    }
    open.faces.resize(open.faces.size() - 1);
    open.patchIDs.resize(open.faces.size());
    for (const scalar x : {0.4, 1.7})
    {
        const point p(x, 0.45, 0.55);
        EXPECT_EQ(isEnclosed(open, p), x < 1);
        EXPECT_EQ(isFluidOutside(open, {}, inside(p)), x > 1);
    }
}


TEST(fluidSide, entriesThatDoNotAgreeAreRefused)
{
    wallSurfaceControls controls(inside(point(0.5, 0.5, 0.5)));
    controls.isFluidGiven = true;
    EXPECT_NE
    (
        thrownMessage<error>([&]() { isFluidOutside(cube(2), {}, controls); })
            .find("do not agree"),
        std::string::npos
    );
}


TEST(fluidSide, bodiesTellTheSideOfASheet)
{
    string said;
    EXPECT_GT(turned(houseAt(0), wallSurfaceControls(), said).z(), 0.9);
    EXPECT_NE(said.find("side (0 0 1) of the patch"), std::string::npos);
    EXPECT_NE(said.find("as the normals"), std::string::npos) << said;
    EXPECT_LT(turned(houseAt(-0.2), wallSurfaceControls(), said).z(), -0.9);
    EXPECT_NE(said.find("the bodies are there"), std::string::npos);

    // Without bodies the normals tell, or a point
    said = "";
    EXPECT_GT(turned(sheet(4, 0), wallSurfaceControls(), said).z(), 0.9);
    EXPECT_NE(said.find("as the normals"), std::string::npos) << said;
    EXPECT_LT
    (
        turned(houseAt(0), inside(point(0.1, 0.1, -0.5)), said).z(), -0.9
    );
}


TEST(fluidSide, bodiesOnBothSidesOfASheetAreRefused)
{
    string said;
    const string message
    (
        thrownMessage<error>
        (
            [&]() { turned(houseAt(-0.1), wallSurfaceControls(), said); }
        )
    );
    EXPECT_NE(message.find("bodies on both sides"), std::string::npos);
    EXPECT_NE(message.find("inside (x y z)"), std::string::npos);
}


TEST(fluidSide, componentsThatAreNotBesideTheFluidGo)
{
    const auto shell = [](const scalar size)
    {
        return translated(cube(2, size), vector::uniform(-0.5*size));
    };
    const wallSurface all(merge(merge(shell(4), shell(2)), shell(1)));
    const label n = shell(1).faces.size();

    // In the second shell the fluid is beside the first two components, and so
    // on
    label k = 0;
    for (const scalar x : {3.0, 1.5, 0.75, 0.2})
    {
        wallSurface surface(all);
        const wallSurface apart
        (
            keepBesideFluid(surface, {}, inside(point(x, 0, 0)))
        );
        const bool isOne = k == 0 || k == 3;
        EXPECT_EQ(surface.faces.size(), (isOne ? 1 : 2)*n) << x;
        EXPECT_EQ(apart.faces.size(), (isOne ? 2 : 1)*n) << x;
        ++k;
    }

    wallSurface surface(all);
    EXPECT_TRUE
    (
        keepBesideFluid(surface, {}, wallSurfaceControls()).faces.empty()
    );
    EXPECT_EQ(surface.faces.size(), 3*n);
}

// ************************************************************************* //
