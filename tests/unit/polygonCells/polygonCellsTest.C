/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polygonCells.H"

#include "polygonGeometry.H"
#include "memoryMesh.H"
#include "meshCertificate.H"
#include "openSurfaces.H"
#include "soundMesh.H"
#include "testFarField.H"
#include "testLayers.H"
#include "testStages.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A far field in a box
static farFieldControls inBox(const farFieldType type, const scalar size)
{
    farFieldControls controls;
    controls.type = type;
    controls.forPolygons = true;
    controls.boundary.type = farBoundaryType::box;
    controls.boundary.box =
        boundBox(point::uniform(-size), point::uniform(size));

    return controls;
}


//- Polygons around a body
static polygonMesh polygonsAround
(
    const wallSurface& wall,
    const farFieldType type,
    const scalar thickness = 0.1,
    const polygonControls& controls = polygonControls()
)
{
    const prismLayerMesh run(layeredMesh(wall, 4, thickness));
    farFieldMesh far(farFieldOf(run, inBox(type, 4)));

    return makePolygonCells(run.made.layers, far, List<sidePatch>(), controls);
}


static scalar areaOf(const polyMesh& mesh, const word& patch)
{
    return gSum(mesh.boundaryMesh()[patch].magFaceAreas());
}


//- What checkPrismLayers -layers 4 wants
static void expectCertified(const polyMesh& mesh)
{
    bitSet beyond;
    labelList outer;
    if (mesh.cellZones().size())
    {
        beyond = bitSet(mesh.nCells(), true);
        beyond.unset(mesh.cellZones()["boundaryLayer"]);
    }
    else
    {
        const polyPatch& patch = mesh.boundaryMesh()["layerOuter"];
        outer = identity(patch.size(), patch.start());
    }
    const polyPatch& wall = mesh.boundaryMesh()[0];
    const meshCertificate certificate
    (
        certifyMesh
        (
            polyhedralMesh
            (
                mesh.points(), mesh.faces(), mesh.faceOwner(),
                mesh.faceNeighbour()
            ),
            identity(wall.size(), wall.start()), outer, beyond
        )
    );
    EXPECT_EQ(certificate.nLayers, labelList(wall.size(), 4));
    EXPECT_TRUE(certificate.invalidCells.empty());
    EXPECT_TRUE(certificate.intersections.empty());
    EXPECT_TRUE(certificate.doubleFaces.empty());
    EXPECT_TRUE(certificate.fillsBoundary());
}


//- What every mesh of polygons is: sound, and full of the same volume
static void expectSoundPolygons(polygonMesh&& polygons, const scalar volume)
{
    const label nColumns = polygons.counts.nColumns;
    const label nLayerCells = polygons.counts.nLayerCells;
    const polygonGeometry geometry(polygons.mesh);
    EXPECT_TRUE(geometry.invalidCells(polygons.mesh).empty());
    EXPECT_NEAR(sum(geometry.cellVolumes), volume, 1e-3*volume);
    EXPECT_EQ(nLayerCells, 4*nColumns);

    const memoryMesh mesh(std::move(polygons.mesh));
    expectSound(mesh());
    EXPECT_EQ(mesh().cellZones()["boundaryLayer"].size(), nLayerCells);
    expectCertified(mesh());
}

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(polygonCells, aSmoothWallHasAColumnForEachPoint)
{
    const wallSurface wall(sphere(8));
    const polygonMesh polygons(polygonsAround(wall, farFieldType::tet));

    EXPECT_EQ(polygons.counts.nColumns, wall.points.size());
    EXPECT_EQ(polygons.counts.nPartsOfColumns, 0);
}


TEST(polygonCells, aSphereIsSound)
{
    expectSoundPolygons
    (
        polygonsAround(sphere(8), farFieldType::tet),
        512 - Foam::enclosedVolume(sphere(8))
    );
}


TEST(polygonCells, hexahedraStay)
{
    const polygonMesh polygons
    (
        polygonsAround(sphere(8), farFieldType::hexCore)
    );
    const labelList& kept = polygons.mesh.cellZones.last().cells;

    EXPECT_EQ(polygons.mesh.cellZones.last().name, "hexCore");
    EXPECT_EQ(kept.size(), polygons.counts.nOthers);
    EXPECT_GT(kept.size(), 100);
}


TEST(polygonCells, aCoreIsSound)
{
    expectSoundPolygons
    (
        polygonsAround(sphere(8), farFieldType::hexCore),
        512 - Foam::enclosedVolume(sphere(8))
    );
}


TEST(polygonCells, sharpEdgesStayExactly)
{
    // Each side of an edge has a column, and each side of a corner
    const wallSurface wall(cube(4));
    polygonMesh polygons(polygonsAround(wall, farFieldType::tet));
    EXPECT_EQ(polygons.counts.nColumns - wall.points.size(), 12*3 + 8*2);

    const memoryMesh mesh(std::move(polygons.mesh));
    EXPECT_NEAR(areaOf(mesh(), wall.patchNames[0]), 6, 1e-12);
}


TEST(polygonCells, aCubeIsSound)
{
    expectSoundPolygons(polygonsAround(cube(4), farFieldType::tet), 511);
}


TEST(polygonCells, layersAreWholeWherePolyhedraAreDivided)
{
    polygonMesh polygons
    (
        polygonsAround(wedgeBlock(6, 40), farFieldType::tet, 0.25)
    );
    EXPECT_GT(polygons.counts.nPartsOfPolyhedra, 0);
    EXPECT_GT(polygons.counts.nPartsOfColumns, 0);

    const memoryMesh mesh(std::move(polygons.mesh));
    expectCertified(mesh());
}


