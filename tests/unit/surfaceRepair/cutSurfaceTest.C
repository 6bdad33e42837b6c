/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutSurface.H"
#include "openSurfaces.H"
#include "orientOpenWall.H"
#include "ranges.H"
#include "sidePair.H"
#include "splitAtSidePatches.H"
#include "testStages.H"
#include "wallDefects.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Of the wall below a height
static sidePatch lid(const scalar height)
{
    return symmetryPlane("lid", point(0, 0, height), vector(0, 0, 1));
}


static scalar leastHeight(const wallSurface& surface)
{
    scalar least = GREAT;
    for (const face& f : surface.faces)
    {
        scalar longest = 0;
        for (const edge& e : f.edges())
        {
            longest = max(longest, e.mag(surface.points));
        }
        least = min(least, 2*f.mag(surface.points)/sqr(longest));
    }

    return least;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(cutSurface, leavesWhatIsInFrontOfThePlane)
{
    for (const scalar height : {0.5, 0.52, 0.6, 0.77})
    {
        for (const wallSurface& body : {cube(4), quadCube(4)})
        {
            wallSurface surface(body);
            repairSteps steps;
            cutSurface(surface, lid(height), steps);

            EXPECT_TRUE(findWallDefects(surface, true).empty());
            EXPECT_EQ(surface.patchIDs.size(), surface.faces.size());
            EXPECT_EQ(steps.last().count > 0, true);

            scalar top = 0;
            for (const edge& e : outline(surface.faces))
            {
                EXPECT_EQ(surface.points[e.start()].z(), height);
                top += e.mag(surface.points);
            }
            EXPECT_NEAR(top, 4, 1e-12);

            // Of quadrilaterals near to the plane there are half
            EXPECT_NEAR(volumeTo(surface, point(0, 0, height)), height, 0.02);
        }
    }
}


TEST(cutSurface, leavesNoSlivers)
{
    // The points at z = 0.5 are a little below the plane
    wallSurface surface(cube(4));
    repairSteps steps;
    cutSurface(surface, lid(0.5 + 1e-7), steps);

    EXPECT_GT(leastHeight(surface), 0.3);
    EXPECT_EQ(outline(surface.faces).size(), 16);
    EXPECT_EQ(steps.size(), 2);
    EXPECT_EQ(steps[0].count, 16);
}


TEST(cutSurface, leavesALowPartInFrontOfThePlane)
{
    // All points in front of the plane are near to it
    wallSurface surface(cube(1));
    repairSteps steps;
    cutSurface(surface, lid(0.2), steps);

    EXPECT_TRUE(findWallDefects(surface, true).empty());
    EXPECT_NEAR(volumeTo(surface, point(0, 0, 0.2)), 0.2, 1e-12);
}


TEST(cutSurface, keepsABorderOnItsPlane)
{
    // Two planes at 60 degrees, which meet in the middle of a body whose points
    // near to the second cut are on the border of the first
    List<sidePatch> planes(2, lid(0.5));
    planes[1].origin = point(0.3, 0, 0.5);
    planes[1].normal = vector(::sqrt(0.75), 0, 0.5);
    wallSurface surface(cube(7));
    repairSteps steps;
    for (const sidePatch& plane : planes)
    {
        cutSurface(surface, plane, steps, planes);
    }

    EXPECT_TRUE(findWallDefects(surface, true).empty());
    for (const edge& e : outline(surface.faces))
    {
        EXPECT_TRUE
        (
            anyOf(planes, [&](const sidePatch& plane)
            {
                return plane.hasEdge
                (
                    surface.points[e.start()], surface.points[e.end()], 1e-12
                );
            })
        );
    }
}


//- The border that is left of a body below a height, and of the same body, 2
//  higher, above that height and 2
static std::pair<pointField, pointField> bordersAt
(
    const scalar height,
    const word& type
)
{
    wallSurface body(sphere(4, 0.3));
    for (point& x : body.points)
    {
        x = rotation() & x;
    }
    const auto borderOf = [&](const vector& move, const scalar way)
    {
        wallSurface surface(translated(body, move));
        sidePatch plane(lid(height + move.z()));
        plane.normal *= way;
        plane.type = type;
        repairSteps steps;
        cutSurface(surface, plane, steps);
        labelHashSet points;
        for (const edge& e : outline(surface.faces))
        {
            points.insert(e);
        }

        return pointField(surface.points, points.sortedToc());
    };

    return {borderOf(vector::zero, 1), borderOf(vector(0, 0, 2), -1)};
}


TEST(cutSurface, isTheSameOnBothSidesOfACyclicPlane)
{
    const auto isSame = [](const std::pair<pointField, pointField>& borders)
    {
        const labelList images
        (
            imagesAmong
            (
                borders.second, borders.first,
                rigidMotion{vector(0, 0, 2), tensor::I, false}, 1e-9
            )
        );

        return borders.first.size() == borders.second.size()
            && !images.found(-1);
    };

    // At other planes a point may be put on the plane on one side alone
    label nOthers = 0;
    for (scalar height = 0.2; height < 0.29; height += 0.005)
    {
        EXPECT_TRUE(isSame(bordersAt(height, "cyclic"))) << height;
        nOthers += !isSame(bordersAt(height, "patch"));
    }
    EXPECT_GT(nOthers, 0);
}


TEST(removeCavities, closedByAPlane)
{
    const wallSurface inner(translated(cube(2, 0.5), vector(0.25, 0.25, 0.25)));
    wallSurface surface(merge(cube(4), reversed(inner)));
    repairSteps steps;
    cutSurface(surface, lid(0.5), steps);
    ASSERT_NEAR(volumeTo(surface, point(0, 0, 0.5)), 0.5 - 0.0625, 1e-12);

    const List<sidePatch> planes(1, lid(0.5));
    scalar volume = 0;
    EXPECT_EQ(removeCavities(surface, planes, volume).size(), 1);
    EXPECT_NEAR(volume, 0.0625, 1e-12);
    EXPECT_NEAR(volumeTo(surface, point(0, 0, 0.5)), 0.5, 1e-12);
    EXPECT_EQ(removeCavities(surface, planes, volume).size(), 0);
}


TEST(removeCavities, bodiesThatAreOrientedInwardsStay)
{
    // Beside the cube, with its normals inwards
    const wallSurface beside(translated(cube(2, 0.5), vector(2, 0, 0)));
    wallSurface surface(merge(cube(4), reversed(beside)));
    const label nFaces = surface.faces.size();
    scalar volume = 0;
    EXPECT_EQ
    (
        removeCavities(surface, List<sidePatch>(1, lid(2)), volume).size(), 0
    );
    EXPECT_EQ(surface.faces.size(), nFaces);
    EXPECT_EQ(volume, 0);
}


// ************************************************************************* //
