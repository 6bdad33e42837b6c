/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cyclicPolyPatch.H"
#include "memoryMesh.H"
#include "openSurfaces.H"
#include "ranges.H"
#include "sidePair.H"
#include "testFarField.H"
#include "testStages.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using namespace testSurfaces;

//- Waves with five layers
static const prismLayerMesh& wavesRun()
{
    static const prismLayerMesh run(layeredMesh(periodicWaves(8), 5, 0.1));

    return run;
}


//- The far field of the waves, up to z = 1
static farFieldMesh wavesFarField(const farFieldType type)
{
    farFieldControls controls;
    controls.type = type;
    controls.maxCellSize = 0.1;
    controls.boundary.type = farBoundaryType::box;
    controls.boundary.box = boundBox(point(0, 0, -1), point(1, 1, 1));

    return farFieldOf(wavesRun(), controls);
}


//- The waves with tetrahedra
static const polyMesh& wavesMesh()
{
    static const memoryMesh mesh
    (
        wavesRun().made.layers, wavesFarField(farFieldType::tet)
    );

    return mesh();
}


//- The face of the second side is that of the first, moved, seen from the other
//  side, from the same point on
static void expectImage
(
    const polyMesh& mesh,
    const face& first,
    const face& second,
    const rigidMotion& motion
)
{
    ASSERT_EQ(first.size(), second.size());
    for (label k = 0; k < first.size(); ++k)
    {
        const label image = second[(first.size() - k) % first.size()];
        EXPECT_NEAR
        (
            mag(motion(mesh.points()[first[k]]) - mesh.points()[image]), 0,
            1e-15
        );
    }
}


static void expectImages(const polyMesh& mesh)
{
    const List<sidePatch> sides(cyclicPlanes());
    for (const sidePair& pair : pairsOf(sides))
    {
        const polyPatch& first = mesh.boundaryMesh()[sides[pair.first].name];
        const polyPatch& second = mesh.boundaryMesh()[sides[pair.second].name];
        EXPECT_TRUE(isA<cyclicPolyPatch>(first));
        EXPECT_TRUE(isA<cyclicPolyPatch>(second));
        ASSERT_EQ(first.size(), second.size());
        EXPECT_GT(first.size(), 5*8);
        forAll(first, i)
        {
            expectImage(mesh, first[i], second[i], pair.toSecond);
        }
    }
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(cyclicMesh, facesOfPairsAreImages)
{
    expectImages(wavesMesh());
}


TEST(cyclicMesh, facesOfPairsAreImagesAroundACore)
{
    const farFieldMesh far(wavesFarField(farFieldType::hexCore));
    const memoryMesh mesh(wavesRun().made.layers, far);

    ASSERT_EQ(far.cellZones.last().name, hexCoreName);
    EXPECT_GT(far.cellZones.last().cells.size(), 50);
    expectImages(mesh());
}


// Cells of the core at the sides make room for the layers
TEST(cyclicMesh, facesOfPairsAreImagesWhereABodyIsNear)
{
    const wallSurface ball
    (
        translated(quadSphere(6, 0.3), vector(0.4, 0.5, 0.5))
    );
    const prismLayerMesh run(layeredMesh(ball, 3, 0.05));
    farFieldControls controls;
    controls.type = farFieldType::hexCore;
    controls.maxCellSize = 0.1;
    controls.boundary.type = farBoundaryType::box;
    controls.boundary.box = boundBox(point::zero, point::uniform(1));
    const List<sidePatch> planes(cyclicPlanes());
    const char* sides[] = {"xMin", "xMax", "yMin", "yMax"};
    forAll(planes, i)
    {
        farPatch patch;
        patch.name = planes[i].name;
        patch.type = planes[i].type;
        patch.cyclic = planes[i].cyclic;
        patch.sides = wordRes(1, wordRe(word(sides[i])));
        controls.boundary.patches.append(patch);
    }
    const farFieldMesh far(farFieldOf(run, controls));
    const memoryMesh mesh(run.made.layers, far);
    const polyPatch& left = mesh().boundaryMesh()["left"];

    expectImages(mesh());
    EXPECT_TRUE(anyOf(left, [](const face& f) { return f.size() == 3; }));
    EXPECT_TRUE(anyOf(left, [](const face& f) { return f.size() > 3; }));
}


TEST(cyclicMesh, thePatchesKnowTheirNeighbours)
{
    const polyBoundaryMesh& patches = wavesMesh().boundaryMesh();
    const auto& left = refCast<const cyclicPolyPatch>(patches["left"]);
    const auto& right = refCast<const cyclicPolyPatch>(patches["right"]);

    EXPECT_EQ(left.neighbPatchName(), "right");
    EXPECT_EQ(right.neighbPatchName(), "left");
    EXPECT_EQ(left.transform(), coupledPolyPatch::TRANSLATIONAL);
    ASSERT_EQ(left.separation().size(), 1);
    EXPECT_NEAR(mag(left.separation()[0]), 1, 1e-12);
    EXPECT_EQ(left.coupledPoints().size(), left.nPoints());
}

// ************************************************************************* //
