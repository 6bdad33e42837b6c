/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "packPoints.H"
#include "farFieldMeshControls.H"
#include "testSurfaces.H"
#include "wallSearch.H"

#include <gtest/gtest.h>
#include <omp.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const label many = 10000000;


//- The cube from (-1 -1 -1) to (1 1 1) with the normals inwards
static wallSurface room(const label nEdges)
{
    wallSurface surface(testSurfaces::cube(nEdges));
    for (face& f : surface.faces)
    {
        f.flip();
    }

    return surface;
}


static cellSizes equalSizes(const wallSurface& surface, const scalar size)
{
    return cellSizes
    (
        pointField(1, Zero), scalarField(1, size), 1 + 1e-9,
        boundBox(surface.points, false), sizeBounds(), many
    );
}


static scalar wallDistance(const boundBox& box, const point& x)
{
    return min(cmptMin(x - box.min()), cmptMin(box.max() - x));
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(cubesBetween, nCubesIsTheIntegralOverTheSpace)
{
    const wallSurface surface(room(4));
    const wallSearch search(surface);
    const scalar size = 0.07;
    const cubeCentres cubes
    (
        cubesBetween(surface.points, search, equalSizes(surface, size), many)
    );
    const scalar n =
        boundBox(surface.points, false).volume()/pow3(size);

    EXPECT_TRUE(cubes.complete);
    EXPECT_NEAR(cubes.nCubes, n, 0.05*n);
    EXPECT_EQ(cubes.points.size(), cubes.sizes.size());
    EXPECT_EQ(cubes.points.size(), cubes.areNear.size());
    EXPECT_GT(cubes.points.size(), n/pow3(farFieldTuned.packedWidth));
}


TEST(cubesBetween, areNotCompleteBeyondTheBound)
{
    const wallSurface surface(room(4));
    const wallSearch search(surface);

    const cellSizes sizes(equalSizes(surface, 0.05));

    EXPECT_FALSE
    (
        cubesBetween(surface.points, search, sizes, 1000).complete
    );
}


TEST(packPoints, keepApartFromEachOtherAndFromTheSurface)
{
    const wallSurface surface(room(10));
    const wallSearch search(surface);
    const boundBox box(surface.points, false);
    const scalar size = cmptMax(box.span())/10;
    const cellSizes sizes(equalSizes(surface, size));
    const cubeCentres cubes(cubesBetween(surface.points, search, sizes, many));
    const pointField points(packPoints(surface.points, search, sizes, cubes));

    scalar nearest = GREAT;
    forAll(points, p)
    {
        EXPECT_GT
        (
            wallDistance(box, points[p]), farFieldTuned.packedMargin*size
        );
        for (label q = 0; q < p; ++q)
        {
            nearest = min(nearest, mag(points[p] - points[q]));
        }
        for (const point& x : surface.points)
        {
            nearest = min(nearest, mag(points[p] - x));
        }
    }

    EXPECT_GE(nearest, farFieldTuned.packedDistance*size);

    // As close as spheres that are poured, or closer
    const scalar inside =
        pow3(cmptMax(box.span()) - 2*farFieldTuned.packedMargin*size);
    EXPECT_GT(points.size(), 0.6*inside/pow3(size));
}


TEST(packPoints, areFineNextToFineParts)
{
    const wallSurface surface(room(20));
    const wallSearch search(surface);
    const boundBox box(surface.points, false);
    const cellSizes sizes
    (
        pointField(1, box.min()), scalarField(1, 0.02*box.mag()), 1.3, box,
        sizeBounds(), many
    );
    const pointField points
    (
        packPoints
        (
            surface.points, search, sizes,
            cubesBetween(surface.points, search, sizes, many)
        )
    );
    label nLow = 0, nHigh = 0;
    for (const point& x : points)
    {
        nLow += cmptMax(x - box.min()) < 0.5*cmptMax(box.span());
        nHigh += cmptMin(x - box.min()) > 0.5*cmptMax(box.span());
    }

    EXPECT_GT(nHigh, 0);
    EXPECT_GT(nLow, 10*nHigh);
}


TEST(packPoints, areTheSameOnAnyNumberOfThreads)
{
    const wallSurface surface(room(12));
    const wallSearch search(surface);
    const cellSizes sizes(equalSizes(surface, 0.06));
    const label before = omp_get_max_threads();
    pointField first;
    for (const label n : {1, 2, 3, 5})
    {
        omp_set_num_threads(n);
        const cubeCentres cubes
        (
            cubesBetween(surface.points, search, sizes, many)
        );
        const pointField points
        (
            packPoints(surface.points, search, sizes, cubes)
        );
        if (n == 1)
        {
            first = points;
            EXPECT_GT(points.size(), 1000);
        }
        EXPECT_EQ(points, first) << n;
    }
    omp_set_num_threads(before);
}


// ************************************************************************* //
