/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfacePart.H"
#include "ListOps.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(surfacePart, isInTheOrderOfTheWhole)
{
    const wallSurface wall(sphere(4));
    const labelList faces({1, 2, 5, 40});
    const surfacePart part(makeSurfacePart(wall, faces));

    EXPECT_EQ(part.faces, faces);
    EXPECT_EQ(part.surface.points, pointField(wall.points, part.points));
    forAll(faces, i)
    {
        EXPECT_EQ
        (
            labelList(part.surface.faces[i]),
            part.localPoints(wall.faces[faces[i]])
        );
    }
    EXPECT_EQ(part.points.size(), pointsOf(part.surface.faces, 99).count());
}


TEST(surfacePart, appendedSurfacesShareTheirCommonPoints)
{
    const wallSurface whole(cube(2));
    wallSurface both(whole);
    appendSurface(whole, identity(4), both);
    const label n = whole.points.size();

    EXPECT_EQ(both.points.size(), 2*n - 4);
    EXPECT_EQ(both.patchNames.size(), 2*whole.patchNames.size());
    forAll(whole.faces, facei)
    {
        const label other = whole.faces.size() + facei;
        const label patchi = whole.patchIDs[facei];
        EXPECT_EQ(both.patchIDs[other], whole.patchNames.size() + patchi);
        forAll(whole.faces[facei], k)
        {
            const label p = whole.faces[facei][k];
            EXPECT_EQ(both.faces[other][k], p < 4 ? p : p - 4 + n);
            EXPECT_EQ(both.points[both.faces[other][k]], whole.points[p]);
        }
    }
}


TEST(surfacePart, keptFacesKeepTheirPatches)
{
    const wallSurface whole(cube(2));
    wallSurface kept(whole);
    keepFaces(bitSet(whole.faces.size(), labelList({3, 7})), kept);

    EXPECT_EQ(kept.faces.size(), 2);
    EXPECT_EQ(kept.patchIDs[1], whole.patchIDs[7]);
    EXPECT_EQ
    (
        kept.faces[1].centre(kept.points), whole.faces[7].centre(whole.points)
    );
}


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
