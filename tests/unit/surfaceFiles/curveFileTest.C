/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "curveFile.H"
#include "mathematicalConstants.H"
#include "planarWall.H"
#include "surfaceFiles.H"
#include "unitConversion.H"

using namespace Foam;
using namespace Foam::testSurfaces;

typedef surfaceFiles curveFiles;

namespace
{

//- The largest turn between two edges of a curve, without the corners [rad]
scalar largestTurn(const planeCurve& curve, const scalar corner)
{
    scalar largest = 0;
    const List<vector2D>& x = curve.points;
    for (label i = curve.isClosed ? 0 : 1; i < curve.nEdges(); ++i)
    {
        const vector2D a(x[i] - x[x.rcIndex(i)]);
        const vector2D b(x[x.fcIndex(i)] - x[i]);
        const scalar turn =
            std::atan2(mag(a.x()*b.y() - a.y()*b.x()), a & b);
        largest = turn < corner ? max(largest, turn) : largest;
    }

    return largest;
}


planeCurve circle(const label n, const scalar radius)
{
    planeCurve curve;
    for (label i = 0; i < n; ++i)
    {
        const scalar a = i*constant::mathematical::twoPi/n;
        curve.points.append(radius*vector2D(std::cos(a), std::sin(a)));
    }

    return curve;
}

} // End anonymous namespace

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_F(curveFiles, aerofoilsAreClosed)
{
    const List<planeCurve> curves
    (
        readCurveFile
        (
            file
            (
                "a.dat",
                std::string
                (
                    "NACA 0012 flapped\n1 0.01\n0.5 0.1\n0 0\n0.5 -0.1\n"
                    "1 -0.01\n\n1.1 0\n1.2 0.05\n1.2 -0.05\n1.1 0\n"
                )
            )
        )
    );

    ASSERT_EQ(curves.size(), 2);
    EXPECT_TRUE(curves[0].isClosed);
    EXPECT_EQ(curves[0].nEdges(), 5);
    EXPECT_TRUE(curves[1].isClosed);
    EXPECT_EQ(curves[1].nEdges(), 3);
}


TEST_F(curveFiles, bothHalvesOfLednicerAreOneCurve)
{
    const List<planeCurve> curves
    (
        readCurveFile
        (
            file
            (
                "a.dat",
                std::string
                (
                    "name\n  3.  3.\n\n0 0\n0.5 0.1\n1 0\n\n"
                    "0 0\n0.5 -0.1\n1 0\n"
                )
            )
        )
    );

    ASSERT_EQ(curves.size(), 1);
    EXPECT_EQ(curves[0].points.size(), 4);
    EXPECT_GT(curves[0].area2(), 0);
}


TEST_F(curveFiles, otherCurvesAreOpenUnlessTheyReturn)
{
    const List<planeCurve> curves
    (
        readCurveFile
        (
            file
            (
                "a.csv",
                std::string
                (
                    "x,y\n0,0\n1,0\n\n0,1,7\n1,1,7\n1,2,7\n0,1,7\n"
                )
            )
        )
    );

    ASSERT_EQ(curves.size(), 2);
    EXPECT_FALSE(curves[0].isClosed);
    EXPECT_EQ(curves[0].nEdges(), 1);
    EXPECT_TRUE(curves[1].isClosed);
}


TEST_F(curveFiles, onlyALineOf999sPartsAerofoils)
{
    const std::string text("999,0\n0,999\n-2000,0\n999 999\n1,1\n2,2\n1,2\n");
    const List<planeCurve> points(readCurveFile(file("a.csv", text)));
    const List<planeCurve> aerofoils(readCurveFile(file("a.dat", text)));

    ASSERT_EQ(points.size(), 1);
    EXPECT_EQ(points[0].points.size(), 7);
    ASSERT_EQ(aerofoils.size(), 2);
    EXPECT_EQ(aerofoils[0].points.size(), 3);
    EXPECT_EQ(aerofoils[1].points.size(), 3);
}


TEST_F(curveFiles, filesWithoutCurvesAreRefused)
{
    EXPECT_THROW(readCurveFile("no/such.dat"), Foam::error);
    EXPECT_THROW
    (
        readCurveFile(file("a.dat", std::string("title\n"))), Foam::error
    );
    EXPECT_THROW
    (
        readCurveFile(file("a.dat", std::string("0 0\n1 1\n"))), Foam::error
    );
}


