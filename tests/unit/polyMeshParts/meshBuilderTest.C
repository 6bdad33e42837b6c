/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshBuilder.H"
#include "ListOps.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Two tetrahedra with a common face, which is turned, and patches whose faces
//  come in turns. Point 2 has no face.
static meshBuilder twoTets()
{
    meshBuilder faces;
    faces.append(face({0, 1, 4}), 0, meshBuilder::onPatch(2));
    faces.append(face({1, 0, 5}), 1, meshBuilder::onPatch(0));
    faces.append(face({0, 1, 3}), 1, 0);
    faces.append(face({1, 3, 4}), 0, meshBuilder::onPatch(2));
    faces.append(face({3, 1, 5}), 1, meshBuilder::onPatch(0));
    faces.append(face({3, 0, 4}), 0, meshBuilder::onPatch(0));
    faces.append(face({0, 3, 5}), 1, meshBuilder::onPatch(2));

    return faces;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(meshBuilder, patchesFollowInternalFacesThatPointToTheLargerCell)
{
    const meshBuilder faces(twoTets());
    const labelList order(faces.order(2, 3));
    EXPECT_EQ(order, labelList({2, 1, 4, 5, 0, 3, 6}));
    EXPECT_TRUE(faces.isTurned(2));
    EXPECT_FALSE(faces.isTurned(0));

    const polyMeshTopology t(faces.topology(order, 3));
    EXPECT_EQ(t.faces[0], face({0, 3, 1}));
    EXPECT_EQ(t.faces[1], face({1, 0, 5}));
    EXPECT_EQ(labelList(t.owner), labelList({0, 1, 1, 0, 0, 0, 1}));
    EXPECT_EQ(labelList(t.neighbour), labelList({1}));
    EXPECT_EQ(t.patchStarts, labelList({1, 4, 4}));
    EXPECT_EQ(t.patchSizes, labelList({3, 0, 3}));
    EXPECT_EQ(t.beyond(0), 1);
    EXPECT_EQ(t.beyond(4), -1);
}


TEST(meshBuilder, internalFacesAreInUpperTriangularOrder)
{
    // Faces between the same cells stay in their order
    meshBuilder faces;
    const List<labelPair> between({{2, 1}, {0, 2}, {1, 2}, {1, 0}});
    for (const labelPair& cells : between)
    {
        faces.append(face({0, 1, 2}), cells.first(), cells.second());
    }
    const labelList order(faces.order(3, 0));
    EXPECT_EQ(order, labelList({3, 1, 0, 2}));

    const polyMeshTopology t(faces.topology(order, 0));
    EXPECT_EQ(labelList(t.owner), labelList({0, 0, 1, 1}));
    EXPECT_EQ(labelList(t.neighbour), labelList({1, 2, 2, 2}));
}


TEST(meshBuilder, leavesOutLinesAndFacesWithinACell)
{
    meshBuilder faces;
    faces.append(face({0, 0, 1, 1, 0}), 0, 1);
    faces.append(face({0, 1, 2}), 1, 1);
    faces.append(face({0, 1, 1, 2, 0}), 0, 1);
    faces.append(face({0, 1, 3}), 0, meshBuilder::onPatch(0));
    faces.leaveOut(3);

    EXPECT_EQ(faces.size(), 4);
    EXPECT_EQ(faces.order(2, 1), labelList({2}));
    EXPECT_EQ(labelList(faces.pointsOf(2)), labelList({0, 1, 2}));
}


TEST(meshBuilder, pointsGetNewLabelsOrGo)
{
    meshBuilder faces(twoTets());
    faces.append(face({0, 1, 4, 3}), 0, meshBuilder::onPatch(1));
    faces.renumberPoints(labelList({2, 0, -1, 1, -1, 3}));

    EXPECT_EQ(labelList(faces.pointsOf(1)), labelList({0, 2, 3}));
    EXPECT_EQ(labelList(faces.pointsOf(2)), labelList({2, 0, 1}));
    EXPECT_EQ(labelList(faces.pointsOf(7)), labelList({2, 0, 1}));
}


TEST(polyMeshTopology, patchesCanBeReplaced)
{
    const meshBuilder faces(twoTets());
    polyMeshTopology t(faces.topology(faces.order(2, 3), 3));
    const faceList old(t.faces);
    t.setPatches(List<labelList>({labelList({6, 2}), labelList({1})}));

    EXPECT_EQ(faceList(t.faces), faceList({old[0], old[6], old[2], old[1]}));
    EXPECT_EQ(labelList(t.owner), labelList({0, 1, 1, 1}));
    EXPECT_EQ(t.patchStarts, labelList({1, 3}));
    EXPECT_EQ(t.patchSizes, labelList({2, 1}));
}


TEST(polyMeshTopology, aPatchWithoutFacesIsInserted)
{
    const meshBuilder faces(twoTets());
    polyMeshTopology t(faces.topology(faces.order(2, 3), 3));
    t.addEmptyPatch(2);
    t.addEmptyPatch(4);

    EXPECT_EQ(t.patchStarts, labelList({1, 4, 4, 4, 7}));
    EXPECT_EQ(t.patchSizes, labelList({3, 0, 0, 3, 0}));
    EXPECT_EQ(t.patchFaces(3), labelRange(4, 3));
}


// ************************************************************************* //
