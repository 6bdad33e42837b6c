/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prepareWall.H"
#include "meshFuzzCase.H"
#include "openSurfaces.H"
#include "wallChanges.H"
#include "wallVisibility.H"

#include <gtest/gtest.h>

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::testSurfaces;

static wallSurface surfaceOf(const pointField& points, const faceList& faces)
{
    wallSurface surface;
    surface.points = points;
    surface.faces = faces;
    surface.patchIDs = labelList(faces.size(), Zero);
    surface.patchNames = {"wall"};

    return surface;
}


//- A cube with a triangle of almost no height on a diagonal
static wallSurface cubeWithCap()
{
    wallSurface surface(cube(1));
    const face f(surface.faces[0]);
    const label k = f.longestEdge(surface.points);
    const label a = f[k], b = f.nextLabel(k), c = f.prevLabel(k);
    const pointField& x = surface.points;
    const label cap = x.size();
    surface.points.append
    (
        0.5*(x[a] + x[b]) + 1e-11*(x[c] - 0.5*(x[a] + x[b]))
    );
    surface.faces[0] = face({a, b, cap});
    surface.faces.append(face({b, c, cap}));
    surface.faces.append(face({c, a, cap}));
    surface.patchIDs = labelList(surface.faces.size(), Zero);

    return surface;
}


//- A hexahedron of which point 0 cannot see all its warped faces
static wallSurface warpedBlock()
{
    return surfaceOf
    (
        pointField
        ({
            {0.726, 0.1388, 0.8899}, {0, 0.02873, 0.9228},
            {0.4901, 0.02873, 1.337}, {0.4901, 0.1145, 0.9228},
            {0, 0.02873, 1.337}, {0, 0.1145, 0.9228}, {0.4901, 0.1145, 1.337},
            {0, 0.1145, 1.337}
        }),
        faceList
        ({
            face({1, 4, 2, 0}), face({1, 0, 3, 5}), face({0, 2, 6, 3}),
            face({1, 5, 7, 4}), face({2, 4, 7, 6}), face({3, 6, 7, 5})
        })
    );
}


//- Two bodies, one with a cap, in random order
static wallSurface roughSurface()
{
    return renumbered
    (
        merge(cubeWithCap(), translated(quadCube(3), vector(3, 0, 0))), 7
    );
}


//- A surface without the face nearest to a point
static wallSurface withHole
(
    wallSurface surface,
    const point& x = point(0, 0, 10)
)
{
    const pointField& points = surface.points;
    const auto nearest = std::min_element
    (
        surface.faces.begin(), surface.faces.end(),
        [&](const face& f, const face& g)
        {
            return magSqr(f.centre(points) - x) < magSqr(g.centre(points) - x);
        }
    );
    *nearest = surface.faces.last();
    surface.faces.resize(surface.faces.size() - 1);
    surface.patchIDs.resize(surface.faces.size());

    return surface;
}


//- Repairs all holes of the unit cube, and remeshes
static prismLayerControls changing()
{
    prismLayerControls controls;
    controls.surface.repair.repair = surfaceRepairControls::method::stitch;
    controls.surface.repair.hole = 1;
    controls.surface.remesh.active = true;
    controls.surface.remesh.maxEdge = 0.4;

    return controls;
}


static void expectSame(const wallSurface& a, const wallSurface& b)
{
    EXPECT_EQ(a.points, b.points);
    EXPECT_EQ(a.faces, b.faces);
    EXPECT_EQ(a.patchIDs, b.patchIDs);
    EXPECT_EQ(a.patchNames, b.patchNames);
    EXPECT_TRUE(a.border.edges == b.border.edges);
    EXPECT_EQ(a.border.edgeSides, b.border.edgeSides);
}