TEST_F(curveFiles, aLoopIsRoundAfterResampling)
{
    const planeCurve made(resampled(circle(24, 2), 1, degToRad(3.0)));

    EXPECT_TRUE(made.isClosed);
    EXPECT_GE(made.points.size(), 120);
    EXPECT_LE(made.points.size(), 140);
    for (const vector2D& x : made.points)
    {
        EXPECT_NEAR(mag(x), 2, 2e-3);
    }
    EXPECT_LT(largestTurn(made, 4), degToRad(4.0));
}


TEST_F(curveFiles, cornersStayAndHaveShortEdges)
{
    planeCurve square;
    square.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const planeCurve made(resampled(square, 0.1, degToRad(3.0)));

    for (const vector2D& x : square.points)
    {
        const label i = made.points.find(x);
        ASSERT_GE(i, 0);
        EXPECT_NEAR(mag(made.points[made.points.fcIndex(i)] - x), 0.01, 2e-3);
    }
    EXPECT_NEAR(made.area2(), 2, 1e-12);
}


TEST_F(curveFiles, aStripStandsBetweenItsPlanes)
{
    planarControls controls;
    controls.normal = vector(0, 1, 0);
    controls.thickness = 0.5;
    const List<planeCurve> curves(1, circle(8, 1));
    const wallSurface strip(stripOn(curves, controls));

    ASSERT_EQ(strip.faces.size(), 8);
    ASSERT_EQ(strip.points.size(), 16);
    for (label i = 0; i < 8; ++i)
    {
        EXPECT_EQ(strip.points[i].y(), 0);
        EXPECT_EQ(strip.points[i + 8], strip.points[i] + vector(0, 0.5, 0));
    }

    const List<sidePatch> planes(planesOf(controls));
    EXPECT_EQ(planes[0].distance(strip.points[0]), 0);
    EXPECT_EQ(planes[1].distance(strip.points[8]), 0);
    EXPECT_EQ(planes[1].type, "empty");
}


TEST_F(curveFiles, aStripFacesTheRightOfItsCurve)
{
    // Down along the second coordinate: the first one falls to the right
    planeCurve curve;
    curve.points = {{0, 1}, {0, 0}};
    curve.isClosed = false;
    planarControls controls;
    controls.thickness = 1;
    for (direction d = 0; d < 3; ++d)
    {
        for (const scalar sign : {-1, 1})
        {
            controls.normal = Zero;
            controls.normal[d] = sign;
            const wallSurface strip
            (
                stripOn(List<planeCurve>(1, curve), controls)
            );
            vector right(Zero);
            right[controls.directions().first()] = -1;
            EXPECT_LT
            (
                mag(strip.faces[0].unitNormal(strip.points) - right), 1e-12
            ) << sign << " along " << int(d);
        }
    }
}


TEST_F(curveFiles, aSectionFacesWhereItsSurfaceFaces)
{
    wallSurface wall;
    wall.points = pointField
    ({
        point(0, 0, -1), point(1, 0, -1), point(1, 0, 1), point(0, 0, 1)
    });
    wall.faces = faceList(1, face({0, 1, 2, 3}));
    wall.patchIDs = labelList(1, label(0));
    wall.patchNames = wordList(1, word("wall"));
    planarControls controls;
    controls.thickness = 1;
    for (const bool isFlipped : {false, true})
    {
        const wallSurface strip(stripOn(wall, controls));
        EXPECT_GT
        (
            strip.faces[0].unitNormal(strip.points)
          & wall.faces[0].unitNormal(wall.points),
            1 - 1e-12
        ) << isFlipped;
        wall.faces[0].flip();
    }
}


TEST_F(curveFiles, aSectionHasTheAreaOfItsPlane)
{
    planarControls controls;
    controls.thickness = 1;
    const wallSurface cube(quadCube(4));
    const scalar side = boundBox(cube.points, false).span().x();
    wallSurface centred(cube);
    centred.points -= boundBox(cube.points, false).midpoint();
    const wallSurface strip(stripOn(centred, controls));

    scalar area = 0;
    for (const face& f : strip.faces)
    {
        area += f.mag(strip.points);
    }
    EXPECT_NEAR(area, 4*side, 1e-12);

    centred.points += vector(0, 0, 2*side);
    EXPECT_THROW(stripOn(centred, controls), Foam::error);
}


// ************************************************************************* //
