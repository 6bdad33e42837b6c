/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutCore.H"
#include "makeHexCore.H"
#include "meshBuilder.H"
#include "testSurfaces.H"
#include "thrownMessage.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A cube of the given size, in a box around the origin of cubes of a width
struct cubeInBox
{
    const wallSurface wall;
    const wallSearch search;
    polyMeshParts core;

    explicit cubeInBox
    (
        const scalar cells,
        const scalar size = 1,
        const point& centre = Zero
    )
    :
        wall
        (
            testSurfaces::translated
            (
                testSurfaces::cube(2, size), centre - vector::uniform(size/2)
            )
        ),
        search(wall)
    {
        hexCoreBox box;
        box.box = boundBox(point::uniform(-2), point::uniform(2));
        box.patches.append("low", "patch");
        box.patches.append("high", "patch");
        box.sidePatches = labelList({0, 1, 0, 1, 0, 1});
        core = makeHexCore
        (
            box, coreObstacles{search, search},
            [=](const point&) { return cells/1.2; }, 1000000
        );
    }

    coreCut cut(const scalar gap) const
    {
        return cutCore(core, coreObstacles{search, search}, gap);
    }

    std::string errorAt(const scalar gap) const
    {
        return thrownMessage<error>([&]() { cut(gap); });
    }
};


