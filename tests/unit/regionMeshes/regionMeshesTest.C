/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "regionMeshes.H"
#include "boundBox.H"
#include "makeFarFieldMesh.H"
#include "memoryMesh.H"
#include "openSurfaces.H"
#include "prepareWall.H"
#include "prismPolyMesh.H"
#include "soundMesh.H"
#include "SubField.H"
#include "testStages.H"
#include "thrownMessage.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static wallSurface cubeAt(const point& low, const scalar size, const label n)
{
    const wallSurface at(cube(n, size));

    return translated(at, low - boundBox(at.points, false).min());
}


//- A body on the floor of a box, the air around it, and a body within it
static spaceRegions bodyInBox()
{
    wallSurface box(cubeAt(point(0, 0, 0), 4, 2));
    box.patchNames = wordList({"box"});
    wallSurface body(cubeAt(point(1, 1, 0), 2, 4));
    body.patchNames = wordList({"body"});
    wallSurface core(cubeAt(point(1.5, 1.5, 0.5), 1, 3));
    core.patchNames = wordList({"core"});

    return makeSpaceRegions
    (
        makeArrangement(merge(box, merge(body, core))),
        List<regionSeed>
        ({
            {"air", point(0.3, 0.2, 3.1)},
            {"shell", point(1.2, 1.3, 0.2)},
            {"core", point(2.01, 2.02, 1.03)}
        })
    );
}


//- A body on the floor of a box, with a fin of no thickness on it
static spaceRegions finOnBody()
{
    wallSurface box(cubeAt(point(0, 0, 0), 4, 2));
    box.patchNames = wordList({"box"});
    wallSurface body(cubeAt(point(1, 1, 0), 2, 4));
    body.patchNames = wordList({"body"});
    wallSurface fin(triangulated(sheet(2, 0)));
    for (point& x : fin.points)
    {
        x = point(2, 1.5 + x.x(), 2 + 0.6*x.y());
    }
    fin.patchNames = wordList({"fin"});
    return makeSpaceRegions
    (
        makeArrangement(merge(box, merge(body, fin))),
        List<regionSeed>
        ({
            {"air", point(0.3, 0.2, 3.1)},
            {"shell", point(1.2, 1.3, 0.2)}
        }),
        wordRes(List<wordRe>({wordRe("fin")}))
    );
}


//- The mesh of a region: layers in air, none in bodies
static polyMeshParts meshOf(spaceRegions& all, const label regioni)
{
    prismLayerControls controls;
    controls.layers = withoutLayers(wordList({"box"}));
    controls.farField.type = farFieldType::tet;
    const wallSurface wall(prepareRegion(all, regioni, controls).wall);
    const prismLayers layers
    (
        all.regions[regioni].name == "air"
      ? layeredMesh(wall, 3, 0.1).made.layers : wallWithoutLayers(wall)
    );
    farFieldMesh far
    (
        makeFarFieldMesh(layers, farFieldDomain(), controls.farField)
    );

    return makePrismMeshParts(layers, far);
}


static List<polyMeshParts> meshesOf(spaceRegions& all)
{
    List<polyMeshParts> meshes;
    forAll(all.regions, r)
    {
        meshes.append(meshOf(all, r));
    }

    return meshes;
}


