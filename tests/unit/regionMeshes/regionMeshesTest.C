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

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

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


//- A ball in a box
static spaceRegions ballInBox()
{
    wallSurface box(cubeAt(point(0, 0, 0), 4, 2));
    box.patchNames = wordList({"box"});
    wallSurface ball(translated(sphere(6), point(2, 2, 2)));
    ball.patchNames = wordList({"ball"});

    return makeSpaceRegions
    (
        makeArrangement(merge(box, ball)),
        List<regionSeed>
        ({
            {"air", point(0.3, 0.2, 3.1)},
            {"ball", point(2.01, 2.02, 2.03)}
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


//- The parts of a region: layers in air, none in bodies
static regionParts partsOf
(
    spaceRegions& all,
    const label regioni,
    const bool forPolygons = false
)
{
    prismLayerControls controls;
    controls.farField.forPolygons = forPolygons;
    controls.layers = withoutLayers(wordList({"box"}));
    controls.farField.type = farFieldType::tet;
    const regionWall walls(prepareRegion(all, regioni, controls));
    const wallSurface& wall = walls.wall;
    farFieldDomain domain;
    if (walls.far.faces.size())
    {
        domain.boundary = makeFarBoundary(walls.far);
        controls.farField.boundary.type = farBoundaryType::surface;
    }
    regionParts parts;
    parts.layers =
        all.regions[regioni].name == "air"
      ? layeredMesh(wall, 3, 0.1).made.layers : wallWithoutLayers(wall);
    parts.farField =
        makeFarFieldMesh(parts.layers, domain, controls.farField);
    parts.common = commonTrianglesOf(all, regioni, wall);

    return parts;
}


static polyMeshParts meshOf(spaceRegions& all, const label regioni)
{
    regionParts parts(partsOf(all, regioni));

    return makePrismMeshParts(parts.layers, parts.farField);
}


//- Opens the boundary of a region
static void openBoundary(spaceRegions& all, const label regioni)
{
    all.open
    (
        regioni,
        [](const word& patch) { return patch == "box"; },
        regioni ? tetOpening : layerOpening
    );
}


static List<polygonMesh> polygonsOf(spaceRegions& all)
{
    std::vector<regionParts> parts;
    forAll(all.regions, r)
    {
        openBoundary(all, r);
        parts.push_back(partsOf(all, r, true));
    }

    return makePolygonRegions(all, parts);
}


//- The places of the points of each common polygon that two regions or two
//  sides of a sheet have, sorted, and the label of the polygon before them
static std::vector<std::vector<scalar>> commonPlaces
(
    const spaceRegions& all,
    const polygonMesh& made
)
{
    std::vector<std::vector<scalar>> polygons;
    forAll(made.commonPolygons, facei)
    {
        const label polygon = made.commonPolygons[facei];
        const labelPair both(all.regionsOfFace[max(polygon, 0)/3]);
        if (polygon < 0 || both.first() < 0 || both.second() < 0)
        {
            continue;
        }
        std::vector<std::vector<scalar>> places;
        for (const label p : made.mesh.topology.faces[facei])
        {
            const point& x = made.mesh.points[p];
            places.push_back({x.x(), x.y(), x.z()});
        }
        std::sort(places.begin(), places.end());
        polygons.push_back({scalar(polygon)});
        for (const std::vector<scalar>& x : places)
        {
            polygons.back().insert
            (
                polygons.back().end(), x.begin(), x.end()
            );
        }
    }
    std::sort(polygons.begin(), polygons.end());

    return polygons;
}


//- The mesh of polygons of all regions
static polyMeshParts joined(const spaceRegions& all, List<polygonMesh>& made)
{
    List<polyMeshParts> meshes;
    List<labelList> polygons;
    for (polygonMesh& one : made)
    {
        meshes.append(one.mesh);
        polygons.append(one.commonPolygons);
    }

    return joinRegions(all, meshes, polygons);
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


//- The polygons of faces between regions: they are triangles
static List<labelList> triangles(const spaceRegions& all)
{
    return List<labelList>(all.regions.size());
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
    const memoryMesh joined(joinRegions(all, meshes, triangles(all)));
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
    separateRegions(all, meshes, triangles(all));

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
        thrownMessage<Foam::error>
        (
            [&]() { joinRegions(all, meshes, triangles(all)); }
        ),
        {"box", "symmetry"}
    );
}


TEST(closeRegion, bothSidesOfASheetAreWallsInOnePlace)
{
    spaceRegions all(finOnBody());
    List<polyMeshParts> meshes;
    forAll(all.regions, r)
    {
        openBoundary(all, r);
        meshes.append(meshOf(all, r));
        closeRegion(all, r, meshes.last());
    }

    const memoryMesh joined(joinRegions(all, meshes, triangles(all)));
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


TEST(makePolygonRegions, bothSidesHaveThePolygonsToTheLastDigit)
{
    spaceRegions all(ballInBox());
    List<polygonMesh> made(polygonsOf(all));
    const auto air = commonPlaces(all, made[0]);
    EXPECT_EQ(air, commonPlaces(all, made[1]));

    // Around points, not on triangles
    ASSERT_GT(air.size(), 0);
    EXPECT_LT(label(air.size()), sphere(6).faces.size());

    const memoryMesh mesh(joined(all, made));
    expectSound(mesh());
    EXPECT_EQ(mesh().faceZones()["air_to_ball"].size(), label(air.size()));
    EXPECT_EQ(mesh().boundaryMesh().names(), wordList({"box"}));
}


TEST(makePolygonRegions, sharpEdgesOfAllRegionsStay)
{
    spaceRegions all(bodyInBox());
    List<polygonMesh> made(polygonsOf(all));
    const memoryMesh mesh(joined(all, made));
    expectSound(mesh());
    const scalarList volumes({64 - 8, 8 - 1, 1});
    forAll(all.regions, r)
    {
        const cellZone& zone = mesh().cellZones()[all.regions[r].name];
        EXPECT_NEAR(volumeOf(mesh(), zone), volumes[r], 1e-9);
    }
}


TEST(makePolygonRegions, bothSidesOfASheetHaveThePolygons)
{
    spaceRegions all(finOnBody());
    List<polygonMesh> made(polygonsOf(all));
    const polyMeshParts& air = made[0].mesh;
    const auto onAir = commonPlaces(all, made[0]);
    const auto shell = commonPlaces(all, made[1]);

    // Each polygon of the fin twice, each one of the body once in both regions
    label nTwice = 0;
    for (const auto& polygon : onAir)
    {
        const label n = std::count(onAir.begin(), onAir.end(), polygon);
        const label nBeyond = std::count(shell.begin(), shell.end(), polygon);
        EXPECT_EQ(n + nBeyond, 2);
        nTwice += n == 2;
    }
    const label patchi = air.patches.names.find("fin");
    ASSERT_GE(patchi, 0);
    EXPECT_EQ(nTwice, air.topology.patchSizes[patchi]);

    // A stack of cells on each of them
    labelHashSet cells;
    forAll(made[0].commonPolygons, facei)
    {
        if (made[0].commonPolygons[facei] >= 0)
        {
            EXPECT_TRUE(cells.insert(air.topology.owner[facei]));
        }
    }
    const memoryMesh mesh(joined(all, made));
    expectSound(mesh());
}


// ************************************************************************* //
