/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boundBox.H"
#include "givenSurface.H"
#include "testSurfaces.H"
#include "unitConversion.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(givenSurface, linesOfACubeAreItsEdges)
{
    const label n = 3;
    const wallSurface surface(cube(n));
    const givenSurface given(surface, 30, 1e-3);

    EXPECT_EQ(given.lines().size(), 12*n);

    label nCorners = 0;
    label nOnLines = 0;
    forAll(surface.points, p)
    {
        nCorners += given.isCorner(p);
        nOnLines += given.isOnLine(p);
    }
    EXPECT_EQ(nCorners, 8);
    EXPECT_EQ(nOnLines, 8 + 12*(n - 1));
}


TEST(givenSurface, aSmoothSurfaceHasNoLinesButBordersOfPatches)
{
    wallSurface surface(sphere(8));
    EXPECT_EQ(givenSurface(surface, 30, 1e-3).lines().size(), 0);

    surface.patchNames = {"north", "south"};
    forAll(surface.faces, facei)
    {
        const point x(surface.faces[facei].centre(surface.points));
        surface.patchIDs[facei] = x.z() > 0 ? 0 : 1;
    }
    EXPECT_EQ(givenSurface(surface, 30, 1e-3).lines().size(), 4*8);
}


TEST(givenSurface, creasesThatNewEdgesWouldRoundOffAreLines)
{
    // A prism of 24 sides of the width 0.052: edges of 0.02 across a crease of
    // 15 degrees are 0.0013 away from it
    const label n = 24;
    List<vector2D> corners(n);
    forAll(corners, i)
    {
        const scalar angle = degToRad(scalar(360*i)/n);
        corners[i] = 0.2*vector2D(::cos(angle), ::sin(angle));
    }
    const wallSurface surface(extruded(corners, 0.7, 10));
    const auto nLines = [&](const scalar deviation, const scalar maxEdge)
    {
        return givenSurface(surface, 30, deviation, maxEdge).lines().size();
    };

    EXPECT_EQ(nLines(1e-3, 0), 2*n);
    EXPECT_EQ(nLines(1e-3, 0.02), 3*n);
    EXPECT_EQ(nLines(2e-3, 0.02), 2*n);

    // Edges of 0.1 go over several of them
    EXPECT_EQ(nLines(1e-3, 0.1), 2*n);
}


TEST(givenSurface, searchesDoNotCrossLines)
{
    const wallSurface surface(cube(4));
    const givenSurface given(surface, 30, 1e-3);
    const vectorField normals(surface.faceNormals());
    label top = 0;
    while (normals[top].z() < 0.9)
    {
        ++top;
    }

    // Beside the cube: the nearest point of its top is on the top's edge
    point y;
    const label found = given.findFace(top, point(1.5, 0.4, 0.2), 2, y);

    EXPECT_GT(normals[found].z(), 0.9);
    EXPECT_NEAR(mag(y - point(1, 0.4, 1)), 0, 1e-12);
}


TEST(givenSurface, searchesFindTheOtherLegOfAnL)
{
    const wallSurface surface(lBlock(4));
    const givenSurface given(surface, 30, 1e-3);
    const vectorField normals(surface.faceNormals());
    const boundBox box(surface.points, false);

    // Between any two faces on one plane the search finds the other
    const auto isOnTop = [&](const label facei)
    {
        return normals[facei].z() > 0.9;
    };
    for (label from = 0; from < surface.faces.size(); from += 7)
    {
        for (label to = 0; isOnTop(from) && to < surface.faces.size(); ++to)
        {
            if (isOnTop(to))
            {
                const point x(surface.faces[to].centre(surface.points));
                point y;
                given.findFace(from, x, box.mag(), y);
                EXPECT_NEAR(mag(x - y), 0, 1e-12);
            }
        }
    }
}


TEST(givenSurface, lengthsFollowTheCurvature)
{
    const scalar R = 2;
    const scalar deviation = 1e-3;
    const wallSurface surface(sphere(24, R));
    const givenSurface given(surface, 30, deviation);
    const scalarField lengths(given.lengths());
    const scalar expected = Foam::sqrt(6*deviation*R);

    // The faces are not regular: a curvature from pairs of these scatters
    EXPECT_NEAR(average(lengths), expected, 0.35*expected);
    EXPECT_GT(min(lengths), 0.5*expected);
}


TEST(givenSurface, aSliverHasTheNormalOfItsNeighbour)
{
    // Upright on the diagonal of a cube's face, and much too narrow to see
    wallSurface surface(cube(1));
    const face f(surface.faces[0]);
    label k = 0;
    while (f.faceEdge(k).mag(surface.points) < 1.1)
    {
        ++k;
    }
    const label a = f[k];
    const label b = f.nextLabel(k);
    const label c = f.prevLabel(k);
    const label p = surface.points.size();
    surface.points.append
    (
        0.5*(surface.points[a] + surface.points[b])
      + 1e-7*surface.faceNormals()[0]
    );
    surface.faces[0] = face({a, p, c});
    surface.faces.append(face({p, b, c}));
    surface.faces.append(face({a, b, p}));
    surface.patchIDs.append(labelList(2, surface.patchIDs[0]));

    const vectorField normals(surface.faceNormals());
    EXPECT_LT(mag(normals.last() & normals[0]), 0.1);
    EXPECT_EQ(givenSurface(surface, 30, 1e-3).lines().size(), 12);
    EXPECT_GT(givenSurface(surface, 30, 1e-9).lines().size(), 12);
}


// ************************************************************************* //
