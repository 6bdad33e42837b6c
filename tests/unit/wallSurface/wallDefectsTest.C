/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "testSurfaces.H"
#include "wallDefects.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

typedef wallDefect::kind kind;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The defect of the kind; with count 0 where there is none
static wallDefect defectOf(const wallSurface& wall, const kind what)
{
    for (const wallDefect& defect : findWallDefects(wall))
    {
        if (defect.what == what)
        {
            return defect;
        }
    }

    return wallDefect();
}


static bool isValid(const wallSurface& wall)
{
    return findWallDefects(wall).empty();
}


static face triangle(const label a, const label b, const label c)
{
    return face(labelList({a, b, c}));
}


//- With one more face
static wallSurface with(const wallSurface& wall, const face& f)
{
    wallSurface result(wall);
    result.faces.append(f);
    result.patchIDs.append(0);

    return result;
}


//- Two triangles that share the edge from the origin to (1 0 0); the given
//  point is the third of the second
static wallSurface hinge(const scalar x, const scalar y, const scalar z)
{
    wallSurface wall;
    wall.points = pointField
    ({
        point(0, 0, 0), point(1, 0, 0), point(0.5, 1, 0), point(x, y, z)
    });
    wall.faces = faceList({triangle(0, 1, 2), triangle(1, 0, 3)});
    wall.patchIDs = labelList(2, Zero);
    wall.patchNames = wordList(1, word("wall"));

    return wall;
}

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
            with(wall, triangle(f[0], f[2], f[1])),
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
            with(wall, triangle(f[0], f[1], wall.points.size() - 1)),
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
        triangle(0, 1, 2),
        triangle(1, 3, 2),
        triangle(2, 3, 4),
        triangle(3, 0, 4),
        triangle(4, 0, 1)
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


TEST(wallDefects, overlappingBodiesIntersect)
{
    const wallSurface wall
    (
        merge(cube(1), translated(cube(1), vector(0.5, 0.6, 0.7)))
    );
    const wallDefect defect(defectOf(wall, kind::selfIntersection));

    EXPECT_GT(defect.count, 0);
    EXPECT_EQ(findWallDefects(wall).size(), 1);
}


TEST(wallDefects, touchingBodiesIntersect)
{
    // Face on face, point on point
    for (const vector& by : {vector(1, 0, 0), vector(1, 1, 1)})
    {
        const wallSurface wall(merge(cube(1), translated(cube(1), by)));
        EXPECT_GT(defectOf(wall, kind::selfIntersection).count, 0);
    }
}


TEST(wallDefects, coincidentBodiesIntersect)
{
    const wallSurface wall(merge(sphere(3), sphere(3)));

    EXPECT_GE
    (
        defectOf(wall, kind::selfIntersection).count,
        wall.faces.size()/2
    );
}


TEST(wallDefects, nearestBodiesDoNotIntersect)
{
    // One unit in the last place apart
    const scalar apart = 1 + 2.3e-16;

    EXPECT_TRUE
    (
        isValid(merge(cube(2), translated(cube(2), vector(apart, 0, 0))))
    );
}


TEST(wallDefects, foldedNeighboursIntersect)
{
    EXPECT_EQ(defectOf(hinge(0.4, 0.5, 0), kind::selfIntersection).count, 1);
    EXPECT_EQ(defectOf(hinge(0.5, 1e-9, 0), kind::selfIntersection).count, 1);

    EXPECT_EQ(defectOf(hinge(0.4, -0.5, 0), kind::selfIntersection).count, 0);
    EXPECT_EQ
    (
        defectOf(hinge(0.4, 0.5, 1e-12), kind::selfIntersection).count,
        0
    );
}


TEST(wallDefects, facesThatCutBeyondACommonPointIntersect)
{
    wallSurface wall(hinge(0.5, -1, 0));
    wall.points.append(point(0.5, 0.2, -1));
    wall.points.append(point(0.5, 0.2, 1));
    wall.faces = faceList({triangle(0, 1, 2), triangle(0, 4, 5)});

    EXPECT_EQ(defectOf(wall, kind::selfIntersection).count, 1);

    // The same on the other side of the common point
    wall.points[4].x() = wall.points[5].x() = -0.5;
    EXPECT_EQ(defectOf(wall, kind::selfIntersection).count, 0);
}


TEST(wallDefects, polygonFoldedOntoItselfIntersects)
{
    wallSurface wall;
    wall.points = pointField
    ({
        point(0, 0, 0), point(2, -1, 0), point(2, 1, 0), point(-0.5, 0.5, 0)
    });
    wall.faces = faceList(1, face(labelList({0, 1, 2, 3})));
    wall.patchIDs = labelList(1, Zero);
    EXPECT_EQ(defectOf(wall, kind::selfIntersection).count, 0);

    // Re-entrant, so that the fan from the first point folds
    wall.points[3] = point(1.9, 0, 0);
    EXPECT_EQ(defectOf(wall, kind::selfIntersection).count, 1);
}


TEST(wallDefects, pairOfWarpedQuadsCountsOnce)
{
    const wallSurface wall
    (
        merge(quadCube(1), translated(quadCube(1), vector(0.5, 0.6, 0.7)))
    );
    const label nPairs = defectOf(wall, kind::selfIntersection).count;

    // Three sides of one cube each meet two or three of the other
    EXPECT_EQ(nPairs, 6);
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
