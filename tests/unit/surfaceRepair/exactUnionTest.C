/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "unions.H"
#include "mathematicalConstants.H"
#include "stitchSurface.H"
#include "testSurfaces.H"
#include "wallDefects.H"

#include <gtest/gtest.h>

using namespace Foam;
using testSurfaces::cube;
using testSurfaces::merge;
using testSurfaces::translated;

//- The exact union of bodies, some of whose points may be equal
static wallSurface united(wallSurface surface)
{
    repairSteps steps;
    mergeEqualPoints(surface, steps);
    EXPECT_TRUE(isBalanced(surface));
    uniteExactly(surface, steps);

    return surface;
}


//- What uniteBalanced makes of bodies; it has no defects
static wallSurface unitedAndFilled(wallSurface surface)
{
    repairSteps steps;
    mergeEqualPoints(surface, steps);
    EXPECT_TRUE(uniteBalanced(surface, 1e-4, steps).empty());
    EXPECT_TRUE(findWallDefects(surface).empty());

    return surface;
}


static scalar volume(const wallSurface& surface)
{
    return testSurfaces::enclosedVolume(surface);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(exactUnion, openAndDoubledFacesAreNotBalanced)
{
    wallSurface surface(cube(2));
    EXPECT_TRUE(isBalanced(surface));

    const face first(surface.faces.first());
    surface.faces.append(first);
    EXPECT_FALSE(isBalanced(surface));

    surface.faces.setSize(surface.faces.size() - 2);
    EXPECT_FALSE(isBalanced(surface));
}


TEST(exactUnion, overlappingBodies)
{
    const wallSurface surface
    (
        united(merge(cube(3), translated(cube(2), vector(0.6, 0.3, 0.2))))
    );

    EXPECT_TRUE(findContacts(surface).empty());
    EXPECT_TRUE(findWallDefects(surface).empty());
    EXPECT_NEAR(volume(surface), 2 - 0.4*0.7*0.8, 1e-12);
}


TEST(exactUnion, aContactWithPointsThatDifferByRounding)
{
    // The bodies are apart by rounding, and the points of their edges differ
    const wallSurface left(translated(cube(2), vector(-1, -1, -0.5)));
    wallSurface right(translated(cube(2), vector(0, 0, -0.5)));
    for (point& x : right.points)
    {
        x += vector(3e-17, -5e-17, 8e-17);
    }
    const wallSurface surface(unitedAndFilled(merge(left, right)));
    EXPECT_GT(volume(surface), 2 + 1e-9);
    EXPECT_LT(volume(surface), 2.01);
}


TEST(exactUnion, trianglesWhoseAreaIsRoundingLeaveNoHoles)
{
    // A point beside the longest edge of a triangle by one rounding
    for (label i = 0; i < 60; ++i)
    {
        wallSurface surface(translated(cube(1), vector(1, 0, 0)));
        for (point& x : surface.points)
        {
            x = point(2.5, 1.5, 0) + 1.1106009389478*(x - point(2, 1, 0));
        }
        labelList faceOf;
        surface.faces = wallTriangles(surface, faceOf);
        const face f(surface.faces[i % 12]);
        const label k = f.longestEdge(surface.points);
        const label a = f[k];
        const label b = f.nextLabel(k);
        const label c = f.prevLabel(k);
        const label m = surface.points.size();
        const scalar share = (i + 0.4389399061)/60;
        surface.points.append
        (
            surface.points[a] + share*(surface.points[b] - surface.points[a])
        );
        surface.faces[i % 12] = face({a, m, c});
        surface.faces.append(face({m, b, c}));
        surface.faces.append(face({b, m, a}));
        surface.patchIDs = labelList(surface.faces.size(), 0);

        const scalar before = volume(surface);
        EXPECT_NEAR(volume(unitedAndFilled(surface)), before, 1e-12);
    }
}


TEST(exactUnion, bodiesThatTouchInEqualFaces)
{
    const wallSurface surface
    (
        united(merge(cube(2), translated(cube(2), vector(1, 0, 0))))
    );

    EXPECT_TRUE(findWallDefects(surface).empty());
    EXPECT_EQ(surface.faces.size(), 2*(48 - 8));
    EXPECT_NEAR(volume(surface), 2, 1e-12);
}


TEST(exactUnion, bodiesThatTouchInOtherFaces)
{
    const wallSurface surface
    (
        united(merge(cube(3), translated(cube(2), vector(1, 0.3, 0.4))))
    );

    EXPECT_TRUE(findWallDefects(surface).empty());
    EXPECT_NEAR(volume(surface), 2, 1e-12);
}


TEST(exactUnion, bodiesInsideOfOthersAreGone)
{
    const wallSurface inner(translated(cube(2, 0.5), vector(0.2, 0.2, 0.2)));
    const wallSurface touching(translated(cube(2, 0.5), vector(0, 0.2, 0)));

    for (const wallSurface& body : {inner, touching})
    {
        const wallSurface surface(united(merge(cube(3), body)));
        EXPECT_TRUE(findWallDefects(surface).empty());
        EXPECT_NEAR(volume(surface), 1, 1e-12);
    }
}


TEST(exactUnion, bodiesThatAreEqual)
{
    const wallSurface surface(united(merge(cube(2), cube(3))));

    EXPECT_TRUE(findWallDefects(surface).empty());
    EXPECT_NEAR(volume(surface), 1, 1e-12);
}


TEST(exactUnion, voidsBetweenBodiesAreFilled)
{
    wallSurface around;
    for (label i = 0; i < 27; ++i)
    {
        const vector at(i % 3, (i/3) % 3, i/9);
        if (i == 0)
        {
            around = translated(cube(1), at);
        }
        else if (i != 13)
        {
            around = merge(around, translated(cube(1), at));
        }
    }
    const wallSurface surface(united(around));

    EXPECT_TRUE(findWallDefects(surface).empty());
    EXPECT_NEAR(volume(surface), 27, 1e-12);
}


TEST(exactUnion, threeBodiesAroundOneEdge)
{
    const wallSurface surface
    (
        united
        (
            merge
            (
                merge(cube(2), translated(cube(2), vector(1, 0, 0))),
                translated(cube(3), vector(1, 1, 0))
            )
        )
    );

    EXPECT_TRUE(findWallDefects(surface).empty());
    EXPECT_NEAR(volume(surface), 3, 1e-12);
}


TEST(exactUnion, contactsAreFound)
{
    const surfaceContacts alongEdge
    (
        findContacts
        (
            united(merge(cube(2), translated(cube(2), vector(1, 1, 0))))
        )
    );
    EXPECT_EQ(alongEdge.edges.size(), 2);
    EXPECT_EQ(alongEdge.points.size(), 0);

    const surfaceContacts atPoint
    (
        findContacts
        (
            united(merge(cube(2), translated(cube(2), vector(1, 1, 1))))
        )
    );
    EXPECT_EQ(atPoint.edges.size(), 0);
    EXPECT_EQ(atPoint.points.size(), 1);
}


TEST(exactUnion, contactsAreFilled)
{
    for (const vector& by : {vector(1, 1, 0), vector(1, 1, 1)})
    {
        const wallSurface surface
        (
            unitedAndFilled(merge(cube(2), translated(cube(2), by)))
        );

        EXPECT_TRUE(findContacts(surface).empty());
        EXPECT_GT(volume(surface), 2);
        EXPECT_LT(volume(surface), 2.001);
    }
}


TEST(exactUnion, cornerOnAFaceIsFilled)
{
    // A sphere whose lowest point is on the cube
    const wallSurface tip(testSurfaces::sphere(2, 0.3));
    scalar lowest = 0;
    for (const point& x : tip.points)
    {
        lowest = min(lowest, x.z());
    }
    const wallSurface surface
    (
        unitedAndFilled
        (
            merge(cube(3), translated(tip, vector(0.5, 0.4, 1 - lowest)))
        )
    );

    EXPECT_TRUE(findContacts(surface).empty());
    EXPECT_GT(volume(surface), 1);
}


TEST(exactUnion, roundedFacesDoNotIntersect)
{
    // A cylinder whose rim touches an edge of a cube in a point; another body
    // sets the size of what fills the contact
    using constant::mathematical::twoPi;
    const label n = 12;
    List<vector2D> circle(n);
    forAll(circle, i)
    {
        const scalar angle = twoPi*i/n;
        circle[i] = 0.5*vector2D(Foam::cos(angle), Foam::sin(angle));
    }
    circle[3*n/4] = vector2D(0, -0.5);

    const vector half(vector::uniform(0.5));
    wallSurface surface
    (
        merge
        (
            translated(translated(cube(3), -half), vector(0, 1, 1)),
            translated
            (
                testSurfaces::extruded(circle, 1, 0.5), vector(0, 2, -0.5)
            )
        )
    );
    unitedAndFilled
    (
        merge(surface, translated(cube(1, 0.5), vector(1, 0.6, -0.5)))
    );
}

// ************************************************************************* //
