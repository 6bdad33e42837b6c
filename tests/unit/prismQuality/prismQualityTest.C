/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/


#include "cellPredicates.H"
#include "HashSet.H"
#include "prismQuality.H"
#include "scaledJacobian.H"
#include "testLayers.H"
#include "testSurfaces.H"
#include "unitConversion.H"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- One layer of height 1 on a regular polygon
static prismLayers unitCell(const label nPoints)
{
    return testSurfaces::onePolygon(nPoints, scalarList({0, 1}));
}


//- The upper face is turned by an angle [rad]
static prismLayers twistedCell(const label nPoints, const scalar angle)
{
    prismLayers cell(unitCell(nPoints));

    for (label c = 0; c < nPoints; ++c)
    {
        point& p = cell.points[cell.pointLabel(c, 1)];
        p = point
        (
            std::cos(angle)*p.x() - std::sin(angle)*p.y(),
            std::sin(angle)*p.x() + std::cos(angle)*p.y(),
            p.z()
        );
    }

    return cell;
}


static prismLayers mirrored(prismLayers layers)
{
    for (point& p : layers.points)
    {
        p.z() = -p.z();
    }

    return layers;
}


//- A rigid motion, with coordinates that round
static prismLayers moved(prismLayers layers)
{
    const vector x(normalised(vector(1, 0.3, -0.7)));
    const vector y(normalised(x ^ vector(0.2, 1, 0.9)));
    const vector z(x ^ y);

    for (point& p : layers.points)
    {
        p = p.x()*x + p.y()*y + p.z()*z + vector(3, -5, 7);
    }

    return layers;
}


static prismLayers cubeLayers(const label n)
{
    return testSurfaces::straightLayers
    (
        testSurfaces::cube(n),
        testSurfaces::geometricHeights(3, 0.01, 1.5)
    );
}


//- Layers that grow into the solid
static prismLayers mirroredCube()
{
    return testSurfaces::straightLayers
    (
        testSurfaces::cube(2),
        testSurfaces::geometricHeights(3, -0.01, 1.5)
    );
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(orientation, signs)
{
    const point a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);

    EXPECT_EQ(orientation(a, b, c, point(0, 0, 1)), 1);
    EXPECT_EQ(orientation(a, b, c, point(0, 0, -1)), -1);
    EXPECT_EQ(orientation(a, b, c, point(5, 7, 0)), 0);
}


TEST(orientation, exactWhereFloatingPointIsNot)
{
    // d is off the plane x + y + z = 3/10 by one unit in the last place
    const point a(0.3, 0, 0), b(0, 0.3, 0), c(0, 0, 0.3);
    const point d(0.3, 0.3, std::nextafter(-0.3, 0.0));
    const point e(0.3, 0.3, std::nextafter(-0.3, -1.0));

    EXPECT_EQ(orientation(a, b, c, point(0.3, 0.3, -0.3)), 0);
    EXPECT_EQ(orientation(a, b, c, d), -orientation(a, b, c, e));
    EXPECT_NE(orientation(a, b, c, d), 0);
}


TEST(isPositive, standardCells)
{
    for (label n = 3; n < 8; ++n)
    {
        EXPECT_TRUE(isPositive(unitCell(n), 0, 1)) << n << " points";
        EXPECT_TRUE(isPositive(moved(unitCell(n)), 0, 1)) << n << " points";
    }
}


TEST(isPositive, mirrorImagesAreNot)
{
    for (label n = 3; n < 8; ++n)
    {
        EXPECT_FALSE(isPositive(mirrored(unitCell(n)), 0, 1));
        EXPECT_LT(worstJacobian(mirrored(unitCell(n)), 0), 0);
    }
}


TEST(isPositive, flatCellsAreNot)
{
    for (label n = 3; n < 8; ++n)
    {
        const prismLayers flat(testSurfaces::onePolygon(n, scalarList({0, 0})));

        EXPECT_FALSE(isPositive(flat, 0, 1));
        EXPECT_FALSE(isPositive(moved(flat), 0, 1));
    }
}


TEST(isPositive, thinCells)
{
    // The aspect ratio of y+ = 1 at large Reynolds numbers, and far beyond
    for (const scalar height : {1e-4, 1e-6, 1e-10})
    {
        const prismLayers thin
        (
            testSurfaces::onePolygon(3, scalarList({0, height}))
        );

        EXPECT_TRUE(isPositive(thin, 0, 1)) << height;
        EXPECT_TRUE(isPositive(moved(thin), 0, 1)) << height;
        EXPECT_FALSE(isPositive(moved(mirrored(thin)), 0, 1)) << height;
    }
}


