/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerGeometry.H"
#include "memoryMesh.H"
#include "openSurfaces.H"
#include "testLayers.H"
#include "testSurfaces.H"
#include "polyMeshTetDecomposition.H"
#include "polyMeshTools.H"
#include "Random.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static const label n = 3;

//- Layers whose points are off by up to half of a length
static prismLayers shaken(const wallSurface& wall, const scalar by = 0.04)
{
    prismLayers layers
    (
        testSurfaces::straightLayers
        (
            wall, testSurfaces::geometricHeights(n, 0.05, 1.2)
        )
    );

    Random random(5);
    for (point& p : layers.points)
    {
        p += by*(random.sample01<vector>() - vector::uniform(0.5));
    }

    return layers;
}


static List<wallSurface> walls()
{
    return {testSurfaces::sphere(4), testSurfaces::quadSphere(4)};
}


//- The geometry of a face of a mesh
static faceGeometry geometryOf(const polyMesh& mesh, const label facei)
{
    faceGeometry f;
    f.centre = mesh.faceCentres()[facei];
    f.area = mesh.faceAreas()[facei];

    return f;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(layerGeometry, centresAreThoseOfPolyMesh)
{
    for (const wallSurface& wall : walls())
    {
        const prismLayers layers(shaken(wall));
        const layerGeometry geometry(layers, makeWallAddressing(wall));
        const memoryMesh mesh(layers);

        forAll(mesh().cells(), celli)
        {
            const point centre(geometry.centres(celli/n)[celli % n]);
            EXPECT_LT(mag(centre - mesh().cellCentres()[celli]), 1e-13);
        }
    }
}


TEST(layerGeometry, lacksAreThoseOfPolyMesh)
{
    // Twice from the two sides of a side of cells, once between layers
    const faceAims aims{0.9, 0.1};

    for (const wallSurface& wall : walls())
    {
        const prismLayers layers(shaken(wall));
        const layerGeometry geometry(layers, makeWallAddressing(wall));
        scalar sum = 0;
        forAll(wall.faces, facei)
        {
            sum += geometry.lack(facei, aims);
        }

        const memoryMesh memory(layers);
        const polyMesh& mesh = memory();
        const scalarField cosines
        (
            polyMeshTools::faceOrthogonality
            (
                mesh, mesh.faceAreas(), mesh.cellCentres()
            )
        );
        const scalarField skewness
        (
            polyMeshTools::faceSkewness
            (
                mesh, mesh.points(), mesh.faceCentres(), mesh.faceAreas(),
                mesh.cellCentres()
            )
        );

        scalar expected = 0;
        for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
        {
            const label a = mesh.faceOwner()[facei];
            const label b = mesh.faceNeighbour()[facei];
            const scalar lack =
                sqr(max(aims.cosine - cosines[facei], scalar(0)))
              + sqr(max(skewness[facei]/aims.skewness - 1, scalar(0)));
            expected += (a/n == b/n ? 1 : 2)*lack;
        }

        EXPECT_GT(expected, 1);
        EXPECT_NEAR(sum/expected, 1, 1e-9);
    }
}


TEST(layerGeometry, skewnessFromEitherSideIsTheSame)
{
    const prismLayers layers(shaken(testSurfaces::quadSphere(4)));
    const memoryMesh memory(layers);
    const polyMesh& mesh = memory();

    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        const point& a = mesh.cellCentres()[mesh.faceOwner()[facei]];
        const point& b = mesh.cellCentres()[mesh.faceNeighbour()[facei]];
        const pointField points(mesh.faces()[facei].points(mesh.points()));
        faceGeometry f(geometryOf(mesh, facei));
        const scalar one = skewnessExcess(f, points, a, b, 0.01);
        f.area *= -1;

        EXPECT_NEAR(skewnessExcess(f, points, b, a, 0.01), one, 1e-6*one);
    }
}


//- planarity() of a square with a corner that is raised, between centres above
//  and below it
static scalar planarityOfRaised(const scalar by, const point* above)
{
    const pointField points
    ({{0, 0, 0}, {1, 0, 0}, {1, 1, by}, {0, 1, 0}});

    return planarity
    (
        faceGeometry(points), points, point(0.5, 0.5, -0.2), above
    );
}


TEST(planarity, isOneForPlaneFacesAndTriangles)
{
    const point above(0.4, 0.6, 0.1);
    const pointField triangle({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}});

    EXPECT_NEAR(planarityOfRaised(0, &above), 1, 1e-14);
    EXPECT_EQ
    (
        planarity(faceGeometry(triangle), triangle, point::zero, &above), 1
    );
}


TEST(planarity, isNotPositiveWhereACentreIsBehindATriangleOfEitherCut)
{
    const point above(0.8, 0.8, 0.3);

    EXPECT_GT(planarityOfRaised(0.2, &above), 0.1);
    EXPECT_GT(planarityOfRaised(0.9, nullptr), 0.1);
    EXPECT_LT(planarityOfRaised(0.9, &above), 0);
}


TEST(planarity, isPositiveWherePolyMeshFindsABasePoint)
{
    const prismLayers layers(shaken(testSurfaces::quadSphere(4), 0.12));
    const memoryMesh memory(layers);
    const polyMesh& mesh = memory();
    labelList counts(2, Zero);

    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        const pointField points(mesh.faces()[facei].points(mesh.points()));
        const bool isPlane = 0 < planarity
        (
            geometryOf(mesh, facei), points,
            mesh.cellCentres()[mesh.faceOwner()[facei]],
            &mesh.cellCentres()[mesh.faceNeighbour()[facei]]
        );
        ++counts[isPlane];

        EXPECT_EQ
        (
            isPlane,
            polyMeshTetDecomposition::findSharedBasePoint
            (
                mesh, facei, polyMeshTetDecomposition::minTetQuality
            ) >= 0
        );
    }

    EXPECT_GT(min(counts), 10);
}


TEST(layerGeometry, knowsNeighboursAcrossEdges)
{
    const wallSurface wall(testSurfaces::halfCube(2));
    const wallAddressing addressing(makeWallAddressing(wall));
    const prismLayers layers
    (
        testSurfaces::straightLayers(wall, scalarList({0, 0.1}))
    );
    const layerGeometry geometry(layers, addressing);
    label nBorder = 0;

    forAll(wall.faces, facei)
    {
        forAll(wall.faces[facei], k)
        {
            const edge e(wall.faces[facei].faceEdge(k));
            const label other = geometry.across(facei, k);
            nBorder += other < 0;
            if (other >= 0)
            {
                EXPECT_NE(other, facei);
                EXPECT_EQ(wall.faces[other].edgeDirection(e), -1);
            }
        }
    }

    EXPECT_EQ(nBorder, 8);
}


TEST(layerGeometry, updateFollowsChanges)
{
    const wallSurface wall(testSurfaces::sphere(4));
    const wallAddressing addressing(makeWallAddressing(wall));
    prismLayers layers(shaken(wall));
    layerGeometry geometry(layers, addressing);
    layers.points[layers.index(5, 2)] += vector(0.01, 0, 0);
    geometry.update(addressing.pointFaces[5]);
    const layerGeometry anew(layers, addressing);

    forAll(wall.faces, facei)
    {
        EXPECT_EQ(geometry.centres(facei), anew.centres(facei));
    }
}


// ************************************************************************* //
