/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetEditor.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Tetrahedra around the edge from 0 to 1: the points 2 to n + 1 in turn
static tetCellList aroundEdge(const label n)
{
    tetCellList tets(n);

    forAll(tets, k)
    {
        tets[k] = tetCell(0, 1, 2 + k, 2 + (k + 1) % n);
    }

    return tets;
}


//- Expects that neighbours are those of a new list, and that faces connect all
//  tetrahedra of a point
static void expectConsistent(const tetEditor& editor)
{
    const tetCellList tets(editor.remaining());
    ASSERT_EQ(tets.size(), editor.size());

    const List<FixedList<label, 4>> expected
    (
        tetNeighbours(tets, editor.nPoints())
    );
    labelList nTets(editor.nPoints(), 0);

    forAll(tets, t)
    {
        for (label i = 0; i < 4; ++i)
        {
            EXPECT_EQ(editor.neighbour(t, i), expected[t][i]);
            EXPECT_TRUE(editor.star(tets[t][i]).found(t));
            ++nTets[tets[t][i]];
        }
    }

    forAll(nTets, p)
    {
        EXPECT_EQ(editor.star(p).size(), nTets[p]);
    }
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(tetEditor, walksAroundAnEdge)
{
    const tetEditor editor(aroundEdge(5), 7);
    DynamicList<label> points;
    DynamicList<label> tets;

    editor.ring(3, edge(0, 1), points, tets);
    EXPECT_EQ(points, labelList({5, 6, 2, 3, 4}));
    EXPECT_EQ(tets, labelList({3, 4, 0, 1, 2}));

    // The other way for the edge from its other end
    editor.ring(3, edge(1, 0), points, tets);
    EXPECT_EQ(points, labelList({6, 5, 4, 3, 2}));

    editor.ring(3, edge(0, 5), points, tets);
    EXPECT_TRUE(points.empty());
    EXPECT_TRUE(tets.empty());
}


TEST(tetEditor, replacesTetrahedraAndTakesThatBack)
{
    const tetCellList three(aroundEdge(3));
    tetEditor editor(three, 5);
    expectConsistent(editor);

    // Two on the triangle around the edge, without the edge
    const labelList two
    (
        editor.replace
        (
            labelList({0, 1, 2}),
            tetCellList({tetCell(0, 2, 3, 4), tetCell(1, 2, 4, 3)})
        )
    );
    EXPECT_EQ(editor.remaining().size(), 2);
    EXPECT_EQ(editor.neighbour(two[0], 0), two[1]);
    EXPECT_EQ(editor.star(0), labelList({two[0]}));
    EXPECT_EQ
    (
        editor.remainingNeighbours(), tetNeighbours(editor.remaining(), 5)
    );

    editor.replace(two, three);
    expectConsistent(editor);
    EXPECT_EQ(editor.size(), 3);
}


TEST(tetEditor, addsAPoint)
{
    tetEditor editor(aroundEdge(4), 6);
    const label p = editor.addPoint();
    EXPECT_EQ(p, 6);

    DynamicList<tetCell> parts;
    for (const tetCell& tet : editor.remaining())
    {
        parts.append(tetCell(tet[0], p, tet[2], tet[3]));
        parts.append(tetCell(p, tet[1], tet[2], tet[3]));
    }
    editor.replace(labelList({0, 1, 2, 3}), parts);

    expectConsistent(editor);
    EXPECT_EQ(editor.star(p).size(), 8);
}


TEST(tetEditor, refusesTetrahedraWithOtherFaces)
{
    tetEditor editor(aroundEdge(3), 5);

    EXPECT_THROW
    (
        editor.replace
        (
            labelList({0, 1, 2}), tetCellList({tetCell(0, 2, 3, 4)})
        ),
        Foam::error
    );
}


// ************************************************************************* //
