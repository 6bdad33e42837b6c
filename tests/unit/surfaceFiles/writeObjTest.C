/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writeObj.H"
#include "OSspecific.H"
#include "surfaceFile.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

using namespace Foam;

TEST(writeObj, isReadAsItWas)
{
    wallSurface wall(testSurfaces::sphere(12));
    for (point& x : wall.points)
    {
        x /= 3;
    }
    const label n = wall.faces.size();
    const List<surfZone> zones
    ({
        surfZone("first", 10, 0, 0), surfZone("others", n - 10, 10, 1)
    });
    const fileName file("writeObjTest.obj");
    writeObj
    (
        file,
        MeshedSurface<face>
        (
            pointField(wall.points), faceList(wall.faces), zones
        )
    );

    bool separateFaces = true;
    const wallSurface read(readSurfaceFile(file, separateFaces));
    rm(file);

    // To the last digit
    EXPECT_EQ(read.points, wall.points);
    EXPECT_EQ(read.faces, wall.faces);
    EXPECT_EQ(read.patchNames, wordList({"first", "others"}));
    EXPECT_EQ(read.patchIDs[9], 0);
    EXPECT_EQ(read.patchIDs[10], 1);
}

// ************************************************************************* //
