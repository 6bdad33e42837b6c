/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallPointsError.H"
#include "openSurfaces.H"
#include "unitConversion.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The advice on all points of a room whose vent is in the middle of its
//  ceiling, or all of it
static std::string adviceOnRoom(const scalar width)
{
    wallSurface room(testSurfaces::reversed(testSurfaces::cube(3)));
    room.patchNames = wordList({"room", "vent"});
    room.patchIDs.setSize(room.faces.size());

    forAll(room.faces, facei)
    {
        const vector c(room.faces[facei].centre(room.points));
        room.patchIDs[facei] =
            c.z() > 1 - SMALL
         && mag(c.x() - 0.5) < 0.5*width && mag(c.y() - 0.5) < 0.5*width;
    }

    const wallSurface wall(testSurfaces::endedOn(room, {"vent"}));

    return adviceOnPoints
    (
        wall, makeWallAddressing(wall), identity(wall.points.size())
    );
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(adviceOnPoints, namesPatchesThatAreFlushWithTheWall)
{
    EXPECT_NE
    (
        adviceOnRoom(0.34).find("layers.patches { vent { type patch; } }"),
        std::string::npos
    );
}


TEST(adviceOnPoints, namesNoPatchesAtAnAngle)
{
    EXPECT_EQ(adviceOnRoom(1), "Round off these corners in the surface.");
}


TEST(adviceOnPoints, namesTheSidePatchThatTheWallMeetsAtAnObtuseAngle)
{
    // The ceiling rises from all sides to the vent: 150 degrees in the fluid
    wallSurface room(testSurfaces::reversed(testSurfaces::cube(3)));
    room.patchNames = wordList({"room", "vent"});

    forAll(room.faces, facei)
    {
        const vector c(room.faces[facei].centre(room.points));
        room.patchIDs[facei] =
            c.z() > 1 - SMALL
         && mag(c.x() - 0.5) < 0.2 && mag(c.y() - 0.5) < 0.2;
    }
    for (point& x : room.points)
    {
        const bool isOnVent = mag(x.x() - 0.5) < 0.2 && mag(x.y() - 0.5) < 0.2;
        if (x.z() > 1 - SMALL && isOnVent)
        {
            x.z() += ::tan(degToRad(scalar(30)))/3;
        }
    }

    const wallSurface wall(testSurfaces::endedOn(room, {"vent"}));
    const std::string advice
    (
        adviceOnPoints
        (
            wall, makeWallAddressing(wall), identity(wall.points.size())
        )
    );

    EXPECT_NE
    (
        advice.find("the side patch vent at 150 degrees in the fluid"),
        std::string::npos
    ) << advice;
}


// ************************************************************************* //
