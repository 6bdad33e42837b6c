/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "brokenSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

typedef wallDefect::kind kind;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(wallDefects, validSurfacesHaveNone)
{
    EXPECT_TRUE(isValid(cube(4)));
    EXPECT_TRUE(isValid(quadCube(4)));
    EXPECT_TRUE(isValid(sphere(6)));
    EXPECT_TRUE(isValid(quadSphere(6)));
    EXPECT_TRUE(isValid(torus(24, 12, 2, 0.5)));
    EXPECT_TRUE(isValid(lBlock(5)));
    EXPECT_TRUE(isValid(wedgeBlock(6, 10)));
    EXPECT_TRUE(isValid(slitBlock(6, 1e-6)));
    EXPECT_TRUE
    (
        isValid(merge(cube(2), translated(cube(2), vector(1.1, 0, 0))))
    );
}


TEST(wallDefects, validityDoesNotDependOnPlaceAndSize)
{
    for (const scalar scale : {1e-9, 1.0, 1e9})
    {
        wallSurface wall(translated(sphere(5), vector(100, -200, 300)));
        wall.points *= scale;
        EXPECT_TRUE(isValid(wall));
    }
}


TEST(wallDefects, sliversAreNotDegenerate)
{
    wallSurface wall(cube(2));
    wall.points[0] += vector(0, 0, 1e-15);

    EXPECT_EQ(defectOf(wall, kind::degenerateFace).count, 0);
}


TEST(wallDefects, faceWithRepeatedPointIsDegenerate)
{
    wallSurface wall(cube(2));
    wall.faces[7][2] = wall.faces[7][0];

    const wallDefect defect(defectOf(wall, kind::degenerateFace));
    EXPECT_EQ(defect.count, 1);
    ASSERT_EQ(defect.labels.size(), 1);
    EXPECT_EQ(defect.labels[0], 7);
}


TEST(wallDefects, faceWithoutAreaIsDegenerate)
{
    // The point on the middle of its opposite side
    wallSurface wall(hinge(0.5, -1, 0));
    wall.points[2] = point(0.5, 0, 0);

    const wallDefect defect(defectOf(wall, kind::degenerateFace));
    EXPECT_EQ(defect.count, 1);
    EXPECT_EQ(defect.labels[0], 0);
    EXPECT_NEAR(mag(defect.places[0] - point(0.5, 0, 0)), 0, 1e-15);
}


TEST(wallDefects, quadWithStraightCornerIsDegenerate)
{
    // Whichever corner it is
    for (label corner = 0; corner < 4; ++corner)
    {
        wallSurface wall(quadCube(1));
        face& f = wall.faces[3];
        pointField& p = wall.points;
        p[f[corner]] =
            0.5*(p[f[(corner + 1) % 4]] + p[f[(corner + 3) % 4]]);

        const wallDefect defect(defectOf(wall, kind::degenerateFace));
        EXPECT_EQ(defect.count, 1);
        EXPECT_EQ(defect.labels[0], 3);
    }
}


TEST(wallDefects, copyOfAFaceIsADuplicate)
{
    const wallSurface wall(cube(2));
    const face& f = wall.faces[5];
    const wallDefect same(defectOf(with(wall, f), kind::duplicateFace));
    const wallDefect turned
    (
        defectOf
        (
            with(wall, triangleOf(f[0], f[2], f[1])),
            kind::duplicateFace
        )
    );

    EXPECT_EQ(same.count, 1);
    EXPECT_EQ(same.labels[0], wall.faces.size());
    EXPECT_EQ(turned.count, 1);
}


TEST(wallDefects, missingFaceLeavesOpenEdges)
{
    wallSurface wall(cube(2));
    const face missing(wall.faces.last());
    wall.faces.setSize(wall.faces.size() - 1);

    const List<wallDefect> defects(findWallDefects(wall));

    ASSERT_EQ(defects.size(), 1);
    EXPECT_TRUE(defects[0].what == kind::openEdge);
    EXPECT_EQ(defects[0].count, 3);
    ASSERT_EQ(defects[0].places.size(), 3);

    // At the middles of the sides of the hole
    for (const point& place : defects[0].places)
    {
        scalar distance = GREAT;
        forAll(missing, i)
        {
            const point& a = wall.points[missing[i]];
            const point& b = wall.points[missing.nextLabel(i)];
            distance = min(distance, mag(place - 0.5*(a + b)));
        }
        EXPECT_NEAR(distance, 0, 1e-15);
    }
}


TEST(wallDefects, finOnAnEdgeIsNonManifold)
{
    wallSurface wall(cube(1));
    const face f(wall.faces[0]);
    wall.points.append(point(-1, -2, -3));

    const wallDefect defect
    (
        defectOf
        (
            with(wall, triangleOf(f[0], f[1], wall.points.size() - 1)),
            kind::nonManifoldEdge
        )
    );

    EXPECT_EQ(defect.count, 1);
    EXPECT_NEAR
    (
        mag(defect.places[0] - 0.5*(wall.points[f[0]] + wall.points[f[1]])),
        0,
        1e-15
    );
}


