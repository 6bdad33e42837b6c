/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farFieldReport.H"
#include "makeHexCore.H"
#include "memoryMesh.H"
#include "soundMesh.H"
#include "testFarField.H"
#include "testStages.H"
#include "testSurfaces.H"
#include "thrownMessage.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Layers with a far field of the given type
struct coreCase
{
    prismLayers layers;
    farFieldMesh far;

    coreCase
    (
        const wallSurface& wall,
        const farFieldControls& controls,
        const polyMeshParts& core = polyMeshParts()
    )
    {
        const prismLayerMesh run(testSurfaces::layeredMesh(wall, 3, 0.1));
        layers = run.made.layers;
        far = farFieldOf(run, controls, core);
    }
};


static farFieldControls hexCoreControls(const farBoundaryType boundary)
{
    farFieldControls controls;
    controls.type = farFieldType::hexCore;
    controls.boundary.type = boundary;
    controls.boundary.box = boundBox(point::uniform(-4), point::uniform(4));
    controls.boundary.radius = 4;

    return controls;
}


static farFieldControls meshControls()
{
    farFieldControls controls;
    controls.type = farFieldType::mesh;

    return controls;
}


//- Cubes of the width 0.25 in a box; their patches, and zones of the half with
//  x > 0 and of the faces at x = 0.75
static polyMeshParts cubes(const scalar halfWidth, const point& centre = Zero)
{
    const wallSurface sphere(testSurfaces::sphere(4, 0.1));
    const wallSearch search(sphere);
    hexCoreBox box;
    box.box = boundBox
    (
        centre - vector::uniform(halfWidth), centre + vector::uniform(halfWidth)
    );
    box.patches.append("inlet", "patch");
    box.patches.append("floor", "wall");
    box.sidePatches = labelList({0, 1, 1, 1, 1, 1});
    polyMeshParts parts
    (
        makeHexCore
        (
            box, coreObstacles{search, search},
            [](const point&) { return 0.25/1.2; }, 1000000
        )
    );

    DynamicList<label> right;
    pointField centres;
    scalarField volumes;
    setCentresAndVolumes(parts, identity(parts.nCells), centres, volumes);
    forAll(centres, celli)
    {
        if (centres[celli].x() > 0)
        {
            right.append(celli);
        }
    }
    DynamicList<label> plane;
    forAll(parts.topology.neighbour, facei)
    {
        const point x(parts.topology.faces[facei].centre(parts.points));
        if (mag(x.x() - 1.5) < 1e-9)
        {
            plane.append(facei);
        }
    }
    parts.cellZones = List<cellZoneParts>
    ({
        cellZoneParts("right", right),
        cellZoneParts("rotor", identity(parts.nCells))
    });
    parts.faceZones = List<faceZoneParts>
    ({
        {"plane", plane, boolList(plane.size(), false)}
    });

    return parts;
}


