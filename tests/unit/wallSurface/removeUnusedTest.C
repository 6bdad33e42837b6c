/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "removeUnused.H"
#include "ListOps.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(removeUnused, pointsThatNoFaceUsesGo)
{
    wallSurface wall(cube(1));
    const pointField points(wall.points);
    const faceList all(wall.faces);
    wall.faces.setSize(1);
    const labelList numbers(removeUnusedPoints(wall.faces, wall.points));

    EXPECT_EQ(wall.points.size(), 3);
    for (label i = 0; i < 3; ++i)
    {
        EXPECT_EQ(wall.faces[0][i], numbers[all[0][i]]);
        EXPECT_EQ(wall.points[wall.faces[0][i]], points[all[0][i]]);
    }
    EXPECT_EQ(findIndices(numbers, -1).size(), points.size() - 3);
}


TEST(removeUnused, patchesOfOneNameAreOneAndEmptyOnesGo)
{
    wallSurface wall(cube(1));
    wall.patchNames = {"none", "body", "hull", "body"};
    wall.patchTypes = {"patch", "wall", "symmetry", "wall"};
    forAll(wall.patchIDs, facei)
    {
        wall.patchIDs[facei] = 1 + facei % 3;
    }
    mergePatches(wall);

    EXPECT_EQ(wall.patchNames, wordList({"body", "hull"}));
    EXPECT_EQ(wall.patchTypes, wordList({"wall", "symmetry"}));
    forAll(wall.patchIDs, facei)
    {
        EXPECT_EQ(wall.patchIDs[facei], facei % 3 == 1 ? 1 : 0);
    }
}


// ************************************************************************* //
