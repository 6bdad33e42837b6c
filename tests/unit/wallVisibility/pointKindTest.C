/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pointKind.H"
#include "saddles.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

typedef FixedList<label, nPointKinds> kindCounts;


static kindCounts kindsOf(const wallSurface& wall)
{
    const wallAddressing addressing(makeWallAddressing(wall));

    return countKinds
    (
        kindsOfPoints(wall, addressing, makeWallVisibility(wall, addressing))
    );
}


static wallSurface turnedInside(wallSurface wall)
{
    for (face& f : wall.faces)
    {
        f.flip();
    }

    return wall;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(countKinds, cube)
{
    // On each side 3 x 3 points between the edges
    EXPECT_EQ(kindsOf(testSurfaces::cube(4)), kindCounts({54, 44, 0, 0, 0}));
    EXPECT_EQ
    (
        kindsOf(testSurfaces::quadCube(4)), kindCounts({54, 44, 0, 0, 0})
    );
}


TEST(countKinds, cubeFromInside)
{
    EXPECT_EQ
    (
        kindsOf(turnedInside(testSurfaces::cube(4))),
        kindCounts({54, 0, 44, 0, 0})
    );
}


TEST(countKinds, endsOfConcaveEdgesAreSaddles)
{
    const kindCounts kinds(kindsOf(testSurfaces::lBlock(4)));

    EXPECT_EQ(kinds[int(pointKind::saddle)], 2);
    EXPECT_EQ(kinds[int(pointKind::concave)], 3);
    EXPECT_EQ(kinds[int(pointKind::empty)], 0);
}


TEST(countKinds, emptyConesAreCountedAsSuch)
{
    const wallSurface wall(testSurfaces::screw(point(3, 4, 5)));
    const wallAddressing addressing(makeWallAddressing(wall));

    EXPECT_EQ
    (
        kindsOf(wall)[int(pointKind::empty)],
        makeWallVisibility(wall, addressing).emptyCones().size()
    );
    EXPECT_GT(kindsOf(wall)[int(pointKind::empty)], 0);
}


TEST(countKinds, smoothEdgesAreFlat)
{
    const wallSurface wall(testSurfaces::sphere(8));

    EXPECT_EQ(kindsOf(wall)[int(pointKind::flat)], wall.points.size());
}


// ************************************************************************* //