static std::string errorOf(const polyMeshParts& core)
{
    return thrownMessage<error>
    (
        [&]() { coreCase(testSurfaces::sphere(5), meshControls(), core); }
    );
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(coreFarField, hexahedraFillTheBox)
{
    const coreCase c
    (
        testSurfaces::sphere(5), hexCoreControls(farBoundaryType::box)
    );
    const memoryMesh memory(c.layers, c.far);
    const polyMesh& mesh = memory();

    EXPECT_EQ
    (
        mesh.boundaryMesh().names(),
        wordList({"wall", "xMin", "xMax", "yMin", "yMax", "zMin", "zMax"})
    );
    EXPECT_EQ
    (
        mesh.cellZones().names(),
        wordList({"boundaryLayer", "farField", "hexCore"})
    );
    EXPECT_GT(mesh.cellZones()[2].size(), 100);
    expectSound(mesh);
    EXPECT_NEAR
    (
        sum(mesh.cellVolumes()),
        512 - testSurfaces::enclosedVolume(testSurfaces::sphere(5)), 1e-9
    );

    const farFieldReport report
    (
        makeFarFieldReport(c.layers, c.far, qualityControls())
    );
    EXPECT_EQ(report.nTets, mesh.cellZones()[1].size());
    EXPECT_EQ(report.nCells, c.far.nCells);
    EXPECT_GT(report.cut.nFaces, 0);
    EXPECT_LT(report.cut.maxNonOrtho, 55);
    EXPECT_GT(report.core.nFaces, report.cut.nFaces);
}


TEST(coreFarField, cellsOfASphereAreTetrahedraAtBothSurfaces)
{
    const coreCase c
    (
        testSurfaces::sphere(5), hexCoreControls(farBoundaryType::sphere)
    );
    const memoryMesh memory(c.layers, c.far);

    EXPECT_EQ(memory().boundaryMesh().names(), wordList({"wall", "sphere"}));
    EXPECT_GT(memory().boundaryMesh()["sphere"].size(), 8);
    EXPECT_GT(memory().cellZones()["hexCore"].size(), 100);
    expectSound(memory());
}


TEST(coreFarField, theInsideOfAWallIsFilled)
{
    farFieldControls controls(hexCoreControls(farBoundaryType::none));
    controls.maxCellSize = 0.1;
    const coreCase c
    (
        testSurfaces::reversed(testSurfaces::cube(12, 2)), controls
    );
    const memoryMesh memory(c.layers, c.far);

    EXPECT_GT(memory().cellZones()["hexCore"].size(), 100);
    EXPECT_EQ(memory().boundaryMesh().names(), wordList({"wall"}));
    EXPECT_NEAR(sum(memory().cellVolumes()), 8, 1e-9);
    expectSound(memory());
}


TEST(coreFarField, patchesAndZonesOfAMeshSurvive)
{
    const polyMeshParts core(cubes(3));
    const coreCase c(testSurfaces::sphere(5), meshControls(), core);
    const memoryMesh memory(c.layers, c.far);
    const polyMesh& mesh = memory();

    EXPECT_EQ
    (
        mesh.boundaryMesh().names(), wordList({"wall", "inlet", "floor"})
    );
    EXPECT_EQ(mesh.boundaryMesh()["inlet"].size(), 24*24);
    EXPECT_EQ(mesh.boundaryMesh()["floor"].type(), "wall");
    EXPECT_NEAR
    (
        sum(mesh.cellVolumes()),
        216 - testSurfaces::enclosedVolume(testSurfaces::sphere(5)), 1e-9
    );
    expectSound(mesh);

    // What stays of the zones is where they were
    for (const label celli : mesh.cellZones()["right"])
    {
        EXPECT_GT(mesh.cellCentres()[celli].x(), 0);
    }
    // All cells that made room were in it
    EXPECT_EQ(mesh.cellZones()["rotor"].size(), mesh.nCells());
    ASSERT_GT(c.far.notes.size(), 0);
    EXPECT_NE
    (
        c.far.notes[1].find("The cellZone right has lost "), std::string::npos
    )   << c.far.notes[1];

    const faceZone& plane = mesh.faceZones()["plane"];
    EXPECT_GT(plane.size(), 24*24 - 50);
    forAll(plane, i)
    {
        const vector area
        (
            mesh.faceAreas()[plane[i]]*(plane.flipMap()[i] ? -1 : 1)
        );
        EXPECT_NEAR(mesh.faceCentres()[plane[i]].x(), 1.5, 1e-9);
        EXPECT_GT(area.x(), 0);
    }
}


TEST(coreFarField, aZoneAroundOneBodyHasItsLayersAlone)
{
    const wallSurface sphere(testSurfaces::sphere(5, 0.5));
    const coreCase c
    (
        testSurfaces::merge
        (
            testSurfaces::translated(sphere, vector(-1.5, 0, 0)),
            testSurfaces::translated(sphere, vector(1.5, 0, 0))
        ),
        meshControls(), cubes(3)
    );
    const memoryMesh memory(c.layers, c.far);
    const polyMesh& mesh = memory();
    const cellZone& right = mesh.cellZones()["right"];

    // All cells of each half: layers, tetrahedra and cubes
    for (label celli = 0; celli < mesh.nCells(); ++celli)
    {
        EXPECT_EQ
        (
            right.whichCell(celli) >= 0, mesh.cellCentres()[celli].x() > 0
        );
    }
    for (const string& note : c.far.notes)
    {
        EXPECT_EQ(note.find("The cellZone"), std::string::npos) << note;
    }
}


TEST(coreFarField, meshesThatAreNotAroundTheLayersAreRefused)
{
    expectWords(errorOf(cubes(1)), {"No cell", "stays"});
    expectWords(errorOf(cubes(1, point(9, 0, 0))), {"not around the layers"});
}


TEST(coreFarField, meshesThatTheLayersCrossAreRefused)
{
    expectWords(errorOf(cubes(1, point(1, 0, 0))), {"cuts the layers"});
}


// ************************************************************************* //
