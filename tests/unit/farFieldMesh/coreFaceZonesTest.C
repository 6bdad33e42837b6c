/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coreZones.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(coreFaceZones, facesStayOrAreTheTrianglesOfTheCut)
{
    // Face 0 stays as face 7; face 1 is cut into faces 3 and 4, with a cell
    // that stays behind it; face 2 likewise into face 5, in front; face 3 goes
    polyMeshParts core;
    core.topology.owner = labelList({0, 0, 1, 1});
    core.faceZones.setSize(1);
    core.faceZones[0].name = "zone";
    core.faceZones[0].faces = {0, 1, 2, 3};
    core.faceZones[0].flips = {true, true, true, false};

    Map<DynamicList<label>> cutFaces;
    cutFaces(1) = labelList({3, 4});
    cutFaces(2) = labelList({5});
    const List<faceZoneParts> zones
    (
        coreFaceZones
        (
            core, labelList({0, -1}), labelList({7, -1, -1, -1}), cutFaces
        )
    );

    ASSERT_EQ(zones.size(), 1);
    EXPECT_EQ(zones[0].name, "zone");
    EXPECT_EQ(zones[0].faces, labelList({7, 3, 4, 5}));
    EXPECT_EQ(zones[0].flips, boolList({true, false, false, true}));
}


// ************************************************************************* //
