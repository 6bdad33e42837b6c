/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readWallSurface.H"
#include "surfacePart.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

namespace
{

//- A square of two triangles with a copy of the diagonal's points, which is off
//  by a distance [m]
wallSurface torn(const scalar distance)
{
    wallSurface wall;
    wall.points =
    {
        point(0, 0, 0), point(1, 0, 0), point(1, 1, 0), point(0, 1, 0),
        point(0, 0, distance), point(1, 1, distance)
    };
    wall.faces = {face({0, 1, 2}), face({4, 5, 3})};
    wall.patchIDs = {0, 0};

    return wall;
}

} // End anonymous namespace


TEST(mergeNearPoints, facesShareThePointsWithinTheTolerance)
{
    wallSurface wall(torn(1e-5));
    wallReading reading;
    mergeNearPoints(wall, 1e-4, reading);

    EXPECT_EQ(wall.faces[1], face({wall.faces[0][0], wall.faces[0][2], 3}));
    EXPECT_EQ(reading.mergedPoints, 2);
    EXPECT_EQ(reading.collapsedFaces, 0);
}


TEST(mergeNearPoints, pointsBeyondTheToleranceAreCountedOnly)
{
    wallSurface wall(torn(1e-7));
    const faceList faces(wall.faces);
    wallReading reading;
    mergeNearPoints(wall, 1e-9, reading);

    EXPECT_EQ(wall.faces, faces);
    EXPECT_EQ(reading.mergedPoints, 0);
    EXPECT_EQ(reading.nearPoints, 2);
}


TEST(mergeNearPoints, pointsOfClosedSurfacesMayStay)
{
    // Both cubes have the point (1, 1, 1); the triangles have three each
    wallSurface wall(cube(1));
    wallSurface other(cube(1));
    other.points += vector::uniform(1);
    appendSurface(other, labelList(), wall);
    const wallSurface closed(wall);
    appendSurface(torn(0), labelList(), wall);
    wallReading reading;
    mergeNearPoints(wall, 0, reading, true);

    EXPECT_EQ(reading.mergedPoints, 2);
    EXPECT_EQ
    (
        faceList(SubList<face>(wall.faces, closed.faces.size())), closed.faces
    );
}


TEST(mergeNearPoints, facesThatLoseAnEdgeGo)
{
    wallSurface wall(torn(0));
    wall.faces.append(face({0, 4, 1}));
    wall.patchIDs.append(1);
    wallReading reading;
    mergeNearPoints(wall, 1e-9, reading);

    EXPECT_EQ(wall.faces.size(), 2);
    EXPECT_EQ(wall.patchIDs, labelList({0, 0}));
    EXPECT_EQ(reading.collapsedFaces, 1);
}


// ************************************************************************* //
