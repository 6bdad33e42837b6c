/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "partsOfMesh.H"
#include "makeHexCore.H"
#include "partsMesh.H"
#include "testSurfaces.H"
#include "thrownMessage.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Two cubes of width 1, the second so far behind the first, which they share
//  no face with
static autoPtr<polyMesh> apart(const Time& time, const vector& shift)
{
    const wallSurface cube(testSurfaces::quadCube(1));
    pointField points(cube.points);
    points.append(pointField(cube.points + shift));
    faceList faces(cube.faces);
    for (face f : cube.faces)
    {
        for (label& p : f)
        {
            p += cube.points.size();
        }
        faces.append(f);
    }
    labelList owner(cube.faces.size(), Zero);
    owner.append(labelList(cube.faces.size(), 1));
    const label n = faces.size();

    autoPtr<polyMesh> mesh
    (
        new polyMesh
        (
            IOobject("apart", time.constant(), time),
            std::move(points), std::move(faces), std::move(owner), labelList()
        )
    );
    PtrList<polyPatch> patches(1);
    patches.set
    (
        0, polyPatch::New("patch", "sides", n, 0, 0, mesh->boundaryMesh())
    );
    mesh->addPatches(patches);

    return mesh;
}


//- Two hexahedra in a box, with patches of a type
static autoPtr<polyMesh> twoCells(const Time& time, const word& type)
{
    const wallSurface sphere
    (
        testSurfaces::translated(testSurfaces::sphere(4, 0.3), vector(9, 0, 0))
    );
    const wallSearch search(sphere);
    hexCoreBox box;
    box.box = boundBox(point(0, 0, 0), point(2, 1, 1));
    box.patches.append("sides", type);
    box.sidePatches = labelList(6, Zero);
    polyMeshParts parts
    (
        makeHexCore
        (
            box, coreObstacles{search, search},
            [](const point&) { return scalar(1); }, 10
        )
    );
    autoPtr<polyMesh> mesh
    (
        new polyMesh
        (
            IOobject("two", time.constant(), time),
            std::move(parts.points),
            faceList(std::move(parts.topology.faces)),
            labelList(std::move(parts.topology.owner)),
            labelList(std::move(parts.topology.neighbour))
        )
    );
    PtrList<polyPatch> patches(1);
    patches.set
    (
        0, polyPatch::New(type, "sides", 10, 1, 0, mesh->boundaryMesh())
    );
    mesh->addPatches(patches);
    mesh->addZones
    (
        List<pointZone*>(),
        {
            new faceZone
            (
                "between", labelList(1, Zero), boolList(1, true), 0,
                mesh->faceZones()
            )
        },
        {new cellZone("right", labelList(1, 1), 0, mesh->cellZones())}
    );

    return mesh;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(partsOfMesh, patchesAndZonesAreThere)
{
    const autoPtr<Time> time(Time::New());
    const polyMeshParts parts(partsOf(twoCells(*time, "wall")()));

    EXPECT_EQ(parts.nCells, 2);
    EXPECT_EQ(parts.points.size(), 12);
    EXPECT_EQ(parts.topology.faces.size(), 11);
    EXPECT_EQ(parts.topology.patchStarts, labelList({1}));
    EXPECT_EQ(parts.topology.patchSizes, labelList({10}));
    EXPECT_EQ(parts.patches.names, wordList({"sides"}));
    EXPECT_EQ(parts.patches.types(), wordList({"wall"}));
    EXPECT_FALSE(parts.patches.entries[0].found("nFaces"));
    ASSERT_EQ(parts.cellZones.size(), 1);
    EXPECT_EQ(parts.cellZones[0].name, "right");
    EXPECT_EQ(parts.cellZones[0].cells, labelList({1}));
    ASSERT_EQ(parts.faceZones.size(), 1);
    EXPECT_EQ(parts.faceZones[0].faces, labelList({0}));
    EXPECT_TRUE(parts.faceZones[0].flips[0]);
}


TEST(partsOfMesh, meshesOfOneLayerOfCellsAreRefused)
{
    const autoPtr<Time> time(Time::New());
    const std::string message
    (
        thrownMessage<error>([&]() { partsOf(twoCells(*time, "empty")()); })
    );

    expectWords(message, {"The patch sides", "type empty"});
}


TEST(partsOfMesh, cellsThatOverlapAreRefused)
{
    const autoPtr<Time> time(Time::New());
    const std::string message
    (
        thrownMessage<error>
        (
            [&]() { partsOf(apart(*time, vector(0.3, 0.3, 0.3))()); }
        )
    );

    expectWords(message, {"overlap", "cell 1 at", "in cell 0"});
    EXPECT_EQ(partsOf(apart(*time, vector(1, 0, 0))()).nCells, 2);
}


// ************************************************************************* //
