/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "unions.H"
#include "surfaceMeasures.H"
#include "testSurfaces.H"
#include "wallDefects.H"
#include "wallVisibility.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The screw about the origin, its point there divided: into a on the x axis,
//  and b on the y axis
static wallSurface splitScrew(const scalar distance)
{
    wallSurface wall(screw(Zero));
    const auto labelOf = [&](const point& x)
    {
        label nearest = 0;
        forAll(wall.points, p)
        {
            nearest = !p || mag(wall.points[p] - x)
              < mag(wall.points[nearest] - x) ? p : nearest;
        }
        return nearest;
    };
    const label a = labelOf(Zero);
    const label b = wall.points.size();
    const label up = labelOf({0, 0, 1});
    const label back = labelOf({0, -1, 0});
    wall.points[a] = point(distance, 0, 0);
    wall.points.append(point(0, distance, 0));

    DynamicList<face> added;
    for (face& f : wall.faces)
    {
        const label i = f.find(a);
        if (i >= 0 && !f.found(labelOf({1, 0, 0})))
        {
            f[i] = b;
        }
        for (const label p : {up, back})
        {
            if (i >= 0 && f[i] == a && f.nextLabel(i) == p)
            {
                added.append(face({p, a, b}));
            }
            if (i >= 0 && f[i] == a && f.prevLabel(i) == p)
            {
                added.append(face({a, p, b}));
            }
        }
    }

    wallSurface triangles(triangulated(wall));
    triangles.faces.append(added);
    triangles.patchIDs.append(labelList(added.size(), 0));

    return triangles;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(removeSlivers, flipsAreNotTakenBack)
{
    // Low triangles on a step between large ones
    wallSurface surface;
    surface.points = pointField
    ({
        {0, 0, 0}, {-0.1473, -0.1830, 0.0858}, {-0.6030, -0.1830, 0.4169},
        {-0.1656, -0.1710, 0.1694}, {-0.2286, -0.1219, 0.4725},
        {-0.2253, -0.1316, 0.4418}, {0.5056, 0.0529, -0.3612},
        {-2.5459, 6.6491, 2.6181}, {-1, -4, -4}
    });
    surface.faces = faceList
    ({
        face({0, 7, 2}), face({0, 2, 1}), face({0, 6, 7}), face({0, 5, 4}),
        face({0, 3, 5}), face({0, 1, 3}), face({0, 4, 6}), face({1, 2, 3}),
        face({3, 2, 5}), face({5, 2, 4}), face({2, 7, 8}), face({7, 6, 8}),
        face({6, 4, 8}), face({4, 2, 8})
    });

    EXPECT_GT(removeSlivers(0.08, surface), 0);
    EXPECT_EQ(removeSlivers(0.08, surface), 0);
}


TEST(removeSlivers, whatCannotGoStaysAndTheRestGoes)
{
    // A plate much thinner than the length would lose its thickness. A point
    // of the ball, above, is near to another one.
    wallSurface plate(cube(2));
    for (point& x : plate.points)
    {
        x.z() *= 1e-3;
    }
    wallSurface ball(translated(sphere(3), {0, 0, 5}));
    const face f(ball.faces[0]);
    const label added = ball.points.size();
    const point x(ball.points[f[0]]);
    const point near(x + 5e-3*(f.centre(ball.points) - x));
    ball.points.append(near);
    ball.faces[0] = face({added, f[1], f[2]});
    ball.faces.append(face({f[0], f[1], added}));
    ball.faces.append(face({f[0], added, f[2]}));
    ball.patchIDs.append(labelList(2, 0));

    wallSurface both(merge(plate, ball));
    EXPECT_GT(removeSlivers(0.01, both), 0);
    EXPECT_TRUE(findWallDefects(both).empty());
    EXPECT_FALSE(both.points.found(near));
    EXPECT_GT
    (
        measuresOf(both).volume, measuresOf(ball).volume + 0.3e-3
    );
}


TEST(removeSlivers, noPointLosesItsDirections)
{
    // Without the edge from a to b there is one point, the point of the screw,
    // and no direction is in front of all its faces
    const wallSurface wall(splitScrew(1e-3));
    ASSERT_TRUE(findWallDefects(wall).empty());
    ASSERT_TRUE(pointsWithEmptyCones(wall).empty());

    wallSurface result(wall);
    removeSlivers(0.01, result);
    EXPECT_TRUE(pointsWithEmptyCones(result).empty());
    EXPECT_EQ(result.points.size(), wall.points.size());
}


TEST(removeSlivers, aThinSpikeGoes)
{
    // A needle 2 m long and about 1e-3 m thick on a face of a ball
    wallSurface spiked(sphere(3));
    const scalar volume = measuresOf(spiked).volume;
    const face f(spiked.faces[0]);
    const point centre(f.centre(spiked.points));
    const vector normal(f.unitNormal(spiked.points));
    pointField corners(3);
    forAll(corners, k)
    {
        corners[k] = centre + 2e-3*(spiked.points[f[k]] - centre);
    }
    const label first = spiked.points.size();
    spiked.points.append(corners);
    spiked.points.append(point(centre + 2*normal));
    const face g({first, first + 1, first + 2});

    spiked.faces[0] = face({g[0], g[1], first + 3});
    spiked.faces.append(face({g[1], g[2], first + 3}));
    spiked.faces.append(face({g[2], g[0], first + 3}));
    for (label k = 0; k < 3; ++k)
    {
        const label next = (k + 1) % 3;
        spiked.faces.append(face({f[k], f[next], g[next]}));
        spiked.faces.append(face({f[k], g[next], g[k]}));
    }
    spiked.patchIDs = labelList(spiked.faces.size(), 0);
    ASSERT_TRUE(findWallDefects(spiked).empty());

    EXPECT_GT(removeSlivers(0.01, spiked), 0);
    EXPECT_FALSE(spiked.points.found(centre + 2*normal));
    EXPECT_TRUE(findWallDefects(spiked).empty());
    EXPECT_NEAR(measuresOf(spiked).volume, volume, 1e-5);
}


// ************************************************************************* //
