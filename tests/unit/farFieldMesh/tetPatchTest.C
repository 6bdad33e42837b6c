/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "smallFarFields.H"
#include "tetPatch.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

// What a patch foretells is what a replacement makes
TEST(tetPatch, hasTheViolationAfterAMove)
{
    farFieldTets mesh(filledCube(4));
    const neighbourCells none;
    const label p = mesh.points.size() - 1;
    ASSERT_GE(p, mesh.nBoundaryPoints);
    const DynamicList<point> points(mesh.points);
    const tetEditor tets(mesh.tets, points.size());
    const tetViolation judge(none, mesh, points, tets);

    const tetHole hole(judge, tets.star(p));
    const tetCellList around(tets.subset(hole.tets));
    tetPatch patch(hole, around, movedPoints{points, p, points[p]});
    EXPECT_NEAR(patch.violation(), hole.violation(), 1e-12);

    patch.moveTo(points[p] + vector(0.02, 0.03, -0.01));
    DynamicList<point> moved(points);
    moved[p] = patch.place();
    EXPECT_TRUE(areValid(movedPoints{moved, -1, Zero}, around));
    const tetViolation after(none, mesh, moved, tets);
    EXPECT_GT(patch.violation(), 0.01);
    EXPECT_NEAR
    (
        patch.violation(), tetHole(after, hole.tets).violation(), 1e-12
    );
    EXPECT_FALSE(areValid(movedPoints{points, p, points[0]}, around));
}


TEST(tetPatch, hasTheViolationAfterAReplacement)
{
    // Three tetrahedra around an edge, two without it, and cells of layers
    farFieldTets mesh;
    mesh.points = pointField
    ({{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-0.5, 0.8, 0}, {-0.5, -0.8, 0.2}});
    mesh.tets = tetCellList
    ({tetCell(1, 0, 2, 3), tetCell(1, 0, 3, 4), tetCell(1, 0, 4, 2)});
    mesh.nBoundaryPoints = 5;
    turnPositive(mesh);
    mesh.outerTriangles = faceList({face({0, 2, 3}), face({1, 3, 2})});
    neighbourCells cells;
    cells.centres = pointField({{2, 1, 1}, {1, 3, -1}});
    cells.volumes = scalarList({0, 100});

    const DynamicList<point> points(mesh.points);
    tetEditor tets(mesh.tets, 5);
    const tetViolation judge(cells, mesh, points, tets);
    farFieldTets two(mesh);
    two.tets = tetCellList({tetCell(0, 2, 3, 4), tetCell(1, 2, 4, 3)});
    turnPositive(two);
    const movedPoints unmoved{points, -1, Zero};
    const tetPatch patch(tetHole(judge, identity(3)), two.tets, unmoved);
    EXPECT_TRUE(areValid(unmoved, two.tets));
    const scalar expected = patch.violation();

    const tetHole hole(judge, tets.replace(identity(3), two.tets));
    EXPECT_GT(expected, 0);
    EXPECT_NEAR(hole.violation(), expected, 1e-12*expected);
}


// ************************************************************************* //
