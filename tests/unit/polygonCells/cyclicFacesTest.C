/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cyclicFaces.H"
#include "meshBuilder.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Two squares, x = 0 and x = 1, of two triangles each. The second has them in
//  the other order, from other points on.
static polyMeshParts twoSquares()
{
    polyMeshParts mesh;
    mesh.nCells = 2;
    for (const scalar x : {0, 1})
    {
        mesh.points.append(point(x, 0, 0));
        mesh.points.append(point(x, 1, 0));
        mesh.points.append(point(x, 1, 1));
        mesh.points.append(point(x, 0, 1));
    }
    meshBuilder faces;
    faces.append(face({0, 3, 2}), 0, meshBuilder::onPatch(0));
    faces.append(face({0, 2, 1}), 1, meshBuilder::onPatch(0));
    faces.append(face({5, 6, 4}), 1, meshBuilder::onPatch(1));
    faces.append(face({7, 4, 6}), 0, meshBuilder::onPatch(1));
    mesh.topology = faces.topology(faces.order(2, 2), 2);
    mesh.patches.append("left", "cyclic");
    mesh.patches.append("right", "cyclic");

    return mesh;
}


static List<sidePatch> sidesOfSquares()
{
    List<sidePatch> sides(2);
    sides[0].name = "left";
    sides[0].normal = vector(-1, 0, 0);
    sides[0].cyclic.partner = "right";
    sides[1].name = "right";
    sides[1].origin = point(1, 0, 0);
    sides[1].normal = vector(1, 0, 0);
    for (sidePatch& side : sides)
    {
        side.type = "cyclic";
    }

    return sides;
}

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(cyclicFaces, arePutIntoTheOrderOfTheirImages)
{
    polyMeshParts mesh(twoSquares());
    const cyclicFaces pairs(sidesOfSquares(), mesh.patches);
    EXPECT_TRUE(pairs.withoutImage(mesh).empty());
    pairs.align(mesh);

    EXPECT_EQ(mesh.topology.faces[2], face({4, 6, 7}));
    EXPECT_EQ(mesh.topology.faces[3], face({4, 5, 6}));
    EXPECT_EQ(mesh.topology.owner[2], 0);
    EXPECT_EQ(mesh.topology.owner[3], 1);
}


TEST(cyclicFaces, otherDiagonalsHaveNoImage)
{
    polyMeshParts mesh(twoSquares());
    mesh.topology.faces[0] = face({0, 3, 1});
    mesh.topology.faces[1] = face({1, 3, 2});
    const cyclicFaces pairs(sidesOfSquares(), mesh.patches);

    EXPECT_EQ(pairs.withoutImage(mesh), labelList({0, 1, 2, 3}));
}


TEST(cyclicFaces, arePairsOfPatchesThatTheMeshHas)
{
    polyMeshParts mesh(twoSquares());
    const cyclicFaces pairs(sidesOfSquares(), mesh.patches);
    EXPECT_TRUE(pairs.has(0));
    EXPECT_FALSE(pairs.has(-1));

    mesh.patches.names[1] = "other";
    EXPECT_TRUE(cyclicFaces(sidesOfSquares(), mesh.patches).empty());
}


// ************************************************************************* //