TEST(wallDefects, turnedFacesAreFlipped)
{
    wallSurface wall(sphere(4));
    wall.faces[11].flip();
    wall.faces[12].flip();

    const List<wallDefect> defects(findWallDefects(wall));

    ASSERT_EQ(defects.size(), 1);
    EXPECT_TRUE(defects[0].what == kind::flippedFace);
    EXPECT_EQ(defects[0].count, 2);
    EXPECT_EQ(defects[0].labels, labelList({11, 12}));
}


TEST(wallDefects, moebiusStripIsFlippedSomewhere)
{
    // Five triangles around the circle, the last glued to the first turned
    wallSurface wall;
    wall.points = sphere(2).points;
    wall.faces = faceList
    ({
        triangleOf(0, 1, 2),
        triangleOf(1, 3, 2),
        triangleOf(2, 3, 4),
        triangleOf(3, 0, 4),
        triangleOf(4, 0, 1)
    });
    wall.patchIDs = labelList(5, Zero);

    EXPECT_GT(defectOf(wall, kind::flippedFace).count, 0);
}


TEST(wallDefects, conesThatShareTheirTipAreNonManifoldThere)
{
    // Two cubes with one corner in common
    wallSurface wall(merge(cube(2), translated(cube(2), vector(1, 1, 1))));
    label one = -1, other = -1;

    forAll(wall.points, p)
    {
        if (mag(wall.points[p] - point(1, 1, 1)) < 1e-12)
        {
            (one < 0 ? one : other) = p;
        }
    }

    for (face& f : wall.faces)
    {
        for (label& p : f)
        {
            p = (p == other ? one : p);
        }
    }

    const List<wallDefect> defects(findWallDefects(wall));

    ASSERT_EQ(defects.size(), 1);
    EXPECT_TRUE(defects[0].what == kind::nonManifoldPoint);
    EXPECT_EQ(defects[0].count, 1);
    EXPECT_EQ(defects[0].labels[0], one);
    EXPECT_EQ(defects[0].places[0], wall.points[one]);
}


TEST(wallDefects, oneOfThreeBodiesInsideOutIsInverted)
{
    const wallSurface wall
    (
        merge
        (
            merge(cube(2), translated(cube(2), vector(2, 0, 0))),
            translated(reversed(cube(2)), vector(4, 0, 0))
        )
    );
    const List<wallDefect> defects(findWallDefects(wall));

    ASSERT_EQ(defects.size(), 1);
    EXPECT_TRUE(defects[0].what == kind::invertedComponent);
    EXPECT_EQ(defects[0].count, 1);
    EXPECT_EQ(defects[0].labels[0], 2*cube(2).faces.size());
}


TEST(wallDefects, cavityIsNotInverted)
{
    wallSurface cavity(translated(cube(2), vector(-0.5, -0.5, -0.5)));
    cavity.points *= 0.5;

    EXPECT_TRUE(isValid(merge(sphere(6), reversed(cavity))));
    EXPECT_FALSE(isValid(merge(sphere(6), cavity)));
}


TEST(wallDefects, inwardSurfaceOfAnInternalFlowIsValid)
{
    EXPECT_TRUE(isValid(reversed(sphere(4))));
}


TEST(wallDefects, onlyTheFirstTenArePlaced)
{
    wallSurface wall(cube(4));
    wall.faces.setSize(wall.faces.size() - 20);

    const wallDefect defect(defectOf(wall, kind::openEdge));
    EXPECT_GT(defect.count, 10);
    EXPECT_EQ(defect.labels.size(), 10);
    EXPECT_EQ(defect.places.size(), 10);
}


TEST(wallDefects, placesDifferAndIntersectionsHavePartners)
{
    // A large triangle cut by three upright ones
    wallSurface wall;
    wall.points = {point(-9, -9, 0), point(9, -9, 0), point(0, 9, 0)};
    wall.faces = {face({0, 1, 2})};
    for (label i = -1; i <= 1; ++i)
    {
        wall.points.append(point(i, -1, -1));
        wall.points.append(point(i, 1, -1));
        wall.points.append(point(i, 0, 1));
        const label p = wall.points.size();
        wall.faces.append(face({p - 3, p - 2, p - 1}));
    }
    wall.patchIDs = labelList(wall.faces.size(), Zero);
    wall.patchNames = {"all"};

    const wallDefect defect(defectOf(wall, kind::selfIntersection));
    EXPECT_EQ(defect.count, 3);
    ASSERT_EQ(defect.places.size(), 1);
    EXPECT_EQ(defect.labels[0], 0);
    EXPECT_EQ(defect.partners[0], 1);
    EXPECT_NE
    (
        describe(List<wallDefect>(1, defect)).find("face 0 and face 1 at"),
        string::npos
    );
}


TEST(wallDefects, descriptionNamesKindCountPlaceAndAdvice)
{
    wallSurface wall(cube(2));
    wall.faces.setSize(wall.faces.size() - 1);

    const List<wallDefect> defects(findWallDefects(wall));
    const string text(describe(defects));

    EXPECT_NE(text.find("3 open edges"), string::npos);
    EXPECT_NE(text.find("at ("), string::npos);
    EXPECT_NE(text.find(defects[0].advice()), string::npos);
}


// ************************************************************************* //