//- The volume that closed triangles enclose, positive if their normals point
//  outwards
static scalar volumeIn(const wallSurface& surface)
{
    return testSurfaces::enclosedVolume(surface);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(cutCore, oneLayerOfCellsGoes)
{
    // The cube of 2 x 2 x 2 cells, and with it those nearer than 0.5 widths
    const cubeInBox c(0.5);
    const coreCut cut(c.cut(0.5));

    EXPECT_EQ(cut.nBoundary, 0);
    EXPECT_EQ(cut.cells.size(), 8*8*8 - 4*4*4);
    EXPECT_EQ(cut.cutFaces.size(), 2*6*16);
    EXPECT_EQ(cut.surface.faces.size(), 2*6*16);

    // Normals point into the room, a cube of the size 2
    EXPECT_NEAR(volumeIn(cut.surface), -8, 1e-12);
    EXPECT_EQ(cut.seeds.size(), 1);

    forAll(cut.cutFaces, i)
    {
        const label facei = cut.cutFaces[i];
        const label own = c.core.topology.owner[facei];
        const label nei = c.core.topology.neighbour[facei];
        EXPECT_TRUE(cut.cutCells[i] == own || cut.cutCells[i] == nei);
        EXPECT_TRUE(cut.cells.found(cut.cutCells[i]));
        EXPECT_NE(cut.cells.found(own), cut.cells.found(nei));
    }
}


TEST(cutCore, aLargerGapTakesMore)
{
    EXPECT_EQ(cubeInBox(0.5).cut(1.2).cells.size(), 8*8*8 - 6*6*6);
}


//- Cells on the side x = 2 are in the way
static cubeInBox nearASide()
{
    return cubeInBox(0.5, 0.9, point(1.45, 0, 0));
}


TEST(cutCore, patchesThatAreNearGetTriangles)
{
    const coreCut cut(nearASide().cut(0.5));

    // 4 x 4 cells on the side, and all 6 sides of the room are closed
    ASSERT_EQ(cut.nBoundary, 2*4*4);
    for (label i = 0; i < cut.nBoundary; ++i)
    {
        EXPECT_EQ(cut.surface.patchIDs[i], 1);
        EXPECT_EQ(cut.surface.faces[i].centre(cut.surface.points).x(), 2);
    }
    EXPECT_NEAR(volumeIn(cut.surface), -1.5*2*2, 1e-12);
}


TEST(cutCore, widerCellsThanTheirNeighboursGo)
{
    // Fine at the cube only: no cell at the cut has finer neighbours that go
    const wallSurface wall
    (
        testSurfaces::translated
        (
            testSurfaces::cube(4, 1), vector::uniform(-0.5)
        )
    );
    const wallSearch search(wall);
    hexCoreBox box;
    box.box = boundBox(point::uniform(-4), point::uniform(4));
    box.patches.append("box", "patch");
    box.sidePatches = labelList(6, Zero);
    const polyMeshParts core
    (
        makeHexCore
        (
            box, coreObstacles{search, search},
            [](const point& x)
            {
                return 0.1 + 0.5*max(cmptMax(cmptMag(x)) - 0.5, scalar(0));
            },
            1000000
        )
    );
    const coreCut cut(cutCore(core, coreObstacles{search, search}, 0.5));

    scalarField areas(core.topology.faces.size());
    forAll(areas, facei)
    {
        areas[facei] = core.topology.faces[facei].mag(core.points);
    }
    scalarField largest(core.nCells, 0);
    forAll(areas, facei)
    {
        largest[core.topology.owner[facei]] =
            max(largest[core.topology.owner[facei]], areas[facei]);
        if (facei < core.topology.neighbour.size())
        {
            const label nei = core.topology.neighbour[facei];
            largest[nei] = max(largest[nei], areas[facei]);
        }
    }
    forAll(cut.cutFaces, i)
    {
        EXPECT_GT(areas[cut.cutFaces[i]], 0.9*largest[cut.cutCells[i]]);
    }
}


TEST(cutCore, coupledPatchesAreNotReached)
{
    cubeInBox c(nearASide());
    c.core.patches.entries[1].set("type", "cyclicAMI");

    expectWords(c.errorAt(0.5), {"the patch high", "cyclicAMI", "from them"});
}


TEST(cutCore, oneOfTwoCoupledPatchesIsNotLeftAlone)
{
    // The low side is in the cube, the high one far from it
    const wallSurface wall
    (
        testSurfaces::translated
        (
            testSurfaces::cube(2, 8), vector(-8.3, -4, -4)
        )
    );
    const wallSearch search(wall);
    const wallSurface far(testSurfaces::translated(wall, vector(50, 0, 0)));
    const wallSearch nowhere(far);
    hexCoreBox box;
    box.box = boundBox(point::uniform(-2), point::uniform(2));
    box.patches.append("low", "cyclic");
    box.patches.append("high", "cyclic");
    box.patches.append("sides", "patch");
    box.patches.entries[0].set("neighbourPatch", word("high"));
    box.patches.entries[1].set("neighbourPatch", word("low"));
    box.sidePatches = labelList({0, 1, 2, 2, 2, 2});
    const polyMeshParts core
    (
        makeHexCore
        (
            box, coreObstacles{nowhere, nowhere},
            [](const point&) { return 0.5/1.2; }, 1000000
        )
    );

    const auto errorOf = [&](const List<labelPair>& pairs)
    {
        return thrownMessage<error>
        (
            [&]()
            {
                cutCore(core, coreObstacles{search, search}, 0.1, {}, pairs);
            }
        );
    };
    expectWords(errorOf({}), {"the patch low", "of type cyclic"});
    expectWords(errorOf({{0, 1}}), {"the patch high", "of type cyclic"});
}


//- The core without the cells that do not stay: the faces beside these are a
//  patch, body, as in a castellated mesh
static polyMeshParts castellated
(
    const polyMeshParts& core,
    const labelUList& stays
)
{
    const labelList newCells(invert(core.nCells, stays));
    polyMeshParts made;
    made.points = core.points;
    made.nCells = stays.size();
    made.patches = core.patches;
    made.patches.append("body", "wall");
    const polyMeshTopology& t = core.topology;
    meshBuilder faces;

    forAll(t.neighbour, facei)
    {
        const label own = newCells[t.owner[facei]];
        const label nei = newCells[t.neighbour[facei]];
        const face& f = t.faces[facei];
        if (own >= 0)
        {
            faces.append(f, own, nei >= 0 ? nei : meshBuilder::onPatch(2));
        }
        else if (nei >= 0)
        {
            faces.append(f.reverseFace(), nei, meshBuilder::onPatch(2));
        }
    }
    for (label patchi = 0; patchi < 2; ++patchi)
    {
        for (const label facei : t.patchFaces(patchi))
        {
            const label own = newCells[t.owner[facei]];
            if (own >= 0)
            {
                faces.append
                (
                    t.faces[facei], own, meshBuilder::onPatch(patchi)
                );
            }
        }
    }
    made.topology = faces.topology(faces.order(stays.size(), 3), 3);

    return made;
}


TEST(cutCore, cellsOnAPatchOfTheWallGo)
{
    // Cells that the cube touches are left out: all cells on the 6 x 4 faces
    // beside these go, whatever the gap
    const cubeInBox c(0.5, 0.8);
    const coreCut around(c.cut(0.1));
    EXPECT_EQ(around.cells.size(), 8*8*8 - 2*2*2);

    const coreCut cut
    (
        cutCore
        (
            castellated(c.core, around.cells),
            coreObstacles{c.search, c.search}, 0.1
        )
    );
    EXPECT_EQ(cut.wallPatches, wordList({"body"}));
    EXPECT_EQ(cut.cells.size(), 8*8*8 - 2*2*2 - 6*4);
    EXPECT_EQ(cut.nBoundary, 0);
}


TEST(cutCore, aPatchBehindTheWallMayStickOut)
{
    // The 8 cells around the origin are left out, and one on the high side. The
    // patch has 24 faces inside of the larger cube, and 5 in the fluid. The
    // latter do not look at the cube.
    const cubeInBox c(0.5, 0.8);
    const cubeInBox larger(0.5, 1.8);
    pointField centres;
    scalarField volumes;
    setCentresAndVolumes(c.core, identity(c.core.nCells), centres, volumes);
    DynamicList<label> stays;
    forAll(centres, celli)
    {
        const point& x = centres[celli];
        if
        (
            cmptMax(cmptMag(x)) > 0.5
         && mag(x - point(1.75, 0.25, 0.25)) > SMALL
        )
        {
            stays.append(celli);
        }
    }
    ASSERT_EQ(stays.size(), 8*8*8 - 8 - 1);

    const coreCut cut
    (
        cutCore
        (
            castellated(c.core, stays),
            coreObstacles{larger.search, larger.search}, 0.1
        )
    );
    EXPECT_EQ(cut.wallPatches, wordList({"body"}));

    // The cells beside the one on the high side go, with their faces there
    EXPECT_EQ(cut.nBoundary, 2*4);
}


TEST(cutCore, noFenceGoesAroundAPatchOfTheWall)
{
    // Of the cells on the low side 2 x 2 are left out, and the 12 around these
    // go: there are 16 edges around them
    const cubeInBox c(0.5, 0.8, point(0, 0, -2));
    const coreCut around(c.cut(0.1));
    EXPECT_EQ(around.cells.size(), 8*8*8 - 2*2);
    List<sidePatch> planes(1);
    planes[0].name = "low";
    planes[0].origin = point(0, 0, -2);
    planes[0].normal = vector(0, 0, -1);

    const coreCut cut
    (
        cutCore
        (
            castellated(c.core, around.cells),
            coreObstacles{c.search, c.search}, 0.1, planes
        )
    );
    EXPECT_EQ(cut.wallPatches, wordList({"body"}));
    ASSERT_EQ(cut.borders.size(), 1);
    EXPECT_EQ(cut.borders[0].size(), 16);
    EXPECT_TRUE(cut.limits[0].empty());
}


TEST(cutCore, sidesOfTheDomainThatAreNearAreNotOnTheWall)
{
    // All faces on the high sides are nearer to the cube than twice their
    // width, but look away from it
    const cubeInBox c(1, 2.6, point::uniform(0.5));
    const coreCut cut(c.cut(0.1));

    EXPECT_EQ(cut.wallPatches, wordList());
    EXPECT_EQ(cut.nBoundary, 2*3*3*3);
}


TEST(cutCore, aGapThatLeavesNoCellIsRefused)
{
    expectWords(cubeInBox(1, 1.4).errorAt(5), {"No cell", "farField.gap"});
}


// ************************************************************************* //
