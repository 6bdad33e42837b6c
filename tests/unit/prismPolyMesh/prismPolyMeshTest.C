/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/


#include "memoryMesh.H"
#include "testLayers.H"
#include "testSurfaces.H"
#include "HashSet.H"
#include "mathematicalConstants.H"
#include "wallPolyPatch.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static const scalarList heights({0, 0.01, 0.03, 0.07});


static prismLayers layersOn(const wallSurface& wall)
{
    return testSurfaces::straightLayers(wall, heights);
}


static List<prismLayers> testMeshes()
{
    return
    {
        testSurfaces::onePolygon(3, heights),
        testSurfaces::onePolygon(4, scalarList({0, 1})),
        testSurfaces::onePolygon(5, heights),
        layersOn(testSurfaces::cube(3)),
        layersOn(testSurfaces::quadCube(3)),
        layersOn(testSurfaces::sphere(4)),
        layersOn(testSurfaces::torus(24, 12, 1, 0.3)),
        layersOn(testSurfaces::lBlock(3))
    };
}


static label nOuterPoints(const polyPatch& patch, const prismLayers& layers)
{
    label n = 0;
    for (const label p : patch.meshPoints())
    {
        n += p%(layers.nLayers + 1) == layers.nLayers;
    }
    return n;
}


//- A cube whose face i is of patch i/4 of three
static prismLayers threePatches(const wordList& names)
{
    prismLayers layers(layersOn(testSurfaces::cube(1)));
    layers.patchNames = names;

    forAll(layers.patchIDs, facei)
    {
        layers.patchIDs[facei] = (facei + 1)%3;
    }

    return layers;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(prismPolyMesh, ownerBeforeNeighbour)
{
    for (const prismLayers& layers : testMeshes())
    {
        const polyMeshTopology mesh(makePrismTopology(layers));

        forAll(mesh.neighbour, facei)
        {
            EXPECT_LT(mesh.owner[facei], mesh.neighbour[facei]);
        }
    }
}


TEST(prismPolyMesh, upperTriangularOrder)
{
    for (const prismLayers& layers : testMeshes())
    {
        const memoryMesh mesh(layers);

        EXPECT_FALSE(mesh().checkUpperTriangular());
    }
}


TEST(prismPolyMesh, topologyIsClean)
{
    for (const prismLayers& layers : testMeshes())
    {
        const memoryMesh mesh(layers);

        EXPECT_FALSE(mesh().checkTopology());
        EXPECT_FALSE(mesh().boundaryMesh().checkDefinition());
    }
}


TEST(prismPolyMesh, facesPointOutOfTheirOwners)
{
    for (const prismLayers& layers : testMeshes())
    {
        const memoryMesh mesh(layers);

        EXPECT_FALSE(mesh().checkFaceOrthogonality());
        EXPECT_FALSE(mesh().checkFacePyramids());
        EXPECT_FALSE(mesh().checkClosedCells());
        EXPECT_FALSE(mesh().checkClosedBoundary());
        EXPECT_FALSE(mesh().checkCellVolumes());
    }
}


TEST(prismPolyMesh, volumeOfOneCell)
{
    for (label n = 3; n < 7; ++n)
    {
        const memoryMesh mesh(testSurfaces::onePolygon(n, scalarList({0, 2})));

        ASSERT_EQ(mesh().nCells(), 1);
        EXPECT_NEAR
        (
            mesh().cellVolumes()[0],
            n*std::sin(constant::mathematical::twoPi/n),
            1e-14
        );
    }
}


TEST(prismPolyMesh, volumeAroundACube)
{
    for (const wallSurface& wall :
        {testSurfaces::cube(4), testSurfaces::quadCube(4)})
    {
        const memoryMesh mesh(layersOn(wall));

        EXPECT_GT(min(mesh().cellVolumes()), 0);
        EXPECT_NEAR
        (
            sum(mesh().cellVolumes()),
            pow3(1 + 2*heights.last()) - 1,
            1e-13
        );
    }
}


TEST(prismPolyMesh, cellsAreNumberedByStack)
{
    const prismLayers layers(layersOn(testSurfaces::cube(2)));
    const memoryMesh mesh(layers);

    forAll(layers.faces, facei)
    {
        for (label i = 1; i <= layers.nLayers; ++i)
        {
            labelList expected;
            for (const label c : layers.faces[facei])
            {
                expected.append(layers.pointLabel(c, i - 1));
                expected.append(layers.pointLabel(c, i));
            }
            sort(expected);

            const cell& c = mesh().cells()[facei*layers.nLayers + i - 1];
            labelList points(c.labels(mesh().faces()));
            sort(points);

            EXPECT_EQ(points, expected);
        }
    }
}


TEST(prismPolyMesh, patchesOfAClosedWall)
{
    const prismLayers layers(threePatches({"nose", "wing", "tail"}));
    const memoryMesh mesh(layers);
    const polyBoundaryMesh& patches = mesh().boundaryMesh();

    ASSERT_EQ
    (
        patches.names(),
        wordList({"nose", "wing", "tail", "layerOuter"})
    );

    label start = mesh().nInternalFaces();
    for (label patchi = 0; patchi < 3; ++patchi)
    {
        EXPECT_EQ(patches[patchi].type(), wallPolyPatch::typeName);
        EXPECT_EQ(patches[patchi].size(), 4);
        EXPECT_EQ(patches[patchi].start(), start);
        EXPECT_EQ(nOuterPoints(patches[patchi], layers), 0);
        start += 4;
    }

    EXPECT_EQ(patches[3].type(), polyPatch::typeName);
    EXPECT_EQ(patches[3].size(), 12);
    EXPECT_EQ(nOuterPoints(patches[3], layers), 8);
}


TEST(prismPolyMesh, wallFacesAreOnTheirPatch)
{
    const prismLayers layers(threePatches({"nose", "wing", "tail"}));
    const memoryMesh mesh(layers);

    for (const polyPatch& patch : mesh().boundaryMesh())
    {
        if (patch.name() != layerOuterName)
        {
            for (const label celli : patch.faceCells())
            {
                EXPECT_EQ(celli%layers.nLayers, 0);
                EXPECT_EQ(layers.patchIDs[celli/layers.nLayers], patch.index());
            }
        }
    }
}


TEST(prismPolyMesh, sidesWhereTheFrontEnds)
{
    const memoryMesh mesh(testSurfaces::onePolygon(3, heights));
    const polyBoundaryMesh& patches = mesh().boundaryMesh();

    ASSERT_EQ
    (
        patches.names(),
        wordList({"wall", layerOuterName, layerSidesName})
    );
    EXPECT_EQ(patches[0].size(), 1);
    EXPECT_EQ(patches[1].size(), 1);
    EXPECT_EQ(patches[2].size(), 9);
}


TEST(prismPolyMesh, sidesAreOnOpenEdgesOnly)
{
    prismLayers layers(layersOn(testSurfaces::cube(1)));
    layers.faces.setSize(layers.faces.size() - 1);
    layers.patchIDs.setSize(layers.faces.size());

    const memoryMesh mesh(layers);
    const polyPatch& sides = mesh().boundaryMesh()[2];

    EXPECT_EQ(sides.name(), layerSidesName);
    EXPECT_EQ(sides.type(), "patch");
    EXPECT_EQ(sides.size(), 3*layers.nLayers);
    EXPECT_EQ(sides.start() + sides.size(), mesh().nFaces());
    EXPECT_FALSE(mesh().checkTopology());
    EXPECT_FALSE(mesh().checkUpperTriangular());
    EXPECT_FALSE(mesh().checkClosedCells());

    // Between the columns of one edge of the front each
    for (const face& f : sides)
    {
        labelHashSet columns;
        for (const label p : f)
        {
            columns.insert(p/(layers.nLayers + 1));
        }

        EXPECT_EQ(f.size(), 4);
        EXPECT_EQ(columns.size(), 2);
    }
}


TEST(prismPolyMesh, emptyPatchesAreKept)
{
    prismLayers layers(layersOn(testSurfaces::cube(1)));
    layers.patchNames = wordList({"all", "none"});
    layers.patchIDs = 0;

    const memoryMesh mesh(layers);

    EXPECT_EQ(mesh().boundaryMesh().size(), 3);
    EXPECT_EQ(mesh().boundaryMesh()[1].size(), 0);
}


TEST(prismPolyMesh, pointsAreThoseOfTheLayers)
{
    const prismLayers layers(layersOn(testSurfaces::cube(1)));
    const memoryMesh mesh(layers);

    EXPECT_EQ(mesh().points(), layers.points);
}


TEST(prismPatchNames, namesOfTheOtherPatchesAreTaken)
{
    EXPECT_EQ
    (
        prismPatchNames({"body", layerOuterName, layerSidesName}),
        wordList({"body", "layerOuter2", "layerSides2"})
    );
}


TEST(prismPatchNames, unique)
{
    EXPECT_EQ
    (
        prismPatchNames({"a", "a", "a2", "b"}),
        wordList({"a", "a2", "a22", "b"})
    );
}


TEST(makePrismTopology, refusesEdgesOfThreeFaces)
{
    prismLayers layers(layersOn(testSurfaces::cube(1)));
    layers.faces.append(face(layers.faces[0]));
    layers.patchIDs.append(0);

    EXPECT_THROW(makePrismTopology(layers), Foam::error);
}


TEST(makePrismTopology, refusesFlippedFaces)
{
    prismLayers layers(layersOn(testSurfaces::cube(1)));
    layers.faces[3].flip();

    EXPECT_THROW(makePrismTopology(layers), Foam::error);
}


// ************************************************************************* //