TEST(isPositive, positiveCornersAreNotEnough)
{
    // The corners of a prism whose upper triangle is turned stay positive; the
    // tetrahedra on two points below and two above are flat at 60 degrees
    for (const scalar sign : {-1, 1})
    {
        const prismLayers good(twistedCell(3, sign*degToRad(59.9)));
        const prismLayers bad(twistedCell(3, sign*degToRad(60.1)));

        EXPECT_GT(worstJacobian(good, 0), 0.5);
        EXPECT_GT(worstJacobian(bad, 0), 0.5);
        EXPECT_TRUE(isPositive(good, 0, 1));
        EXPECT_FALSE(isPositive(bad, 0, 1));
    }
}


TEST(isPositive, everyCornerCounts)
{
    for (label n = 3; n < 7; ++n)
    {
        for (label c = 0; c < n; ++c)
        {
            prismLayers cell(unitCell(n));
            cell.points[cell.pointLabel(c, 1)].z() = -0.1;

            EXPECT_FALSE(isPositive(cell, 0, 1)) << n << ' ' << c;
        }
    }
}


TEST(isPositive, notWithoutNumbers)
{
    prismLayers cell(unitCell(3));
    cell.points[1].x() = std::numeric_limits<scalar>::quiet_NaN();

    EXPECT_FALSE(isPositive(cell, 0, 1));
}


TEST(scaledJacobian, sineOfTheAngleOnUprightCells)
{
    for (label n = 3; n < 8; ++n)
    {
        EXPECT_NEAR
        (
            worstJacobian(unitCell(n), 0),
            std::sin(degToRad(360.0/n)),
            1e-14
        );
    }
}


TEST(scaledJacobian, independentOfSize)
{
    prismLayers cell(moved(unitCell(3)));
    const scalar before = worstJacobian(cell, 0);

    for (point& p : cell.points)
    {
        p *= 1e-5;
    }

    EXPECT_NEAR(worstJacobian(cell, 0), before, 1e-12);
}


TEST(outerFan, isTheHighestWhereTheFirstLeavesNoVolume)
{
    // A square whose corners are above and below it by more than the height of
    // the cell: below the diagonal of the low corners there is no volume
    for (const scalar warp : {0.01, -0.01})
    {
        for (const scalar height : {0.1, 1e-3})
        {
            prismLayers layers;
            layers.nLayers = 1;
            layers.isCut = true;
            for (label k = 0; k < 4; ++k)
            {
                const scalar z = k % 2 ? warp : -warp;
                const point x(k == 1 || k == 2, k > 1, z);
                layers.points.append(x);
                layers.points.append(x + vector(0, 0, height));
            }
            layers.faces = faceList({face({0, 1, 2, 3})});

            const bool isLow = warp > 0 && height < 0.01;
            EXPECT_EQ(outerFan(layers, 0)[0] % 2, isLow ? 1 : 0);
            EXPECT_TRUE(isPositiveStack(layers, 0));
        }
    }
}


TEST(isPositiveStack, onlyStacksOnTheFallenPointAreNot)
{
    prismLayers layers(cubeLayers(3));
    const face& f = layers.faces[5];
    const point turned(layers(f[0], 1));
    layers.points[layers.pointLabel(f[0], 2)] = turned;

    labelHashSet expected;
    forAll(layers.faces, facei)
    {
        if (layers.faces[facei].found(f[0]))
        {
            expected.insert(facei);
        }
    }

    forAll(layers.faces, facei)
    {
        EXPECT_EQ(isPositiveStack(layers, facei), !expected.found(facei));

        // The cells below the point that fell are as they were
        EXPECT_TRUE(isPositive(layers, facei, 1));
    }
    EXPECT_FALSE(expected.empty());
}


TEST(certify, cubeIsValid)
{
    const prismLayers layers(cubeLayers(4));
    const layerCertificate certificate(certify(layers));

    EXPECT_TRUE(certificate.valid());
    EXPECT_EQ(certificate.nCells, 12*16*3);
    ASSERT_EQ(certificate.worstJacobian.size(), 12*16);
    EXPECT_GT(min(certificate.worstJacobian), 0.3);
}


TEST(certify, countsStacks)
{
    const prismLayers layers(mirroredCube());
    const layerCertificate certificate(certify(layers));

    EXPECT_FALSE(certificate.valid());
    EXPECT_EQ(certificate.nStacksNotPositive, layers.faces.size());
}


// ************************************************************************* //
