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

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using testSurfaces::shakenLayers;

static const label n = testSurfaces::nShaken;

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
        const prismLayers layers(shakenLayers(wall));
        const layerGeometry geometry(layers, makeWallAddressing(wall));
        const memoryMesh mesh(layers);

        forAll(mesh().cells(), celli)
        {
            const point centre(geometry.centres(celli/n)[celli % n]);
            EXPECT_LT(mag(centre - mesh().cellCentres()[celli]), 1e-13);
        }
    }
}


TEST(layerGeometry, violationsEqualThoseOfPolyMesh)
{
    // Twice from the two sides of a side of cells, once between layers
    const faceTargets targets{0.7, 0.1};

    for (const wallSurface& wall : walls())
    {
        const prismLayers layers(shakenLayers(wall));
        const layerGeometry geometry(layers, makeWallAddressing(wall));
        scalar sum = 0;
        forAll(wall.faces, facei)
        {
            sum += geometry.violation(facei, targets);
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
            const scalar violation =
                sqr(max(targets.cosine - cosines[facei], scalar(0)))
              + sqr(max(skewness[facei]/targets.skewness - 1, scalar(0)));
            expected += (a/n == b/n ? 1 : 2)*violation;
        }

        EXPECT_GT(expected, 1);
        EXPECT_NEAR(sum/expected, 1, 1e-9);
    }
}


TEST(layerGeometry, skewnessFromEitherSideIsTheSame)
{
    const prismLayers layers(shakenLayers(testSurfaces::quadSphere(4)));
    const memoryMesh memory(layers);
    const polyMesh& mesh = memory();

    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        const point& a = mesh.cellCentres()[mesh.faceOwner()[facei]];
        const point& b = mesh.cellCentres()[mesh.faceNeighbour()[facei]];
        const pointField points(mesh.faces()[facei].points(mesh.points()));
        faceGeometry f(geometryOf(mesh, facei));
        const scalar one = skewnessViolation(f, points, a, b, 0.01);
        f.area *= -1;

        EXPECT_NEAR(skewnessViolation(f, points, b, a, 0.01), one, 1e-6*one);
    }
}


TEST(layerGeometry, skewnessIsBoundedIfCentresAreBesideEachOther)
{
    // Its powers are numbers, too
    const pointField points({{0, 0, 0}, {2e4, 0, 0}, {0, 1e4, 0}});
    const point a(0, 0, 1e4);
    const point b(1e4, 0, 1e4);
    const faceGeometry f(points);
    const scalar excess = skewnessViolation(f, points, a, b, 3);

    EXPECT_GT(excess, 1e9);
    EXPECT_LT(excess, 1e20);
}


//- The violation of a square with a corner that is raised, between centres
//  above and below it
static scalar violationOfRaised
(
    const scalar by,
    const point* above,
    const scalar target = 0.1
)
{
    const pointField points
    ({{0, 0, 0}, {1, 0, 0}, {1, 1, by}, {0, 1, 0}});

    return planarityViolation
    (
        faceGeometry(points), points, point(0.5, 0.5, -0.2), above, target
    );
}


TEST(layerGeometry, sidesNeedNotBeBetterThanTheWall)
{
    const wallSurface wall(testSurfaces::unequalTriangles());
    prismLayers layers
    (
        testSurfaces::straightLayers(wall, scalarList({0, 0.01, 0.02}))
    );
    const layerGeometry flat(layers, makeWallAddressing(wall));
    const faceTargets targets{0.9};

    EXPECT_LT(flat.targetCosine(0, 0, targets), 0.2);
    EXPECT_EQ(flat.targetCosine(0, 1, targets), 0.9);
    EXPECT_EQ(flat.violation(0, targets), 0);
    EXPECT_TRUE(flat.isOfWall(0, 0, 1));

    // Nor worse by more than five degrees
    layers.points[layers.index(0, 1)] += vector(0, 0.05, 0);
    layers.points[layers.index(1, 1)] -= vector(0, 0.3, 0);
    const layerGeometry turned(layers, makeWallAddressing(wall));
    EXPECT_GT(turned.violation(0, targets), 0);
}


TEST(planarityViolation, isZeroForPlaneFacesAndTriangles)
{
    const point above(0.4, 0.6, 0.1);
    const pointField triangle({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}});

    EXPECT_EQ(violationOfRaised(0, &above, 0.999), 0);
    EXPECT_NEAR(violationOfRaised(0, &above, 1.5), 0.5, 1e-14);
    EXPECT_EQ
    (
        planarityViolation
        (
            faceGeometry(triangle), triangle, point::zero, &above, 2
        ),
        0
    );
}


TEST(planarityViolation, isMoreThanTheAimBehindATriangleOfEitherCut)
{
    const point above(0.8, 0.8, 0.3);

    EXPECT_EQ(violationOfRaised(0.2, &above), 0);
    EXPECT_EQ(violationOfRaised(0.9, nullptr), 0);
    EXPECT_GT(violationOfRaised(0.9, &above), 0.1);
}


TEST(planarityViolation, isWherePolyMeshFindsNoBasePoint)
{
    const prismLayers layers(shakenLayers(testSurfaces::quadSphere(4), 0.12));
    const memoryMesh memory(layers);
    const polyMesh& mesh = memory();
    labelList counts(2, Zero);

    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        const pointField points(mesh.faces()[facei].points(mesh.points()));
        const bool isPlane = 0 == planarityViolation
        (
            geometryOf(mesh, facei), points,
            mesh.cellCentres()[mesh.faceOwner()[facei]],
            &mesh.cellCentres()[mesh.faceNeighbour()[facei]], SMALL
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
    prismLayers layers(shakenLayers(wall));
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
