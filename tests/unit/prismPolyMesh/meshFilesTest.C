/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshOrder.H"
#include "openSurfaces.H"
#include "prismPolyMesh.H"
#include "temporaryFiles.H"
#include "testFarField.H"
#include "testLayers.H"
#include "testStages.H"
#include "testSurfaces.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::testSurfaces;

//- A case in a folder that writes with 17 digits
static autoPtr<Time> caseIn
(
    const fileName& folder,
    const word& format,
    const word& compression
)
{
    infoDetailLevel = 0;
    dictionary control;
    control.add("deltaT", 1);
    control.add("writeInterval", 1);
    control.add("writeFormat", format);
    control.add("writeCompression", compression);
    control.add("writePrecision", 17);

    return autoPtr<Time>
    (
        new Time
        (
            control, folder.path(), folder.name(), "system", "constant",
            false, false
        )
    );
}


static IOobject meshOf(const Time& time, const word& region)
{
    return IOobject
    (
        region, time.constant(), time, IOobject::NO_READ, IOobject::AUTO_WRITE
    );
}


class meshFiles
:
    public temporaryFiles
{
protected:

    //- Expects that writeMesh writes the files that OpenFOAM writes of the
    //  mesh, and returns how many there are
    label expectSame
    (
        const prismLayers& layers,
        const farFieldMesh& far,
        const word& format,
        const word& compression,
        const word& region = polyMesh::defaultRegion
    );

    void expectSameInAllFormats
    (
        const prismLayers& layers,
        const farFieldMesh& far = farFieldMesh()
    )
    {
        expectSame(layers, far, "binary", "off");
        expectSame(layers, far, "ascii", "off");
        expectSame(layers, far, "ascii", "on", "fluid");
    }
};


label meshFiles::expectSame
(
    const prismLayers& layers,
    const farFieldMesh& far,
    const word& format,
    const word& compression,
    const word& region
)
{
    {
        const autoPtr<Time> time
        (
            caseIn(folder_/"whole", format, compression)
        );
        farFieldMesh taken(far);
        makePrismPolyMesh(layers, taken, meshOf(time(), region))->write();
    }
    {
        const autoPtr<Time> time
        (
            caseIn(folder_/"blocks", format, compression)
        );
        farFieldMesh taken(far);
        writeMesh(meshOrder(layers, taken).mesh(), meshOf(time(), region));
    }

    const fileName folder
    (
        region == polyMesh::defaultRegion
      ? fileName("constant/polyMesh") : "constant"/region/"polyMesh"
    );
    const fileNameList names
    (
        readDir(folder_/"whole"/folder, fileName::FILE, false)
    );
    EXPECT_EQ
    (
        readDir(folder_/"blocks"/folder, fileName::FILE, false).size(),
        names.size()
    );
    for (const fileName& name : names)
    {
        EXPECT_TRUE
        (
            contentsOf("whole"/folder/name) == contentsOf("blocks"/folder/name)
        )   << format << ' ' << name;
    }
    rmDir(folder_/"whole");
    rmDir(folder_/"blocks");

    return names.size();
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_F(meshFiles, oneBlockOfEach)
{
    const scalarList heights({0, 0.01, 0.03, 0.07});

    for (const prismLayers& layers :
        {
            onePolygon(3, scalarList({0, 1})), onePolygon(5, heights),
            straightLayers(cube(1), scalarList({0, 0.1})),
            straightLayers(quadCube(3), heights)
        })
    {
        expectSameInAllFormats(layers);
    }
}


TEST_F(meshFiles, manyBlocksOfEach)
{
    const prismLayers layers(shakenLayers(sphere(30)));

    ASSERT_GT(layers.points.size(), 20000);
    expectSameInAllFormats(layers);
}


TEST(meshInBlocks, ofPartsIsTheMesh)
{
    farFieldMesh none;
    const polyMeshParts parts
    (
        makePrismMeshParts(shakenLayers(sphere(30)), none)
    );
    const polyMeshParts again(partsOf(blocksOf(parts)));

    EXPECT_EQ(again.nCells, parts.nCells);
    EXPECT_EQ(again.points, parts.points);
    EXPECT_EQ(again.topology.faces, parts.topology.faces);
    EXPECT_EQ(again.topology.owner, parts.topology.owner);
    EXPECT_EQ(again.topology.neighbour, parts.topology.neighbour);
    EXPECT_EQ(again.topology.patchStarts, parts.topology.patchStarts);
    EXPECT_EQ(again.topology.patchSizes, parts.topology.patchSizes);
    EXPECT_EQ(again.patches.names, parts.patches.names);
}


TEST_F(meshFiles, severalColumnsOnOnePoint)
{
    prismLayerControls controls;
    controls.layers = layersOf(3, 0.1);
    controls.layers.multipleNormalsAngle = 40;
    const prismLayerMesh run
    (
        makePrismLayerMesh
        (
            quadCube(3), controls, localHeights(),
            stageObserver()
        )
    );

    ASSERT_GT(run.made.layers.extraColumnPoints.size(), 0);
    expectSameInAllFormats(run.made.layers);
}


TEST_F(meshFiles, sidesOfAWallThatEnds)
{
    expectSameInAllFormats
    (
        layeredMesh(endedOn(halfSphere(6), halfPlanes()), 3, 0.1).made.layers
    );
}


TEST_F(meshFiles, farFieldAndZones)
{
    const prismLayerMesh run(layeredMesh(sphere(5), 3, 0.1));
    farFieldControls controls;
    controls.type = farFieldType::tet;
    controls.maxCells = 1000000;
    controls.boundary.type = farBoundaryType::box;
    controls.boundary.box = boundBox(point::uniform(-4), point::uniform(4));
    farFieldMesh far(farFieldOf(run, controls));
    const label n = far.topology.neighbour.size();
    far.faceZones.append(faceZoneParts{"cut", {3, n - 1, n + 600}, {0, 1, 0}});
    far.cellZones.append(cellZoneParts("some", labelList({1, 5, 8})));
    far.cellZones.last().frontFaces = labelList({2, 4});

    expectSameInAllFormats(run.made.layers, far);
    EXPECT_EQ(expectSame(run.made.layers, far, "binary", "off"), 7);
}


// ************************************************************************* //
