/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallBlocks.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static const scalar radius = 0.1;

//- The islands of a wall with an envelope of one radius
static labelList islandsOf
(
    const wallSurface& wall,
    const scalar radius = ::radius
)
{
    const scalarField all(wall.points.size(), radius);

    return findFieldIslands
    (
        testSurfaces::wallOfOne(wall).under, envelopeRadii{all, all, all, all}
    );
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(fieldIslands, aConvexBodyHasNone)
{
    EXPECT_TRUE(islandsOf(testSurfaces::cube(6)).empty());
    EXPECT_TRUE(islandsOf(testSurfaces::sphere(8)).empty());
}


TEST(fieldIslands, reachFromConcaveEdges)
{
    const wallSurface wall(testSurfaces::lBlock(20));
    const testSurfaces::wallOfOne one(wall);
    const boolList isIn(bitSet(wall.points.size(), islandsOf(wall)).values());
    label nFar = 0;

    // Along edges of triangles a way is at most sqrt(2) times as long
    forAll(wall.points, p)
    {
        scalar nearest = GREAT;
        forAll(wall.points, q)
        {
            if (isOnConcaveEdge(one.kinds[q]))
            {
                nearest = min(nearest, mag(wall.points[q] - wall.points[p]));
            }
        }
        if (nearest > 2*radius)
        {
            EXPECT_FALSE(isIn[p]);
            ++nFar;
        }
        else if (::sqrt(2.0)*nearest < 2*radius)
        {
            EXPECT_TRUE(isIn[p]);
        }
    }
    EXPECT_GT(nFar, wall.points.size()/2);
}


TEST(fieldIslands, wallsCurvedInwardsNeedAField)
{
    wallSurface cavity(testSurfaces::sphere(8));
    for (face& f : cavity.faces)
    {
        f.flip();
    }

    EXPECT_EQ(islandsOf(cavity, 0.2), identity(cavity.points.size()));
    EXPECT_TRUE(islandsOf(cavity, 0.05).empty());
}


TEST(fieldIslands, pointsWithoutRoomNeedAField)
{
    const wallSurface wall(testSurfaces::sphere(8));
    const scalarField wanted(wall.points.size(), radius);
    scalarField limited(wanted);
    limited[7] = 0.5*radius;
    const labelList islands
    (
        findFieldIslands
        (
            testSurfaces::wallOfOne(wall).under,
            envelopeRadii{wanted, limited, limited, wanted}
        )
    );

    ASSERT_FALSE(islands.empty());
    EXPECT_TRUE(islands.found(7));
    for (const label p : islands)
    {
        EXPECT_LE(mag(wall.points[p] - wall.points[7]), radius);
    }
}


TEST(hasBlocks, wallsOfManyPointsThatAreWide)
{
    const wallSurface wall(testSurfaces::cube(6));
    const scalarField radius(wall.points.size(), 0.01);
    blockControls controls;
    controls.largeWall = wall.points.size() - 1;

    // The edge of the cube is 1, and so 33.3 times as long as the reach
    controls.largeWidth = 33;
    EXPECT_TRUE(hasBlocks(wall.points, radius, controls));
    controls.largeWidth = 34;
    EXPECT_FALSE(hasBlocks(wall.points, radius, controls));

    controls.largeWidth = 33;
    ++controls.largeWall;
    EXPECT_FALSE(hasBlocks(wall.points, radius, controls));
}


// ************************************************************************* //
