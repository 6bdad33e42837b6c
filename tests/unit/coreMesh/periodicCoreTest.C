/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "makeHexCore.H"
#include "openSurfaces.H"
#include "periodicCore.H"
#include "testSurfaces.H"
#include "thrownMessage.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Hexahedra in a cube with the patches left, right, front and back, which are
//  small near to left and front
static polyMeshParts smallNearLeft(const bool isPeriodic)
{
    static const wallSurface sphere
    (
        testSurfaces::translated
        (
            testSurfaces::sphere(4, 0.2), vector(0.6, 0.4, 0.5)
        )
    );
    static const wallSearch search(sphere);
    hexCoreBox box;
    box.box = boundBox(point::zero, point::uniform(1));
    for (const char* name : {"left", "right", "front", "back"})
    {
        box.patches.append(name, "cyclic");
    }
    box.patches.append("ends", "patch");
    box.sidePatches = labelList({0, 1, 2, 3, 4, 4});
    box.isPeriodic[0] = box.isPeriodic[1] = isPeriodic;

    return makeHexCore
    (
        box, coreObstacles{search, search},
        [](const point& x) { return 0.04 + 0.2*x.x() + 0.1*x.y(); }, 1000000
    );
}


static std::string errorOf(polyMeshParts core)
{
    return thrownMessage<error>
    (
        [&]() { cyclicPatchesOf(testSurfaces::cyclicPlanes(), core); }
    );
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(periodicCore, hexahedraHaveEqualFacesOnPeriodicSides)
{
    polyMeshParts core(smallNearLeft(true));
    const pointField points(core.points);
    const List<labelPair> pairs
    (
        cyclicPatchesOf(testSurfaces::cyclicPlanes(), core)
    );

    EXPECT_EQ(pairs, List<labelPair>({{0, 1}, {2, 3}}));
    EXPECT_EQ(core.points, points);
    EXPECT_GT(core.topology.patchSizes[0], 100);
    EXPECT_GT(core.topology.patchSizes[2], 100);
}


// What isPeriodic is for
TEST(periodicCore, otherHexahedraAreRefused)
{
    expectWords
    (
        errorOf(smallNearLeft(false)),
        {"not periodic", "left and right", "faces", "at (0 "}
    );
}


TEST(periodicCore, pointsMoveOntoImagesIfTheyAreNear)
{
    polyMeshParts core(smallNearLeft(true));
    const polyMeshTopology& t = core.topology;
    const label p = t.faces[t.patchStarts[1] + 7][2];
    const point x(core.points[p]);

    core.points[p] += vector(0, 1e-7, 0);
    cyclicPatchesOf(testSurfaces::cyclicPlanes(), core);
    EXPECT_EQ(core.points[p], x);

    core.points[p] += vector(0, 1e-3, 0);
    expectWords
    (
        errorOf(core),
        {"not periodic", "left and right", "up to 0.001 m", "at (1 "}
    );
}


TEST(periodicCore, patchesThatNameEachOtherAreAPair)
{
    polyMeshParts core(smallNearLeft(true));
    core.patches.entries[0].set("neighbourPatch", word("right"));
    core.patches.entries[1].set("neighbourPatch", word("left"));
    core.patches.entries[2].set("type", word("patch"));
    core.patches.entries[3].set("type", word("patch"));

    EXPECT_EQ(cyclicPatchesBeside({}, core), List<labelPair>({{0, 1}}));
    EXPECT_TRUE
    (
        cyclicPatchesBeside(testSurfaces::cyclicPlanes(), core).empty()
    );
}


TEST(periodicCore, patchesMustBeCyclic)
{
    polyMeshParts core(smallNearLeft(true));
    core.patches.entries[3].set("type", word("patch"));
    expectWords(errorOf(core), {"no patch back of type cyclic", "front"});
}

// ************************************************************************* //
