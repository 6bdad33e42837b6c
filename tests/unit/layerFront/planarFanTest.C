/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "openSurfaces.H"
#include "planarFan.H"
#include "planarWall.H"
#include "testLayers.H"
#include "unitConversion.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace testSurfaces;

namespace
{

//- A strip on a closed curve, between sides of type empty
wallSurface stripOf(const List<vector2D>& points)
{
    planeCurve curve;
    curve.points = points;
    planarControls controls;
    controls.thickness = 1;

    return endedOn
    (
        stripOn(List<planeCurve>(1, curve), controls), planesOf(controls)
    );
}


//- A wedge with a sharp edge at the origin, whose sides make this angle [deg]
wallSurface wedge(const scalar degrees)
{
    const scalar y = ::tan(degToRad(degrees/2));

    return stripOf({{0, 0}, {-1, y}, {-3, 2}, {-3, -2}, {-1, -y}});
}


//- Columns on points at the origin, in each plane
label nColumnsAtEdge(const layerFront& front)
{
    label n = 0;
    for (const label p : front.wallPoints)
    {
        const point& x = front.surface.points[p];
        n += mag(x.x()) + mag(x.y()) < 1e-12;
    }

    return n;
}

} // End anonymous namespace

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(planarFan, columnsAreAtMost20DegreesApart)
{
    for (const scalar angle : {1.0, 15.0, 65.0, 95.0, 125.0})
    {
        const layerFront front(frontOf(wedge(angle), 75));
        const label n = ::ceil((180 - angle)/frontControls::fanAngle) + 1;
        EXPECT_EQ(nColumnsAtEdge(front), 2*n) << angle;
    }
}


TEST(planarFan, itGoesFromNormalToNormal)
{
    const wallSurface wall(wedge(30));
    const wallAddressing addressing(makeWallAddressing(wall));
    const wallVisibility visibility(makeWallVisibility(wall, addressing));
    label p = 0;
    while (mag(wall.points[p].x()) > 1e-12)
    {
        ++p;
    }
    const normalSectors fan
    (
        makePlanarFan(wall, addressing, visibility, p)
    );

    ASSERT_EQ(fan.axes.size(), 9);
    const vectorField& normals = visibility.cornerNormals[p];
    EXPECT_LT(mag(fan.axes.first() - normals[0]), 1e-12);
    EXPECT_LT(mag(fan.axes.last() - normals[1]), 1e-12);
    EXPECT_LT(mag(fan.axes[4] - vector(1, 0, 0)), 1e-12);
    EXPECT_EQ(fan.sector(0), 0);
    EXPECT_EQ(fan.sector(1), 8);
}


TEST(planarFan, eachColumnSeesItsPartOfTheFan)
{
    const layerFront front(frontOf(wedge(30), 75));

    EXPECT_TRUE(front.visibility.emptyCones().empty());
    for (label f = front.nWallFaces; f < front.surface.faces.size(); ++f)
    {
        EXPECT_EQ(front.surface.faces[f].size(), 4);
        EXPECT_EQ(front.surface.patchIDs[f], -1);
    }
}


TEST(planarFan, noneInAConcaveCorner)
{
    // An L; its only concave corner is at the origin
    const wallSurface wall
    (
        stripOf({{0, 0}, {0, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 0}})
    );

    EXPECT_EQ(nColumnsAtEdge(frontOf(wall, 75)), 2);
}


TEST(planarFan, noneOnAWallThatIsNotPlanar)
{
    const wallSurface half(endedOn(halfCube(4), halfPlanes()));
    const wallAddressing addressing(makeWallAddressing(half));
    forAll(half.points, p)
    {
        EXPECT_EQ(pointAcross(half, addressing, p), -1);
    }
}


// ************************************************************************* //
