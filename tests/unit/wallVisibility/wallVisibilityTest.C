/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallVisibility.H"
#include "testSurfaces.H"
#include "unitConversion.H"
#include "Random.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static wallVisibility visibilityOf(const wallSurface& wall)
{
    return makeWallVisibility(wall, makeWallAddressing(wall));
}


//- How many sides of the unit cube a point is on
static label nSides(const point& x)
{
    label n = 0;

    for (const scalar c : x)
    {
        n += c < 1e-9 || c > 1 - 1e-9;
    }

    return n;
}


//- An L of one polygon, extruded: its reflex corner is at the origin
static wallSurface polygonalLBlock()
{
    const pointField plan
    ({
        {0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {1, 0, 0}
    });

    wallSurface wall;
    wall.points = plan;
    wall.points.append(plan + vector(0, 0, 1));
    wall.patchNames = wordList(1, word("wall"));
    wall.patchIDs = labelList(8, Zero);
    wall.faces.setSize(8);
    wall.faces[6] = face(identity(6)).reverseFace();
    wall.faces[7] = face(identity(6, 6));

    for (label i = 0; i < 6; ++i)
    {
        const label j = (i + 1) % 6;
        wall.faces[i] = face({i, j, j + 6, i + 6});
    }

    return wall;
}


static scalar smallest(const wallVisibility& v, const label p, const vector& d)
{
    scalar s = GREAT;

    for (const vector& n : v.cornerNormals[p])
    {
        s = min(s, n & d);
    }

    return s;
}


static List<vector> randomDirections(const label n)
{
    Random random(5);
    List<vector> directions(n);

    for (vector& d : directions)
    {
        d = normalised(random.sample01<vector>() - vector::uniform(0.5));
    }

    return directions;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(wallVisibility, conesOfCube)
{
    for (const wallSurface& wall :
        {testSurfaces::cube(4), testSurfaces::quadCube(4)})
    {
        const wallVisibility visibility(visibilityOf(wall));

        forAll(wall.points, p)
        {
            EXPECT_NEAR
            (
                visibility.cones[p].cosine,
                1/std::sqrt(scalar(nSides(wall.points[p]))),
                1e-15
            );
        }
        EXPECT_TRUE(visibility.emptyCones().empty());
    }
}


TEST(wallVisibility, meanNormalsOfCubeAreThoseOfItsSides)
{
    const wallSurface wall(testSurfaces::cube(4));
    const wallVisibility visibility(visibilityOf(wall));

    forAll(wall.points, p)
    {
        // However the sides are triangulated
        const vector& mean = visibility.meanNormals[p];
        const vector& axis = visibility.cones[p].axis;
        const scalar length = 1/std::sqrt(scalar(nSides(wall.points[p])));

        EXPECT_NEAR(mag(mean - length*axis), 0, 1e-14);
    }
}


TEST(wallVisibility, axesAreThoseOfTheCones)
{
    const wallVisibility visibility(visibilityOf(testSurfaces::cube(2)));
    const vectorField axes(visibility.axes());

    forAll(axes, p)
    {
        EXPECT_EQ(axes[p], visibility.cones[p].axis);
    }
}


TEST(wallVisibility, heightCosineOfCube)
{
    const wallSurface wall(testSurfaces::cube(4));
    const wallVisibility visibility(visibilityOf(wall));

    forAll(wall.points, p)
    {
        EXPECT_NEAR
        (
            visibility.heightCosine(p, visibility.cones[p].axis),
            1/std::sqrt(scalar(nSides(wall.points[p]))),
            1e-14
        );
    }
}


TEST(wallVisibility, heightCosineIsLinearInItsVector)
{
    const wallVisibility visibility(visibilityOf(testSurfaces::sphere(3)));
    const List<vector> d(randomDirections(2));

    forAll(visibility.cones, p)
    {
        EXPECT_NEAR
        (
            visibility.heightCosine(p, 2*d[0] - 3*d[1]),
            2*visibility.heightCosine(p, d[0])
          - 3*visibility.heightCosine(p, d[1]),
            1e-14
        );
    }
}


TEST(wallVisibility, reflexCornerHasTheNormalOfItsFace)
{
    const wallSurface wall(polygonalLBlock());
    const wallVisibility visibility(visibilityOf(wall));

    ASSERT_GT(testSurfaces::enclosedVolume(wall), 0);
    EXPECT_TRUE(visibility.emptyCones().empty());

    // The top, and the two sides of the concave edge
    const scalar cosine = 1/std::sqrt(3.0);
    EXPECT_NEAR(visibility.cones[6].cosine, cosine, 1e-15);
    EXPECT_NEAR
    (
        mag(visibility.cones[6].axis - cosine*vector(1, 1, 1)), 0, 1e-15
    );
}


TEST(wallVisibility, reflexCornerHasItsFullAngle)
{
    const wallVisibility visibility(visibilityOf(polygonalLBlock()));

    // 270 degrees of the top and 90 of each side
    const vector mean(vector(1, 1, 3)/5);

    EXPECT_NEAR(mag(visibility.meanNormals[6] - mean), 0, 1e-14);
}


TEST(wallVisibility, limitedKeepsTheMargin)
{
    const wallSurface wall(testSurfaces::cube(2));
    const wallVisibility visibility(visibilityOf(wall));

    for (const vector& d : randomDirections(100))
    {
        forAll(wall.points, p)
        {
            for (const scalar margin : {0.1, 0.2, 0.9})
            {
                const vector limited(visibility.limited(p, d, margin));

                EXPECT_NEAR(mag(limited), 1, 1e-14);
                EXPECT_GE
                (
                    smallest(visibility, p, limited),
                    margin*visibility.cones[p].cosine - 1e-14
                );
            }
        }
    }
}


TEST(wallVisibility, limitedLeavesWhatIsInside)
{
    const wallSurface wall(testSurfaces::cube(2));
    const wallVisibility visibility(visibilityOf(wall));
    label nInside = 0;

    for (const vector& d : randomDirections(100))
    {
        forAll(wall.points, p)
        {
            const scalar bound = 0.2*visibility.cones[p].cosine;

            if (smallest(visibility, p, d) > bound)
            {
                ++nInside;
                EXPECT_NEAR(mag(visibility.limited(p, d, 0.2) - d), 0, 1e-15);
            }
        }
    }

    EXPECT_GT(nInside, 0);
}


TEST(wallVisibility, limitedStaysInThePlaneToTheAxis)
{
    const wallVisibility visibility(visibilityOf(testSurfaces::sphere(3)));

    for (const vector& d : randomDirections(20))
    {
        forAll(visibility.cones, p)
        {
            const vector across(visibility.cones[p].axis ^ d);
            EXPECT_NEAR
            (
                (visibility.limited(p, d, 0.2) & across)/mag(across), 0, 1e-13
            );
        }
    }
}


// ************************************************************************* //
