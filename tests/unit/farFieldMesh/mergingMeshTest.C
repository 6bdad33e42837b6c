/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "mergingMesh.H"
#include "meshBuilder.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Two tetrahedra with a common face in z = 0. The centre of both together is
//  at y = (2 + y of the first apex)/8; the lower one has a face in y = 0.
static farFieldMesh twoTets(const scalar y)
{
    farFieldMesh far;
    far.points = pointField
    ({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0, y, 1}});
    far.nCells = 2;
    meshBuilder faces;
    faces.append(face({0, 2, 1}), 0, 1);
    for (const face& f : {face({0, 1, 4}), face({1, 2, 4}), face({2, 0, 4})})
    {
        faces.append(f, 0, meshBuilder::onPatch(0));
    }
    for (const face& f : {face({1, 0, 3}), face({2, 1, 3}), face({0, 2, 3})})
    {
        faces.append(f, 1, meshBuilder::onPatch(0));
    }
    far.topology = faces.topology(faces.order(2, 1), 1);

    return far;
}


static bool isStar(const farFieldMesh& far)
{
    mergingMesh mesh(prismLayers(), wallAddressing(), 2, far);
    mesh.merge(0, 1);

    return mesh.isStar(0);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(mergingMesh, aStarHasItsCentreBehindAllFaces)
{
    EXPECT_TRUE(isStar(twoTets(-1.9)));
    EXPECT_FALSE(isStar(twoTets(-2.1)));
}


// The sum in another order of the faces may be on the other side
TEST(mergingMesh, theCentreOfAStarIsFurtherFromItsFacesThanRounding)
{
    EXPECT_TRUE(isStar(twoTets(-2 + 1e-10)));
    EXPECT_FALSE(isStar(twoTets(-2 + 4e-15)));
}

// ************************************************************************* //
