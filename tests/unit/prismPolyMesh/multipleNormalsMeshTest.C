/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "memoryMesh.H"
#include "saddles.H"
#include "testLayers.H"
#include "testStages.H"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- Layers with extra columns and their mesh
struct dividedMesh
{
    std::string name;
    wallSurface wall;
    prismLayers layers;
    std::unique_ptr<memoryMesh> mesh;


    dividedMesh
    (
        const std::string& name,
        const wallSurface& wall,
        const scalar smallestAngle
    )
    :
        name(name),
        wall(wall)
    {
        prismLayerControls controls;
        controls.layers = testSurfaces::layersOf(3, 0.1);
        controls.layers.multipleNormalsAngle = smallestAngle;

        layers = makePrismLayerMesh
        (
            wall,
            controls,
            localHeights(),
            stageObserver()
        ).made.layers;
        mesh.reset(new memoryMesh(layers));
    }


    const polyMesh& operator()() const
    {
        return (*mesh)();
    }
};


//- Made once: all tests look at the same
static const std::vector<dividedMesh>& dividedMeshes()
{
    static std::vector<dividedMesh> list;

    if (list.empty())
    {
        const wallSurface screw(testSurfaces::screw(point(3, 4, 5)));

        list.emplace_back("screw", screw, 5);
        list.emplace_back("triangles", testSurfaces::triangulated(screw), 5);
        list.emplace_back("blade", testSurfaces::bladeOnEdge(0.5), 5);
        list.emplace_back("cube", testSurfaces::cube(3), 40);
        list.emplace_back("corners", testSurfaces::quadCube(3), 40);
        list.emplace_back("edges", testSurfaces::quadCube(3), 45.1);
    }

    return list;
}


//- Layers on the front without moving its columns
static List<prismLayers> frontLayers()
{
    DynamicList<prismLayers> all;
    const scalarList heights({0, 0.01, 0.03});

    for (const testSurfaces::saddle& s : testSurfaces::screws())
    {
        all.append
        (
            testSurfaces::frontLayers(testSurfaces::frontOf(s.wall, 0), heights)
        );
    }

    return List<prismLayers>(std::move(all));
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(multipleNormalsMesh, hasFurtherColumns)
{
    for (const dividedMesh& m : dividedMeshes())
    {
        EXPECT_FALSE(m.layers.extraColumnPoints.empty()) << m.name;
    }
}


TEST(multipleNormalsMesh, ownersAreBeforeNeighbours)
{
    for (const dividedMesh& m : dividedMeshes())
    {
        for (label facei = 0; facei < m().nInternalFaces(); ++facei)
        {
            EXPECT_LT(m().faceOwner()[facei], m().faceNeighbour()[facei])
                << m.name;
        }
    }
}


TEST(multipleNormalsMesh, isInUpperTriangularOrder)
{
    for (const dividedMesh& m : dividedMeshes())
    {
        EXPECT_FALSE(m().checkUpperTriangular()) << m.name;
    }
}


TEST(multipleNormalsMesh, hasValidFaces)
{
    for (const dividedMesh& m : dividedMeshes())
    {
        EXPECT_FALSE(m().checkFaceVertices()) << m.name;
    }
}


TEST(multipleNormalsMesh, hasClosedCells)
{
    for (const dividedMesh& m : dividedMeshes())
    {
        EXPECT_FALSE(m().checkCellsZipUp()) << m.name;
        EXPECT_FALSE(m().checkClosedCells()) << m.name;
    }
}


TEST(multipleNormalsMesh, hasNoFacesThatShareTooManyPoints)
{
    for (const dividedMesh& m : dividedMeshes())
    {
        EXPECT_FALSE(m().checkFaceFaces()) << m.name;
    }
}


TEST(multipleNormalsMesh, usesAllItsPoints)
{
    for (const dividedMesh& m : dividedMeshes())
    {
        EXPECT_FALSE(m().checkPoints()) << m.name;
    }
}


TEST(multipleNormalsMesh, hasACleanTopology)
{
    for (const dividedMesh& m : dividedMeshes())
    {
        EXPECT_FALSE(m().checkTopology()) << m.name;
        EXPECT_FALSE(m().boundaryMesh().checkDefinition()) << m.name;
    }
}


TEST(multipleNormalsMesh, topologyIsCleanOnAllScrews)
{
    for (const prismLayers& layers : frontLayers())
    {
        const memoryMesh mesh(layers);

        EXPECT_FALSE(mesh().checkTopology());
        EXPECT_FALSE(mesh().checkClosedCells());
    }
}


TEST(multipleNormalsMesh, areaVectorsOfEachCellSumToZero)
{
    for (const dividedMesh& m : dividedMeshes())
    {
        const vectorField& areas = m().faceAreas();
        vectorField sums(m().nCells(), Zero);

        forAll(areas, facei)
        {
            sums[m().faceOwner()[facei]] += areas[facei];

            if (m().isInternalFace(facei))
            {
                sums[m().faceNeighbour()[facei]] -= areas[facei];
            }
        }

        EXPECT_LT(max(mag(sums)), 1e-15) << m.name;
    }
}


TEST(multipleNormalsMesh, volumesArePositive)
{
    for (const dividedMesh& m : dividedMeshes())
    {
        EXPECT_GT(min(m().cellVolumes()), 0) << m.name;
    }
}


TEST(multipleNormalsMesh, facesPointOutOfTheirOwners)
{
    for (const dividedMesh& m : dividedMeshes())
    {
        EXPECT_FALSE(m().checkFacePyramids()) << m.name;
    }
}


TEST(multipleNormalsMesh, volumesSumToThatBetweenWallAndOuterSurface)
{
    // But for quadrilaterals that are not plane
    for (const dividedMesh& m : dividedMeshes())
    {
        wallSurface outer(m.wall);
        outer.faces = m.layers.faces;
        outer.points.setSize(m.layers.nColumns());
        forAll(outer.points, c)
        {
            outer.points[c] = m.layers(c, m.layers.nLayers);
        }

        EXPECT_NEAR
        (
            sum(m().cellVolumes()),
            testSurfaces::enclosedVolume(outer)
          - testSurfaces::enclosedVolume(m.wall),
            0.02*sum(m().cellVolumes())
        )   << m.name;
    }
}


TEST(multipleNormalsMesh, hasLayersOnEachFrontFace)
{
    for (const dividedMesh& m : dividedMeshes())
    {
        EXPECT_EQ(m().nCells(), 3*m.layers.faces.size()) << m.name;
    }
}


TEST(multipleNormalsMesh, patchesAreTheWallAndTheOuterSurface)
{
    for (const dividedMesh& m : dividedMeshes())
    {
        const polyBoundaryMesh& patches = m().boundaryMesh();

        ASSERT_EQ(patches.size(), 2) << m.name;
        EXPECT_EQ(patches[0].size(), m.wall.faces.size()) << m.name;
        EXPECT_EQ(patches[1].size(), m.layers.faces.size()) << m.name;
    }
}


TEST(multipleNormalsMesh, wallPatchIsTheWall)
{
    for (const dividedMesh& m : dividedMeshes())
    {
        const polyPatch& patch = m().boundaryMesh()[0];

        forAll(patch, i)
        {
            // Seen from the cells, beginning with the same point
            const face f(face(m.wall.faces[i]).reverseFace());

            EXPECT_EQ
            (
                patch[i].points(m().points()), f.points(m.wall.points)
            )   << m.name;
        }
    }
}


// ************************************************************************* //
