/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetrahedralize.H"
#include "tetDomains.H"
#include "testSurfaces.H"
#include "HashSet.H"
#include "mathematicalConstants.H"
#include "Random.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- Between the cube [-1, 2]^3 and the unit cube in it
static tetDomain boxWithHole()
{
    const wallSurface outer
    (
        testSurfaces::translated
        (
            testSurfaces::cube(2, 3), vector::uniform(-1)
        )
    );

    tetDomain domain(inside(testSurfaces::merge(testSurfaces::cube(3), outer)));
    domain.holes = pointField(1, point(0.5, 0.5, 0.5));

    return domain;
}


static tetDomain boxWithNodes(const label nNodes)
{
    Random random(11);
    tetDomain domain(inside(testSurfaces::cube(3)));

    for (label i = 0; i < nNodes; ++i)
    {
        domain.points.append(random.sample01<vector>());
    }

    return domain;
}


//- Adds a disc of radius 1 from z up to z + 0.1, whose caps are fans of long
//  triangles
static void addDisc(const scalar z, tetDomain& domain)
{
    const label n = 100;
    const label low = domain.points.size();
    const label high = low + n;
    for (const scalar height : {z, z + 0.1})
    {
        for (label i = 0; i < n; ++i)
        {
            const scalar a = constant::mathematical::twoPi*i/n;
            domain.points.append(point(std::cos(a), std::sin(a), height));
        }
    }

    for (label i = 0; i < n; ++i)
    {
        const label j = (i + 1) % n;
        domain.facets.append(face({low + i, low + j, high + j}));
        domain.facets.append(face({low + i, high + j, high + i}));
        if (i > 0 && j > 0)
        {
            domain.facets.append(face({low, low + j, low + i}));
            domain.facets.append(face({high, high + i, high + j}));
        }
    }
}


//- Two discs in the cube [-3, 3]^3, with a gap between them
static tetDomain twoDiscs(const scalar gap)
{
    wallSurface box(testSurfaces::cube(1, 6));
    box.points -= vector::uniform(3);
    tetDomain domain(inside(box));
    addDisc(0, domain);
    addDisc(0.1 + gap, domain);

    return domain;
}


static List<tetDomain> domains()
{
    return List<tetDomain>
    ({
        inside(testSurfaces::cube(3)),
        inside(testSurfaces::sphere(6)),
        boxWithHole(),
        boxWithNodes(200)
    });
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(tetrahedralize, volumesSumToThatOfTheBody)
{
    for (const wallSurface& wall :
        {
            testSurfaces::cube(3),
            testSurfaces::sphere(6),
            testSurfaces::lBlock(4)
        })
    {
        EXPECT_NEAR
        (
            volumeOf(tetrahedralize(inside(wall))),
            testSurfaces::enclosedVolume(wall),
            1e-12
        );
    }
}


// In rotated coordinates the caps are not flat but for rounding: TetGen fails,
// or adds two hundred points
TEST(tetrahedralize, wideFlatFacesNeedFewFurtherPoints)
{
    for (const scalar gap : {0.01, 0.03})
    {
        const tetDomain domain(twoDiscs(gap));
        const tetMesh mesh(tetrahedralize(domain));

        EXPECT_LT(mesh.points.size(), domain.points.size() + 10);
    }
}


TEST(tetrahedralize, nodesDoNotChangeTheVolume)
{
    EXPECT_NEAR(volumeOf(tetrahedralize(boxWithNodes(200))), 1, 1e-12);
}


TEST(tetrahedralize, holeIsNotFilled)
{
    EXPECT_NEAR(volumeOf(tetrahedralize(boxWithHole())), 27 - 1, 1e-12);
}


TEST(tetrahedralize, volumesArePositive)
{
    for (const tetDomain& domain : domains())
    {
        const tetMesh mesh(tetrahedralize(domain));

        for (const tetCell& tet : mesh.tets)
        {
            EXPECT_GT(tet.tet(mesh.points).mag(), 0);
        }
    }
}


TEST(tetrahedralize, pointsKeepTheirOrder)
{
    for (const tetDomain& domain : domains())
    {
        const tetMesh mesh(tetrahedralize(domain));

        ASSERT_GE(mesh.points.size(), domain.points.size());
        forAll(domain.points, p)
        {
            EXPECT_EQ(mesh.points[p], domain.points[p]);
        }
    }
}


TEST(tetrahedralize, nodesInsideAreUsed)
{
    const tetMesh mesh(tetrahedralize(boxWithNodes(200)));

    labelHashSet used;
    for (const tetCell& tet : mesh.tets)
    {
        for (const label p : tet)
        {
            used.insert(p);
        }
    }

    EXPECT_EQ(used.size(), mesh.points.size());
}


TEST(tetrahedralize, nodesOutsideAreKeptUnused)
{
    tetDomain domain(boxWithNodes(20));
    const label outside = domain.points.size();
    domain.points.append(point(5, 5, 5));
    domain.points.append(point(0.4, 0.4, 0.4));
    const tetMesh mesh(tetrahedralize(domain));

    EXPECT_EQ(mesh.points[outside], point(5, 5, 5));
    EXPECT_EQ(mesh.points[outside + 1], point(0.4, 0.4, 0.4));
    for (const tetCell& tet : mesh.tets)
    {
        EXPECT_EQ(tet.find(outside), -1);
    }
}


TEST(tetrahedralize, equalNodesKeepTheOrder)
{
    tetDomain domain(boxWithNodes(20));
    const label n = domain.points.size();
    domain.points.append(domain.points[n - 1]);
    domain.points.append(point(0.4, 0.4, 0.4));
    const tetMesh mesh(tetrahedralize(domain));

    EXPECT_EQ(mesh.points[n], domain.points[n - 1]);
    EXPECT_EQ(mesh.points[n + 1], point(0.4, 0.4, 0.4));
    EXPECT_NEAR(volumeOf(mesh), 1, 1e-12);
}


TEST(tetrahedralize, facetsAreFaces)
{
    for (const tetDomain& domain : domains())
    {
        const tetMesh mesh(tetrahedralize(domain));

        List<DynamicList<label>> pointTets(mesh.points.size());
        forAll(mesh.tets, t)
        {
            for (const label p : mesh.tets[t])
            {
                pointTets[p].append(t);
            }
        }

        for (const face& f : domain.facets)
        {
            label n = 0;
            for (const label t : pointTets[f[0]])
            {
                n += mesh.tets[t].find(f[1]) >= 0
                  && mesh.tets[t].find(f[2]) >= 0;
            }
            EXPECT_EQ(n, 1);
        }
    }
}


TEST(tetrahedralize, intersectingFacetsAreAnError)
{
    const wallSurface box(testSurfaces::cube(3));
    const wallSurface both
    (
        testSurfaces::merge
        (
            box, testSurfaces::translated(box, vector(0.4, 0.45, 0.37))
        )
    );

    EXPECT_THROW(tetrahedralize(inside(both)), Foam::error);
}


TEST(tetrahedralize, tinyAndHugeDomainsAreFilled)
{
    for (const scalar scale : {1e-6, 1e6})
    {
        tetDomain domain(boxWithNodes(100));
        domain.points *= scale;

        EXPECT_NEAR(volumeOf(tetrahedralize(domain))/pow3(scale), 1, 1e-12);
    }
}


// ************************************************************************* //