//- Number of the cells with skew faces around an acute edge
static label nSkew(const label nRounds)
{
    polygonControls controls;
    controls.maxSkewness = 1.5;
    controls.nPoorRounds = nRounds;
    const polygonMesh polygons
    (
        polygonsAround(wedgeBlock(6, 40), farFieldType::tet, 0.25, controls)
    );

    return
        polygonGeometry(polygons.mesh)
       .skewCells(polygons.mesh, controls.maxSkewness).size();
}


TEST(polygonCells, skewColumnsAreDivided)
{
    EXPECT_LT(nSkew(5), nSkew(0)/2);
}


TEST(polygonCells, hexahedraAroundASharpCornerGetPolygons)
{
    polygonMesh polygons
    (
        polygonsAround(wedgeBlock(4, 25), farFieldType::hexCore, 0.3)
    );
    const memoryMesh mesh(std::move(polygons.mesh));
    expectCertified(mesh());
}


TEST(polygonCells, quadrilateralsOfTheWallAreSound)
{
    expectSoundPolygons
    (
        polygonsAround(quadCube(4), farFieldType::tet), 511
    );
}


TEST(polygonCells, fansOfColumnsAreSound)
{
    prismLayerControls controls;
    controls.layers = layersOf(4, 0.1);
    controls.layers.multipleNormalsAngle = 75;
    const prismLayerMesh run(layeredMesh(cube(4), controls));
    ASSERT_GT(run.made.layers.extraColumnPoints.size(), 0);
    farFieldMesh far(farFieldOf(run, inBox(farFieldType::tet, 4)));

    expectSoundPolygons(makePolygonCells(run.made.layers, far), 511);
}


TEST(polygonCells, layersOnTheSidesOfADuctAreSound)
{
    const wallSurface wall
    (
        endedOn(duct(6), wordList({"inlet", "outlet"}))
    );
    const prismLayerMesh run(layeredMesh(wall, 4, 0.1));
    farFieldControls controls;
    controls.type = farFieldType::tet;
    controls.forPolygons = true;
    farFieldMesh far(farFieldOf(run, controls));
    polygonMesh polygons(makePolygonCells(run.made.layers, far));
    const polygonGeometry geometry(polygons.mesh);
    EXPECT_TRUE(geometry.invalidCells(polygons.mesh).empty());

    // Sides are plane, as they were
    const memoryMesh mesh(std::move(polygons.mesh));
    expectSound(mesh());
    const memoryMesh triangles(run.made.layers, farFieldOf(run, controls));
    for (const polyPatch& patch : triangles().boundaryMesh())
    {
        const scalar area = areaOf(triangles(), patch.name());
        EXPECT_NEAR(areaOf(mesh(), patch.name()), area, 1e-12*area);
    }
}


TEST(polygonCells, layersAloneHaveAnOuterPatch)
{
    const prismLayerMesh run(layeredMesh(sphere(6), 4, 0.1));
    farFieldMesh none;
    polygonMesh polygons(makePolygonCells(run.made.layers, none));
    const label nColumns = polygons.counts.nColumns;
    const memoryMesh mesh(std::move(polygons.mesh));

    EXPECT_FALSE(mesh().checkFacePyramids(false));
    EXPECT_EQ(mesh().boundaryMesh()["layerOuter"].size(), nColumns);
}


TEST(polygonCells, layersAloneDoNotIntersect)
{
    // Polygons at a sharp edge have three points in a line. In a sharp corner
    // polygons of the outer surface are beyond the triangles of the prisms.
    for (const wallSurface& wall : {lBlock(4), wedgeBlock(6, 40)})
    {
        const prismLayerMesh run(layeredMesh(wall, 4, 0.1));
        farFieldMesh none;
        const memoryMesh mesh
        (
            std::move(makePolygonCells(run.made.layers, none).mesh)
        );
        expectCertified(mesh());
    }
}


TEST(polygonCells, levelsStay)
{
    // On a plane wall with straight columns all faces of a level are on it
    const prismLayers layers
    (
        straightLayers(sheet(6, 0), geometricHeights(4, 0.1, 1.2))
    );
    farFieldMesh none;
    const polygonMesh polygons(makePolygonCells(layers, none));
    const scalar h = layers(0, 1).z() - layers(0, 0).z();
    label nOnFirst = 0;
    for (const point& p : polygons.mesh.points)
    {
        nOnFirst += mag(p.z() - layers(0, 1).z()) < 1e-15;
        EXPECT_FALSE(p.z() > layers(0, 0).z() + 1e-15 && p.z() < h - 1e-15);
    }
    EXPECT_GE(nOnFirst, layers.faces.size());
}


TEST(polygonCells, areTheSameWhenPartsAreMade)
{
    const wallSurface wall(wedgeBlock(2, 20));
    const farFieldType type = farFieldType::hexCore;
    polygonControls inFull;
    inFull.makesParts = false;
    const polyMeshParts full(polygonsAround(wall, type, 0.3, inFull).mesh);
    const polygonMesh made(polygonsAround(wall, type, 0.3));
    EXPECT_GT(made.counts.nPartsOfPolyhedra, 0);
    EXPECT_EQ(made.mesh.nCells, full.nCells);
    EXPECT_EQ(made.mesh.points.size(), full.points.size());
    EXPECT_EQ(made.mesh.topology.faces, full.topology.faces);
    EXPECT_EQ(made.mesh.topology.owner, full.topology.owner);
}


// ************************************************************************* //
