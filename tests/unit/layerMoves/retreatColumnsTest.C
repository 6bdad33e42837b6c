/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "editedColumns.H"
#include "retreatColumns.H"
#include "scaledJacobian.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(retreatColumns, takesAFifthOfTheThickness)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const scalarField before(m.editor.thickness());
        retreatColumns(m.editor, labelList(1, 5), squeezeCause::validity);

        EXPECT_NEAR(m.editor.thickness()[5], 0.8*before[5], 1e-15);
    }
}


TEST(retreatColumns, neverRaises)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const scalarField before(m.editor.thickness());
        retreatColumns(m.editor, someColumns(m, 5), squeezeCause::validity);

        EXPECT_LE(max(m.editor.thickness() - before), 0);
    }
}


TEST(retreatColumns, boundsTheGradient)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);

        for (label i = 0; i < 20; ++i)
        {
            retreatColumns(m.editor, labelList(1, 5), squeezeCause::validity);
        }

        const scalarField& thickness = m.editor.thickness();
        for (const edge& e : front.addressing.edges)
        {
            EXPECT_LE
            (
                mag(thickness[e.start()] - thickness[e.end()]),
                layerColumns::maxSlope*e.mag(front.surface.points) + 1e-15
            );
        }
    }
}


TEST(retreatColumns, columnsOnAPointRetreatTogether)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const label last = m.nColumns() - 1;
        retreatColumns(m.editor, labelList(1, last), squeezeCause::validity);

        for (label c = 0; c < m.nColumns(); ++c)
        {
            if (front.wallPoints[c] == front.wallPoints[last])
            {
                EXPECT_EQ(m.editor.thickness()[c], m.editor.thickness()[last]);
            }
        }
    }
}


TEST(retreatColumns, tellsWhy)
{
    label nNeighbours = 0;

    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const scalarField before(m.editor.thickness());
        const List<squeezeCause> causes(m.editor.causes());

        for (label i = 0; i < 20; ++i)
        {
            retreatColumns
            (
                m.editor, labelList(1, 5), squeezeCause::intersection
            );
        }

        for (label c = 0; c < m.nColumns(); ++c)
        {
            const bool lower = m.editor.thickness()[c] < before[c];
            nNeighbours += lower && c != 5;

            EXPECT_EQ
            (
                m.editor.causes()[c],
                c == 5 ? squeezeCause::intersection
              : lower && causes[c] == squeezeCause::none
              ? squeezeCause::neighbour
              : causes[c]
            );
        }
    }

    EXPECT_GT(nNeighbours, 0);
}


TEST(retreatColumns, heightIsAllTheThicknessOnFlatFaces)
{
    // Where edges and corners have a column for each side
    editedColumns m(fronts()[3]);
    retreatColumns(m.editor, someColumns(m, 20), squeezeCause::validity);

    for (label c = 0; c < m.nColumns(); ++c)
    {
        const vectorField& normals = m.front.visibility.cornerNormals[c];

        EXPECT_NEAR
        (
            (m.end(c) - m.front.surface.points[c]) & normals[0],
            m.editor.thickness()[c],
            1e-14
        );
    }
}


TEST(retreatColumns, trialOfARetreatLeavesNoTrace)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const pointField before(m.editor.layers().points);
        const scalarField thickness(m.editor.thickness());
        const label now = m.editor.now();

        for (const label c : front.surface.faces[7])
        {
            jacobianOfRetreat(m.editor, 7, c);
        }

        EXPECT_EQ(m.editor.layers().points, before);
        EXPECT_EQ(m.editor.thickness(), thickness);
        EXPECT_TRUE(m.editor.touchedSince(now).empty());
    }
}


TEST(retreatColumns, trialOfARetreatIsWhatARetreatGives)
{
    editedColumns m(fronts()[0]);
    const label c = m.front.surface.faces[7][0];

    const scalar trial = jacobianOfRetreat(m.editor, 7, c);
    retreatColumns(m.editor, labelList(1, c), squeezeCause::validity);

    EXPECT_NEAR(worstJacobian(m.editor.layers(), 7), trial, 1e-14);
}


// ************************************************************************* //
