/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshCertificate.H"
#include "prismPolyMesh.H"
#include "prismQuality.H"
#include "testLayers.H"
#include "testStages.H"
#include "testSurfaces.H"
#include "Random.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- Layers as a mesh
class layersMesh
{
    const pointField points_;
    const polyMeshTopology topology_;
    const label nWalls_;

    labelList patch(const label patchi) const
    {
        return identity
        (
            topology_.patchSizes[patchi], topology_.patchStarts[patchi]
        );
    }

public:

    explicit layersMesh(const prismLayers& layers)
    :
        points_(layers.meshPoints()),
        topology_(makePrismTopology(layers)),
        nWalls_(layers.patchNames.size())
    {}

    meshCertificate certificate
    (
        const bool hasOuter = true,
        const bitSet& beyondLayers = bitSet()
    ) const
    {
        DynamicList<label> walls;
        for (label patchi = 0; patchi < nWalls_; ++patchi)
        {
            walls.append(patch(patchi));
        }

        return certifyMesh
        (
            polyhedralMesh
            (
                points_, topology_.faces, topology_.owner, topology_.neighbour
            ),
            walls,
            hasOuter ? patch(nWalls_) : labelList(),
            beyondLayers
        );
    }
};


static prismLayers cubeLayers(const label n)
{
    return testSurfaces::straightLayers
    (
        testSurfaces::cube(n),
        testSurfaces::geometricHeights(3, 0.01, 1.5)
    );
}


//- With lying prisms and wedges on its edges
static prismLayers multipleNormals(const wallSurface& wall)
{
    prismLayerControls controls;
    controls.layers = testSurfaces::layersOf(4, 0.1);
    controls.layers.multipleNormalsAngle = 60;

    return makePrismLayerMesh
    (
        wall,
        controls,
        localHeights(),
        stageObserver()
    ).made.layers;
}


//- The points of the layers are moved by up to a distance, those on the wall
//  are not
static prismLayers shaken(prismLayers layers, const scalar distance, Random& r)
{
    for (label c = 0; c < layers.nColumns(); ++c)
    {
        for (label i = 1; i <= layers.nLayers; ++i)
        {
            layers.points[layers.index(c, i)] +=
                distance*(2*r.sample01<vector>() - vector::one);
        }
    }

    return layers;
}