//- The fuzz prepares the same wall, and tells nothing but stages
static void expectSameInFuzz
(
    const wallSurface& surface,
    const prismLayerControls& controls
)
{
    const wallSurface wall
    (
        prepareFuzzWall
        (
            fuzzCase(), surface, controls,
            [](const std::string& what, const std::string& text)
            {
                EXPECT_EQ(what, "stage") << text;
            }
        )
    );
    ASSERT_GT(wall.faces.size(), 0);
    expectSame(wall, prepareWall(surface, controls).wall);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(prepareWall, capsAreFlippedAndTheWallRenumbered)
{
    const wallSurface surface(roughSurface());
    const preparedWall prepared(prepareWall(surface, prismLayerControls()));

    EXPECT_TRUE(prepared.defects.empty());
    expectSame(prepared.surface, surface);
    EXPECT_EQ(prepared.nFlips, 1);
    EXPECT_EQ(prepared.nCut, 0);
    EXPECT_TRUE(findWallDefects(prepared.wall).empty());
    EXPECT_NEAR(Foam::enclosedVolume(prepared.wall), 2, 1e-10);

    wallSurface wall(surface);
    flipCaps(wall);
    EXPECT_NE(prepared.wall.points, wall.points);
    renumberWall(wall);
    expectSame(prepared.wall, wall);
    EXPECT_EQ(flipCaps(wall), 0);
}


TEST(prepareWall, facesThatAPointCannotSeeAreCut)
{
    preparedWall prepared(prepareWall(warpedBlock(), prismLayerControls()));

    // One is folded
    EXPECT_EQ(prepared.nCut, 4);
    EXPECT_EQ(prepared.wall.faces.size(), 10);
    EXPECT_EQ(cutBlindFaces(prepared.wall), 0);
}


TEST(prepareWall, theFuzzHasTheWallOfTheUtility)
{
    expectSameInFuzz(roughSurface(), prismLayerControls());
    expectSameInFuzz(warpedBlock(), prismLayerControls());

    prismLayerControls onPlanes;
    onPlanes.surface.sidePlanes = quarterPlanes();
    expectSameInFuzz(quarterCube(4), onPlanes);

    expectSameInFuzz(withHole(cube(4)), changing());
}


TEST(prepareWall, aSurfaceWithDefectsHasNoWall)
{
    const wallSurface surface(withHole(sphere(4)));
    const preparedWall prepared(prepareWall(surface, prismLayerControls()));

    ASSERT_EQ(prepared.defects.size(), 1);
    EXPECT_EQ(prepared.defects[0].what, wallDefect::kind::openEdge);
    EXPECT_TRUE(prepared.wall.faces.empty());
    expectSame(prepared.surface, surface);
}


TEST(prepareWall, theWallEndsOnSidesOfTheBox)
{
    const label n = 4;
    prismLayerControls controls;
    controls.farField.boundary.type = farBoundaryType::box;
    controls.farField.boundary.box = boundBox(point(-5, -5, 0), point(5, 5, 5));
    const preparedWall prepared(prepareWall(halfCube(n), controls));

    EXPECT_TRUE(prepared.defects.empty());
    ASSERT_EQ(prepared.wall.border.sides.size(), 1);
    EXPECT_EQ(prepared.wall.border.sides[0].name, "zMin");
    EXPECT_EQ(prepared.wall.border.edges.size(), 4*n);
    EXPECT_EQ(prepared.wall.faces.size(), 3*n*n);
}


TEST(prepareWall, changesAreMeasuredAndStagesTold)
{
    wordList stages;
    stageObserver observer;
    observer.begin = [&](const word& stage) { stages.append(stage); };
    const wallSurface surface(withHole(cube(4)));
    const preparedWall prepared
    (
        prepareWall(surface, changing(), PtrList<regionSearch>(), observer)
    );

    EXPECT_EQ
    (
        stages,
        wordList
        (
            {
                "surfaceRepair", "wallDefects", "wallAccount", "surfaceRemesh",
                "wallAccount"
            }
        )
    );
    EXPECT_EQ(prepared.steps.size(), 1);
    EXPECT_EQ(prepared.repair.before.angles.size(), surface.faces.size());
    EXPECT_EQ(prepared.repair.before.volume, 0);
    EXPECT_NEAR(prepared.repair.now.volume, 1, 1e-12);
    EXPECT_GT(prepared.repair.distance.largest, 0.01);
    EXPECT_LT(prepared.repair.distanceOfGiven.largest, 1e-12);
    EXPECT_TRUE(prepared.isRemeshed);
    EXPECT_EQ(prepared.remesh.before.angles, prepared.repair.now.angles);
    EXPECT_EQ
    (
        prepared.remesh.now.angles.size(), prepared.surface.faces.size()
    );
    EXPECT_TRUE(findWallDefects(prepared.wall).empty());
}


TEST(prepareWall, patchesThatAreFlushWithTheWallStayInIt)
{
    // A vent in the ceiling, and the whole ceiling
    for (const scalar width : {0.5, 2.0})
    {
        wallSurface room(reversed(cube(4)));
        room.patchNames = wordList({"room", "vent"});
        forAll(room.faces, facei)
        {
            const vector c(room.faces[facei].centre(room.points));
            room.patchIDs[facei] = c.z() > 1 - SMALL
             && mag(c.x() - 0.5) < 0.5*width && mag(c.y() - 0.5) < 0.5*width;
        }
        prismLayerControls controls;
        controls.surface.fluidOutside = false;
        controls.layers = withoutLayers({"vent"});
        const preparedWall prepared(prepareWall(room, controls));

        const bool isFlush = width < 1;
        EXPECT_EQ(prepared.flushPatches, wordList(isFlush, word("vent")));
        EXPECT_EQ(prepared.wall.border.sides.empty(), isFlush);
        EXPECT_EQ(prepared.wall.patchNames.size(), isFlush ? 2 : 1);
        EXPECT_EQ
        (
            prepared.wall.patchTypes,
            isFlush ? wordList({"wall", "patch"}) : wordList({"wall"})
        );
    }
}


TEST(adviceOnDefects, saysWhatMends)
{
    const prismLayerControls controls;
    const auto has = [&](const wallSurface& surface, const char* words)
    {
        const string advice(adviceOnDefects(surface, controls));

        return advice.find(words) != string::npos;
    };

    EXPECT_TRUE(has(withHole(sphere(16)), "stitch mends this surface"));
    EXPECT_TRUE(has(halfSphere(8), "sidePlanes\n    {\n        zMin"));
    // The plane of the hole would cut the other one
    const wallSurface two
    (
        merge(halfSphere(16), translated(halfSphere(16), vector(3, 0, 0)))
    );
    EXPECT_TRUE(has(withHole(two, point(0.7, 0, 0.7)), "these side planes"));
    EXPECT_TRUE(has(withHole(torus(6, 4, 1, 0.4), Zero), "wrap does"));
}


TEST(adviceOnDefects, saysNothingOfWraps)
{
    prismLayerControls controls;
    controls.surface.repair.repair = surfaceRepairControls::method::wrap;
    EXPECT_EQ(adviceOnDefects(halfSphere(8), controls), "");
}


// ************************************************************************* //
