/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "testSurfaces.H"
#include "Random.H"
#include "wallSearch.H"
#include "wallSurface.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- Looks at all triangles
static pointIndexHit nearestOfAll
(
    const triSurface& surface,
    const vectorField& normals,
    const point& x,
    const scalar distance,
    const vector& direction,
    const scalar cosine
)
{
    pointIndexHit nearest;
    scalar least = sqr(distance);
    forAll(surface, i)
    {
        const pointHit hit(surface[i].nearestPoint(x, surface.points()));
        if
        (
            (normals[i] & direction) <= cosine && sqr(hit.distance()) < least
        )
        {
            least = sqr(hit.distance());
            nearest = pointIndexHit(true, hit.rawPoint(), i);
        }
    }

    return nearest;
}


static void expectAsOfAll(const wallSurface& wall)
{
    const triSurface surface(toTriSurface(wall));
    const triangleTree tree(surface);
    const boundBox box(wall.points, false);
    Random random(7);
    label nHits = 0;

    for (label i = 0; i < 2000; ++i)
    {
        // Also points of the wall, where several triangles are equally near
        const point x
        (
            i % 4 ? box.min() + cmptMultiply
            (
                random.sample01<vector>(), box.span()
            )
          : wall.points[i % wall.points.size()]
        );
        const vector d
        (
            i % 3
          ? normalised(random.sample01<vector>() - vector::uniform(0.5))
          : vector(Zero)
        );
        const scalar cosine = i % 3 ? random.sample01<scalar>() - 0.7 : 1;
        const scalar distance = random.sample01<scalar>()*box.mag();
        const pointIndexHit a(tree.nearest(x, distance, d, cosine));
        const pointIndexHit b
        (
            nearestOfAll(surface, tree.normals(), x, distance, d, cosine)
        );

        ASSERT_EQ(a.hit(), b.hit());
        if (b.hit())
        {
            EXPECT_EQ(a.index(), b.index());
            EXPECT_EQ(a.rawPoint(), b.rawPoint());
        }
        nHits += b.hit();
    }
    EXPECT_GT(nHits, 500);
    EXPECT_LT(nHits, 2000);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(triangleTree, findsWhatALookAtAllTrianglesFinds)
{
    expectAsOfAll(testSurfaces::sphere(6));
    expectAsOfAll(testSurfaces::lBlock(4));
    expectAsOfAll(testSurfaces::slitBlock(6, 0.05));
}


TEST(triangleTree, degenerateTrianglesHaveNoNormal)
{
    wallSurface wall(testSurfaces::cube(3));
    wall.points[wall.faces[5][0]] = wall.points[wall.faces[5][1]];
    expectAsOfAll(wall);
}


TEST(triangleTree, oneTriangle)
{
    wallSurface wall(testSurfaces::cube(1));
    wall.faces.setSize(1);
    const triSurface surface(toTriSurface(wall));
    const triangleTree tree(surface);
    const point x(surface[0].centre(surface.points()));

    EXPECT_TRUE(tree.nearest(x, 0.1).hit());
    EXPECT_TRUE(tree.nearest(x, 0.1, -tree.normals()[0], -0.9).hit());
    EXPECT_FALSE(tree.nearest(x, 0.1, tree.normals()[0], -0.9).hit());
    EXPECT_FALSE(tree.nearest(x + vector::one, 0.1).hit());
}


// ************************************************************************* //