static void expectSameVerdict(const prismLayers& layers)
{
    const meshCertificate certificate(layersMesh(layers).certificate());
    labelList expected;

    forAll(layers.faces, facei)
    {
        for (label i = 1; i <= layers.nLayers; ++i)
        {
            if (!isPositive(layers, facei, i))
            {
                expected.append(facei*layers.nLayers + i - 1);
            }
        }
    }

    EXPECT_EQ(certificate.invalidCells, expected);
    EXPECT_EQ(sum(certificate.nInvalid), expected.size());
    EXPECT_EQ
    (
        certificate.intersections.size(), findIntersections(layers).size()
    );
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(certifyMesh, cube)
{
    const meshCertificate certificate(layersMesh(cubeLayers(3)).certificate());

    EXPECT_EQ(certificate.nCells[label(meshCellShape::prism)], 12*9*3);
    EXPECT_EQ(sum(certificate.nCells), 12*9*3);
    EXPECT_TRUE(certificate.invalidCells.empty());
    EXPECT_TRUE(certificate.intersections.empty());
    EXPECT_EQ(certificate.nLayers, labelList(12*9, 3));
}


TEST(certifyMesh, multipleNormals)
{
    for (const wallSurface& wall :
        {testSurfaces::quadCube(3), testSurfaces::lBlock(3)})
    {
        const prismLayers layers(multipleNormals(wall));
        const meshCertificate certificate(layersMesh(layers).certificate());

        EXPECT_GT(certificate.nCells[label(meshCellShape::lyingPrism)], 0);
        EXPECT_GT
        (
            certificate.nCells[label(meshCellShape::wedge)]
          + certificate.nCells[label(meshCellShape::tetrahedron)],
            0
        );
        EXPECT_EQ(certificate.nCells[label(meshCellShape::other)], 0);
        EXPECT_TRUE(certificate.invalidCells.empty());
        EXPECT_TRUE(certificate.intersections.empty());
        EXPECT_EQ(certificate.nLayers, labelList(wall.faces.size(), 4));
    }
}


TEST(certifyMesh, sameVerdictAsOnTheLayers)
{
    Random random(1);

    for
    (
        const prismLayers& layers
      : {
            cubeLayers(3),
            multipleNormals(testSurfaces::quadCube(3)),
            multipleNormals(testSurfaces::lBlock(3))
        }
    )
    {
        for (const scalar distance : {0.0, 1e-3, 5e-3, 0.02, 0.1})
        {
            expectSameVerdict(shaken(layers, distance, random));
        }
    }
}


TEST(certifyMesh, cellsThatAreNotPositiveAreNoLayers)
{
    prismLayers layers(cubeLayers(3));
    const label column = layers.faces[5][0];
    layers.points[layers.index(column, 2)] = layers(column, 1);

    const meshCertificate certificate(layersMesh(layers).certificate());

    forAll(certificate.nLayers, i)
    {
        EXPECT_EQ
        (
            certificate.nLayers[i], layers.faces[i].found(column) ? 1 : 3
        );
    }
}


TEST(certifyMesh, intersections)
{
    prismLayers layers(cubeLayers(3));
    const label column = layers.faces[5][0];
    layers.points[layers.index(column, 3)] = point(0.5, 0.5, 0.5);

    EXPECT_FALSE(layersMesh(layers).certificate().intersections.empty());
    EXPECT_TRUE(layersMesh(layers).certificate(false).intersections.empty());
}


TEST(certifyMesh, wallsThatIntersect)
{
    // Of two cubes, one through the other
    const wallSurface cube(testSurfaces::cube(2));
    const prismLayers layers
    (
        testSurfaces::straightLayers
        (
            testSurfaces::merge
            (
                cube, testSurfaces::translated(cube, vector(0.3, 0.4, 0.7))
            ),
            scalarList({0, 0.01})
        )
    );
    const meshCertificate certificate(layersMesh(layers).certificate());

    EXPECT_TRUE(certificate.invalidCells.empty());
    EXPECT_GT
    (
        certificate.intersections.size(), findIntersections(layers).size()
    );
}


TEST(meshCertificate, aLastFaceThatIsCutCountsAsOne)
{
    // A cube whose side z = 1 is two triangles, on the wall z = 0
    const pointField points
    ({
        {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
        {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}
    });
    const faceList faces
    ({
        face({0, 3, 2, 1}), face({0, 1, 5, 4}), face({1, 2, 6, 5}),
        face({2, 3, 7, 6}), face({3, 0, 4, 7}),
        face({4, 5, 6}), face({4, 6, 7})
    });
    const labelList owner(faces.size(), Zero), neighbour;
    const polyhedralMesh mesh(points, faces, owner, neighbour);
    const labelList wall(1, Zero);

    EXPECT_EQ(mesh.opposite(0, 0), -1);
    EXPECT_TRUE(mesh.hasCutTop(0, 0));
    EXPECT_EQ
    (
        certifyMesh(mesh, wall, labelList()).nLayers, labelList(1, label(1))
    );

    // From a triangle there are several faces that are not one
    EXPECT_FALSE(mesh.hasCutTop(5, 0));
}


TEST(meshCertificate, aStackEndsBelowCellsBeyondTheLayers)
{
    const prismLayers layers(cubeLayers(2));
    bitSet beyond(layers.faces.size()*layers.nLayers);
    forAll(layers.faces, facei)
    {
        beyond.set(facei*layers.nLayers + 2);
    }

    const labelList nLayers
    (
        layersMesh(layers).certificate(false, beyond).nLayers
    );
    EXPECT_EQ(nLayers, labelList(layers.faces.size(), 2));
}


//- A hexahedron. The corner that was at (1 1 1) is behind its neighbours.
static const pointField snapped
({
    {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
    {0, 0, 1}, {1, 0, 1}, {0.6, 0.6, 0.6}, {0, 1, 1}
});
static const faceList snappedFaces
({
    face({0, 3, 2, 1}), face({4, 5, 6, 7}), face({0, 1, 5, 4}),
    face({1, 2, 6, 5}), face({2, 3, 7, 6}), face({3, 0, 4, 7})
});


TEST(certifyMesh, snappedHexahedraArePolyhedraOutsideOfLayers)
{
    const labelList owner(6, Zero), neighbour;
    const polyhedralMesh mesh(snapped, snappedFaces, owner, neighbour);

    const bitSet beyondLayers(1, true);
    const meshCertificate outside(certifyMesh(mesh, {}, {}, beyondLayers));
    EXPECT_EQ(outside.nCells[label(meshCellShape::polyhedron)], 1);
    EXPECT_TRUE(outside.invalidCells.empty());

    // In the layers
    const meshCertificate inside(certifyMesh(mesh, {}, {}));
    EXPECT_EQ(inside.nInvalid[label(meshCellShape::hexahedron)], 1);

    // On the wall it is no layer, wherever it is
    for (const bitSet& beyond : {bitSet(), beyondLayers})
    {
        EXPECT_EQ(certifyMesh(mesh, labelList({0}), {}, beyond).nLayers[0], 0);
    }
}


TEST(certifyMesh, snappedHexahedraAreInNoStackThatEndsBelow)
{
    // The snapped hexahedron is on a cube, which is the layer
    const pointField points
    ({
        {0, 0, -1}, {1, 0, -1}, {1, 1, -1}, {0, 1, -1},
        {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
        {0, 0, 1}, {1, 0, 1}, {0.6, 0.6, 0.6}, {0, 1, 1}
    });
    const faceList faces
    ({
        face({4, 5, 6, 7}),
        face({0, 3, 2, 1}), face({0, 1, 5, 4}), face({1, 2, 6, 5}),
        face({2, 3, 7, 6}), face({3, 0, 4, 7}),
        face({8, 9, 10, 11}), face({4, 5, 9, 8}), face({5, 6, 10, 9}),
        face({6, 7, 11, 10}), face({7, 4, 8, 11})
    });
    const labelList owner({0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1});
    const labelList neighbour(1, 1);
    const polyhedralMesh mesh(points, faces, owner, neighbour);
    bitSet beyond(2);
    beyond.set(1);
    const meshCertificate certificate
    (
        certifyMesh(mesh, labelList({1}), {}, beyond)
    );

    EXPECT_EQ(certificate.nLayers[0], 1);
    EXPECT_TRUE(certificate.invalidCells.empty());
    EXPECT_EQ(certificate.nCells[label(meshCellShape::polyhedron)], 1);
}


TEST(certifyMesh, aPolyhedronHasMoreVolumeThanRounding)
{
    // The snapped hexahedron, nearly flat and far from the origin
    pointField points(snapped);
    for (point& x : points)
    {
        x = point(x.x() + 1e6, x.y() + 1e6, 1e-12*x.z());
    }
    const labelList owner(6, Zero), neighbour;
    const polyhedralMesh mesh(points, snappedFaces, owner, neighbour);

    EXPECT_EQ
    (
        certifyMesh(mesh, {}, {}, bitSet(1, true)).invalidCells.size(), 1
    );
}


TEST(meshCertificate, cellsFillTheBoundary)
{
    // Straight layers on a cube of width 1: slabs on the sides, and what is
    // between their sides
    const meshCertificate certificate(layersMesh(cubeLayers(4)).certificate());

    EXPECT_TRUE(certificate.fillsBoundary());
    EXPECT_GT(certificate.cellVolume, 6*0.0475);
    EXPECT_LT(certificate.cellVolume, pow3(1.095) - 1);
    EXPECT_TRUE(certificate.doubleFaces.empty());
}


TEST(certifyMesh, cellsThatRoundingAloneKeepsFromBeingFlat)
{
    // A tetrahedron with an exactly positive volume
    const faceList faces
    ({face({0, 2, 1}), face({0, 1, 3}), face({1, 2, 3}), face({0, 3, 2})});
    const labelList owner(4, 0);
    const labelList none;
    for (const scalar height : {1e-9, 1e-17})
    {
        const pointField points
        ({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, height}});
        const meshCertificate certificate
        (
            certifyMesh(polyhedralMesh(points, faces, owner, none), none, none)
        );
        EXPECT_EQ(sum(certificate.nInvalid), height > SMALL ? 0 : 1);
    }
}


TEST(meshCertificate, doubleFacesAreFound)
{
    const faceList faces
    ({
        face({3, 1, 2}), face({1, 2, 4}), face({4, 2, 1}), face({1, 2, 3, 4}),
        face({2, 3, 1})
    });

    EXPECT_EQ
    (
        findDoubleFaces(faces),
        List<labelPair>({labelPair(0, 4), labelPair(1, 2)})
    );
}


// ************************************************************************* //
