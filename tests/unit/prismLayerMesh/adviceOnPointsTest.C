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

//- A room with a vent. The vent is the middle of the ceiling, or the whole
//  ceiling. The points inside of the vent lie above the ceiling.
static wallSurface roomWithVent
(
    const label nSquares,
    const scalar width,
    const scalar above = 0
)
{
    wallSurface room(testSurfaces::reversed(testSurfaces::cube(nSquares)));
    room.patchNames = wordList({"room", "vent"});
    room.patchIDs.setSize(room.faces.size());

    forAll(room.faces, facei)
    {
        const vector c(room.faces[facei].centre(room.points));
        room.patchIDs[facei] =
            c.z() > 1 - SMALL
         && mag(c.x() - 0.5) < 0.5*width && mag(c.y() - 0.5) < 0.5*width;
    }

    for (point& x : room.points)
    {
        const bool isInVent = mag(x.x() - 0.5) < 0.1 && mag(x.y() - 0.5) < 0.1;
        if (x.z() > 1 - SMALL && isInVent)
        {
            x.z() += above;
        }
    }

    return testSurfaces::endedOn(room, {"vent"});
}


//- The advice on all points of such a room
static std::string adviceOnRoom(const scalar width)
{
    const wallSurface wall(roomWithVent(3, width));

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


TEST(checkSidesOf, refusesSidesThatContinueTheWall)
{
    const wallSurface wall(roomWithVent(3, 0.34));
    EXPECT_THROW(checkSidesOf(wall, makeWallAddressing(wall)), wallPointsError);

    const wallSurface ceiling(roomWithVent(3, 1));
    EXPECT_NO_THROW(checkSidesOf(ceiling, makeWallAddressing(ceiling)));
}


TEST(checkSidesOf, refusesSidesThatContinueTheWallButForRounding)
{
    for (const scalar above : {1e-12, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3})
    {
        const wallSurface wall(roomWithVent(4, 0.5, above));
        EXPECT_THROW
        (
            checkSidesOf(wall, makeWallAddressing(wall)), wallPointsError
        ) << above;
    }
}


TEST(adviceOnPoints, namesNoPatchesAtAnAngle)
{
    const std::string advice(adviceOnRoom(1));

    EXPECT_EQ(advice.find("side patch"), std::string::npos) << advice;
    for (const char* wayOut : {"remesh { }", "repair wrap;", "CAD"})
    {
        EXPECT_NE(advice.find(wayOut), std::string::npos) << advice;
    }
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
    EXPECT_NO_THROW(checkSidesOf(wall, makeWallAddressing(wall)));
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