static scalar volumeOf(const polyMesh& mesh, const labelUList& cells)
{
    scalar sum = 0;
    for (const label c : cells)
    {
        sum += mesh.cellVolumes()[c];
    }

    return sum;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(joinRegions, oneMeshHasZonesOfRegionsAndOfFacesBetween)
{
    spaceRegions all(bodyInBox());
    List<polyMeshParts> meshes(meshesOf(all));
    const memoryMesh joined(joinRegions(all, meshes));
    const polyMesh* mesh = &joined();
    expectSound(*mesh);

    const scalarList volumes({64 - 8, 8 - 1, 1});
    forAll(all.regions, r)
    {
        const cellZone& zone = mesh->cellZones()[all.regions[r].name];
        EXPECT_NEAR(volumeOf(*mesh, zone), volumes[r], 1e-9);
    }

    ASSERT_EQ(mesh->faceZones().size(), 2);
    const faceZone& air = mesh->faceZones()["air_to_shell"];
    scalar area = 0;
    for (const label f : air)
    {
        const vector& s = mesh->faceAreas()[f];
        area += mag(s);
        const point inside(2, 2, 1);

        // From the air into the body
        EXPECT_GT(s & (inside - mesh->faceCentres()[f]), 0);
        EXPECT_TRUE(mesh->isInternalFace(f));
    }
    EXPECT_NEAR(area, 4*4 + 4, 1e-10);
    EXPECT_EQ(mesh->boundaryMesh().names(), wordList({"box"}));
    EXPECT_FALSE(mesh->faceZones()["shell_to_core"].empty());
}


TEST(separateRegions, facesBetweenAreMappedPatchesOfBoth)
{
    spaceRegions all(bodyInBox());
    List<polyMeshParts> meshes(meshesOf(all));
    separateRegions(all, meshes);

    const auto centresOn = [&](const label r, const word& patch)
    {
        const polyMeshParts& mesh = meshes[r];
        const label patchi = mesh.patches.names.find(patch);
        pointField centres;
        const label n = patchi < 0 ? 0 : mesh.topology.patchSizes[patchi];
        for (label i = 0; i < n; ++i)
        {
            centres.append
            (
                mesh.topology.faces[mesh.topology.patchStarts[patchi] + i]
                    .centre(mesh.points)
            );
        }

        return centres;
    };
    const pointField air(centresOn(0, "air_to_shell"));
    const pointField shell(centresOn(1, "shell_to_air"));
    ASSERT_GT(air.size(), 0);
    ASSERT_EQ(air.size(), shell.size());
    EXPECT_LT(gMax(mag(air - shell)()), 1e-14);

    const label patchi = meshes[1].patches.names.find("shell_to_core");
    ASSERT_GE(patchi, 0);
    const dictionary& entries = meshes[1].patches.entries[patchi];
    EXPECT_EQ(entries.get<word>("type"), "mappedWall");
    EXPECT_EQ(entries.get<word>("sampleRegion"), "core");
    EXPECT_EQ(entries.get<word>("samplePatch"), "core_to_shell");
    EXPECT_FALSE(meshes[1].patches.names.found("body"));
}


TEST(joinRegions, aPatchOfTwoTypesIsRefused)
{
    spaceRegions all(bodyInBox());
    List<polyMeshParts> meshes(meshesOf(all));
    meshes[1].patches.entries[meshes[1].patches.names.find("box")].set
    (
        "type", word("symmetry")
    );
    expectWords
    (
        thrownMessage<Foam::error>([&]() { joinRegions(all, meshes); }),
        {"box", "symmetry"}
    );
}


TEST(closeRegion, bothSidesOfASheetAreWallsInOnePlace)
{
    spaceRegions all(finOnBody());
    List<polyMeshParts> meshes;
    forAll(all.regions, r)
    {
        all.open
        (
            r,
            [](const word& patch) { return patch == "box"; },
            r ? tetOpening : layerOpening
        );
        meshes.append(meshOf(all, r));
        closeRegion(all, r, meshes.last());
    }

    const memoryMesh joined(joinRegions(all, meshes));
    const polyMesh& mesh = joined();
    expectSound(mesh);
    const polyPatch& patch =
        mesh.boundaryMesh()[mesh.boundaryMesh().findPatchID("fin")];
    scalar area = 0;
    vector sum(Zero);
    for (const vector& s : vectorField(patch.faceAreas()))
    {
        area += mag(s);
        sum += s;
    }
    EXPECT_NEAR(area, 2*0.6, 1e-12);
    EXPECT_LT(mag(sum), 1e-12);
    for (const point& x : patch.localPoints())
    {
        EXPECT_EQ(x.x(), 2);
    }
    for (const label celli : patch.faceCells())
    {
        EXPECT_GT(mesh.cellVolumes()[celli], 0);
    }
    EXPECT_NEAR(volumeOf(mesh, mesh.cellZones()["air"]), 64 - 8, 1e-9);
}


// ************************************************************************* //
