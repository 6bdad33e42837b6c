/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "splitAtSidePatches.H"
#include "openSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A wall and what reading it has changed
struct endedWall
{
    wallReading reading;
    wallSurface wall;


    endedWall
    (
        const wallSurface& surface,
        const List<sidePatch>& planes,
        const layerControls& layers = layerControls()
    )
    {
        wallSurfaceControls controls;
        controls.sidePlanes = planes;
        wall = splitAtSidePatches(surface, controls, layers, reading);
    }
};


//- Each edge of the border is one of one face, as this runs along it
static void expectBorder(const wallSurface& wall)
{
    edgeList open(outline(wall.faces));
    ASSERT_EQ(wall.border.edges.size(), open.size());
    ASSERT_EQ(wall.border.edgeSides.size(), open.size());

    const auto sorted = [](const edgeList& edges)
    {
        std::set<std::pair<label, label>> pairs;
        for (const edge& e : edges)
        {
            pairs.insert({e.start(), e.end()});
        }
        return pairs;
    };

    EXPECT_EQ(sorted(wall.border.edges), sorted(open));
}


static scalar diagonal(const wallSurface& wall)
{
    return boundBox(wall.points, false).mag();
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(splitAtSidePatches, closedSurfaceStaysAsItIs)
{
    const endedWall e(quadCube(2), {});

    EXPECT_EQ(e.wall.faces, quadCube(2).faces);
    EXPECT_EQ(e.wall.points, quadCube(2).points);
    EXPECT_TRUE(e.wall.border.sides.empty());
    EXPECT_TRUE(e.wall.border.edges.empty());
    EXPECT_EQ(e.wall.patchTypes, wordList({"wall"}));
}


TEST(splitAtSidePatches, halfCubeEndsOnItsPlane)
{
    const endedWall e(halfCube(4), halfPlanes());
    const wallBorder& border = e.wall.border;

    EXPECT_EQ(e.wall.faces, halfCube(4).faces);
    ASSERT_EQ(border.sides.size(), 1);
    EXPECT_EQ(border.sides[0].name, "bottom");
    EXPECT_EQ(border.sides[0].type, "symmetryPlane");
    EXPECT_TRUE(border.sides[0].faces.empty());

    expectBorder(e.wall);
    EXPECT_EQ(nEdgesOn(border, 0), 16);
    for (const edge& b : border.edges)
    {
        EXPECT_EQ(e.wall.points[b.start()].z(), 0);
    }

    EXPECT_EQ(e.reading.pointsPutOnSides, 0);
    EXPECT_EQ(e.reading.largestMove, 0);
    EXPECT_EQ(e.reading.flippedFaces, 0);
}


TEST(splitAtSidePatches, quarterCubeEndsOnBothPlanes)
{
    const wallSurface wall(endedOn(quarterCube(4), quarterPlanes()));

    expectBorder(wall);
    EXPECT_EQ(nEdgesOn(wall.border, 0), 8);
    EXPECT_EQ(nEdgesOn(wall.border, 1), 8);

    const Map<labelPair> sides(wall.border.pointSides());
    EXPECT_EQ(sides.size(), 16);

    forAllConstIters(sides, iter)
    {
        const point& x = wall.points[iter.key()];
        const bool onBoth = iter.val().first() != iter.val().second();

        EXPECT_EQ(onBoth, x.y() == 0 && x.z() == 0) << x.x();
    }
}


TEST(splitAtSidePatches, bordersNearTheirPlanesArePutThere)
{
    wallSurface surface(quarterCube(4));
    const scalar move = 5e-5*diagonal(surface);
    label n = 0;
    for (point& x : surface.points)
    {
        const bool onBottom = x.z() == 0, onSide = x.y() == 0;
        const scalar sign = ++n % 2 ? 1 : -1;
        x.z() += onBottom ? sign*move : 0;
        x.y() += onSide ? sign*move : 0;
    }

    const endedWall e(surface, quarterPlanes());

    EXPECT_EQ(e.wall.points, quarterCube(4).points);
    EXPECT_EQ(e.reading.pointsPutOnSides, 16);
    EXPECT_NEAR(e.reading.largestMove, ::sqrt(2.0)*move, 1e-15);
}


TEST(splitAtSidePatches, pointsOnObliquePlanesAreInBoth)
{
    const tensor R(tensor(1, 0.3, -0.7, 0.2, 1, 0.4, 0.5, -0.4, 1));
    const vector x(normalised(R.x()));
    const vector y(normalised(R.y() - (R.y() & x)*x));
    const tensor rotation(tensor(x, y, x ^ y).T());
    const vector shift(3, 4, 5);

    wallSurface surface(quarterCube(4));
    surface.points = (rotation & surface.points) + shift;
    List<sidePatch> planes(quarterPlanes());
    for (sidePatch& plane : planes)
    {
        plane.normal = rotation & plane.normal;
        plane.origin = shift;
    }

    const wallSurface wall(endedOn(surface, planes));
    forAll(wall.border.edges, i)
    {
        const sidePatch& side = wall.border.sides[wall.border.edgeSides[i]];
        // Rounding of coordinates of size 5
        const edge& e = wall.border.edges[i];
        EXPECT_NEAR(side.distance(wall.points[e.start()]), 0, 4e-15);
        EXPECT_NEAR(side.distance(wall.points[e.end()]), 0, 4e-15);
    }
}


TEST(splitAtSidePatches, ductEndsOnItsPatches)
{
    layerControls layers(withoutLayers({"inlet", "outlet"}));
    layers.patches[1].type = "symmetryPlane";
    const wallSurface wall(endedWall(duct(4), {}, layers).wall);
    const wallBorder& border = wall.border;

    EXPECT_EQ(wall.faces.size(), 4*16);
    EXPECT_EQ(wall.patchNames, wordList({"walls"}));
    EXPECT_EQ(wall.patchTypes, wordList({"wall"}));
    expectBorder(wall);

    ASSERT_EQ(border.sides.size(), 2);
    for (label s = 0; s < 2; ++s)
    {
        EXPECT_EQ(nEdgesOn(border, s), 16);
        EXPECT_EQ(border.sides[s].faces.size(), 16);
        EXPECT_EQ(border.sides[s].points.size(), 25);
        EXPECT_LT(mag(border.sides[s].normal - vector(2*s - 1, 0, 0)), 1e-15);
    }
    EXPECT_EQ(border.sides[0].name, "inlet");
    EXPECT_EQ(border.sides[0].type, "patch");
    EXPECT_EQ(border.sides[1].name, "outlet");
    EXPECT_EQ(border.sides[1].type, "symmetryPlane");
}


TEST(splitAtSidePatches, wrinkledInletBecomesPlane)
{
    wallSurface surface(duct(4));
    label n = 0;
    for (point& x : surface.points)
    {
        x.x() += x.x() == 0 ? (++n % 2 ? 4e-5 : -4e-5) : 0;
    }

    const endedWall e(surface, {}, withoutLayers({"inlet", "outlet"}));
    const sidePatch& inlet = e.wall.border.sides[0];
    EXPECT_EQ(e.reading.pointsPutOnSides, 25);

    for (const point& x : inlet.points)
    {
        EXPECT_NEAR(inlet.distance(x), 0, 1e-16);
    }

    // The border and the part have the same points
    forAll(e.wall.border.edges, i)
    {
        const point& x = e.wall.points[e.wall.border.edges[i].start()];
        EXPECT_TRUE
        (
            e.wall.border.edgeSides[i] != 0 || inlet.points.found(x)
        );
    }
}


TEST(splitAtSidePatches, turnedSurfaceGivesTheSameWall)
{
    const endedWall e(reversed(quarterCube(4)), quarterPlanes());
    const wallSurface same(endedOn(quarterCube(4), quarterPlanes()));

    EXPECT_EQ(e.reading.flippedFaces, 24);
    EXPECT_EQ(e.wall.faceNormals(), same.faceNormals());
    expectBorder(e.wall);
}


TEST(splitAtSidePatches, patchesKeepTheirTypes)
{
    wallSurface surface(halfCube(4));
    surface.patchNames = wordList({"top", "around"});
    forAll(surface.faces, facei)
    {
        surface.patchIDs[facei] =
            surface.faces[facei].centre(surface.points).z() < 0.5 - SMALL;
    }
    patchLayers entry;
    entry.patches = "top";
    entry.type = "symmetry";
    layerControls layers;
    layers.patches.append(entry);

    const wallSurface wall(endedWall(surface, halfPlanes(), layers).wall);
    EXPECT_EQ(wall.patchNames, wordList({"top", "around"}));
    EXPECT_EQ(wall.patchTypes, wordList({"symmetry", "wall"}));
}


TEST(splitAtSidePatches, sidePatchesMayJoinOthersToTheWall)
{
    const endedWall ended(vessel(), {}, withoutLayers({"around", "top"}));
    const wallBorder& border = ended.wall.border;

    ASSERT_EQ(border.sides[0].name, "top");
    EXPECT_FALSE(border.edgeSides.found(0));
    EXPECT_EQ(border.edges.size(), 96);
    expectBorder(ended.wall);
}


// ************************************************************************* //
