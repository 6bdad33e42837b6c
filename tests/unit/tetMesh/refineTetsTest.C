/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "refineTets.H"
#include "tetDomains.H"
#include "tetEditor.H"
#include "testSurfaces.H"
#include "triangleIndex.H"

#include <gtest/gtest.h>
#include <omp.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const label manyTets = 1000000;


//- A grid of points in a cube of width 1, by a margin away from its sides
static wantedPoints grid(const label n, const scalar margin)
{
    wantedPoints wanted;
    for (label i = 0; i < n*n*n; ++i)
    {
        const vector at(i % n, (i/n) % n, i/(n*n));
        wanted.points.append
        (
            vector::uniform(margin) + (1 - 2*margin)/(n - 1)*at
        );
    }
    wanted.near = labelList(wanted.points.size(), 0);

    return wanted;
}


static scalar longestOverSize
(
    const tetMesh& mesh,
    const std::function<scalar(const point&)>& size
)
{
    scalar longest = 0;
    for (const tetCell& tet : mesh.tets)
    {
        const scalar wanted = size(tet.tet(mesh.points).centre());
        for (label i = 0; i < 6; ++i)
        {
            longest = max(longest, tet.tetEdge(i).mag(mesh.points)/wanted);
        }
    }

    return longest;
}


static tetMesh refined
(
    const tetDomain& domain,
    const wantedPoints& wanted,
    const std::function<scalar(const point&)>& size
)
{
    tetMesh mesh(tetrahedralize(domain));
    refineTets(wanted, size, manyTets, mesh);

    return mesh;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(refineTets, tetrahedraFillTheDomainAndArePositive)
{
    for (const wallSurface& wall :
        {
            testSurfaces::cube(3),
            testSurfaces::sphere(6),
            testSurfaces::lBlock(4)
        })
    {
        const tetMesh mesh
        (
            refined
            (
                inside(wall), wantedPoints(), [](const point&) { return 0.15; }
            )
        );
        EXPECT_NEAR
        (
            volumeOf(mesh), testSurfaces::enclosedVolume(wall), 1e-12
        );
        EXPECT_TRUE(allPositive(mesh.points, mesh.tets));
        EXPECT_GT(mesh.points.size(), 2*wall.points.size());
    }
}


TEST(refineTets, facetsStay)
{
    const tetDomain domain(inside(testSurfaces::lBlock(4)));
    const tetMesh mesh
    (
        refined(domain, wantedPoints(), [](const point&) { return 0.1; })
    );
    const triangleIndex facets(makeTriangleIndex(domain.facets));
    const auto neighbours(tetNeighbours(mesh.tets, mesh.points.size()));
    label nFound = 0;
    forAll(mesh.tets, t)
    {
        for (label i = 0; i < 4; ++i)
        {
            if (neighbours[t][i] < 0)
            {
                EXPECT_TRUE(facets.found(triFace(mesh.tets[t].face(i))));
                ++nFound;
            }
        }
    }
    EXPECT_EQ(nFound, domain.facets.size());
}


// The points of a grid are cospherical
TEST(refineTets, wantedPointsAreAdded)
{
    const wantedPoints wanted(grid(5, 0.2));
    tetMesh mesh(tetrahedralize(inside(testSurfaces::cube(4))));
    const label before = mesh.points.size();
    refineTets(wanted, [](const point&) { return 10; }, manyTets, mesh);

    EXPECT_EQ(mesh.points.size(), before + wanted.points.size());
    for (const point& x : wanted.points)
    {
        EXPECT_TRUE(mesh.points.found(x));
    }
    EXPECT_NEAR(volumeOf(mesh), 1, 1e-12);
}


TEST(refineTets, edgesAreAsLongAsTheSizes)
{
    const std::function<scalar(const point&)> size
    (
        [](const point& x) { return 0.05 + 0.2*mag(x); }
    );
    const tetMesh mesh
    (
        refined(inside(testSurfaces::cube(16)), wantedPoints(), size)
    );

    // Beside triangles that stay there is not always room
    EXPECT_LT(longestOverSize(mesh, size), 2.5);
    EXPECT_GT(longestOverSize(mesh, size), 1);
}


TEST(refineTets, meshesAreTheSameOnAnyNumberOfThreads)
{
    const tetDomain domain(inside(testSurfaces::sphere(8)));
    const label before = omp_get_max_threads();
    tetMesh first;
    for (const label n : {1, 2, 5})
    {
        omp_set_num_threads(n);
        const tetMesh mesh
        (
            refined(domain, grid(4, 0.3), [](const point&) { return 0.06; })
        );
        if (n == 1)
        {
            first = mesh;
        }
        EXPECT_EQ(mesh.points, first.points);
        EXPECT_EQ(mesh.tets, first.tets);
    }
    omp_set_num_threads(before);
}


//- A cube in a cube of width 1, with tetrahedra on both sides of the inner one
static tetDomain cubeInCube()
{
    const wallSurface inner
    (
        testSurfaces::translated
        (
            testSurfaces::cube(4, 0.4), vector::uniform(0.3)
        )
    );

    return inside(testSurfaces::merge(inner, testSurfaces::cube(3)));
}


//- A grid of points, of which each has the nearest point of the domain
static wantedPoints gridIn(const tetDomain& domain)
{
    wantedPoints wanted(grid(8, 0.05));
    forAll(wanted.points, i)
    {
        wanted.near[i] = findMin
        (
            scalarField(magSqr(domain.points - wanted.points[i]))
        );
    }

    return wanted;
}


TEST(insertPoints, addsAllPointsOnBothSidesOfFacets)
{
    const tetDomain domain(cubeInCube());
    const wantedPoints wanted(gridIn(domain));
    tetMesh mesh(tetrahedralize(domain));
    const label before = mesh.points.size();
    const labelList labels(insertPoints(wanted, domain.facets, mesh));

    EXPECT_EQ(mesh.points.size(), before + wanted.points.size());
    forAll(labels, i)
    {
        ASSERT_GE(labels[i], before);
        EXPECT_EQ(mesh.points[labels[i]], wanted.points[i]);
    }
    EXPECT_NEAR(volumeOf(mesh), 1, 1e-12);
    EXPECT_TRUE(allPositive(mesh.points, mesh.tets));
}


TEST(insertPoints, facetsStay)
{
    const tetDomain domain(cubeInCube());
    tetMesh mesh(tetrahedralize(domain));
    insertPoints(gridIn(domain), domain.facets, mesh);

    const triangleIndex facets(makeTriangleIndex(domain.facets));
    labelList nTets(domain.facets.size(), 0);
    for (const tetCell& tet : mesh.tets)
    {
        for (label i = 0; i < 4; ++i)
        {
            const label facet = facets.lookup(triFace(tet.face(i)), -1);
            if (facet >= 0)
            {
                ++nTets[facet];
            }
        }
    }
    const label nInner = testSurfaces::cube(4).faces.size();
    forAll(nTets, facet)
    {
        EXPECT_EQ(nTets[facet], facet < nInner ? 2 : 1);
    }
}


TEST(insertPoints, meshesAreTheSameOnAnyNumberOfThreads)
{
    const tetDomain domain(cubeInCube());
    const tetMesh empty(tetrahedralize(domain));
    const label before = omp_get_max_threads();
    tetMesh first;
    for (const label n : {1, 2, 5})
    {
        omp_set_num_threads(n);
        tetMesh mesh(empty);
        insertPoints(gridIn(domain), domain.facets, mesh);
        if (n == 1)
        {
            first = mesh;
        }
        EXPECT_EQ(mesh.points, first.points);
        EXPECT_EQ(mesh.tets, first.tets);
    }
    omp_set_num_threads(before);
}


TEST(refineTets, addsNoPointsToTooManyTetrahedra)
{
    tetMesh mesh(tetrahedralize(inside(testSurfaces::cube(3))));
    const label before = mesh.tets.size();
    refineTets(wantedPoints(), [](const point&) { return 0.02; }, 2000, mesh);

    EXPECT_GT(mesh.tets.size(), before);
    EXPECT_LT(mesh.tets.size(), 40000);
}

// ************************************************************************* //
