/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "editedColumns.H"
#include "leanColumns.H"
#include "limitHeightJumps.H"
#include "retreatColumns.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(layerEditor, standOnTheFrontAtFirst)
{
    for (const layerFront& front : fronts())
    {
        const editedColumns m(front);

        for (label c = 0; c < m.nColumns(); ++c)
        {
            EXPECT_EQ(m.editor.layers()(c, 0), front.surface.points[c]);
        }
        EXPECT_EQ
        (
            m.editor.layers().extraColumnPoints, front.extraColumnPoints()
        );
        EXPECT_EQ(m.editor.layers().faces, front.surface.faces);
        EXPECT_EQ(m.editor.layers().nWallFaces(), front.nWallFaces);
    }
}


TEST(layerEditor, allFacesAreTouchedAtFirst)
{
    for (const layerFront& front : fronts())
    {
        const editedColumns m(front);

        EXPECT_EQ
        (
            m.editor.touchedSince(0), identity(front.surface.faces.size())
        );
    }
}


TEST(layerEditor, nothingIsTouchedSinceNow)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        retreatColumns(m.editor, someColumns(m, 3), squeezeCause::validity);

        EXPECT_TRUE(m.editor.touchedSince(m.editor.now()).empty());
    }
}


TEST(layerEditor, groupsOfStacksHaveAllChanges)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const List<boundBox> before(m.editor.stackGroups().all());
        retreatColumns
        (
            m.editor, identity(m.nColumns()), squeezeCause::validity
        );

        EXPECT_NE(m.editor.stackGroups().all(), before);
        EXPECT_EQ
        (
            m.editor.stackGroups().all(), stackBoxes(m.editor.layers()).all()
        );
    }
}


TEST(layerEditor, touchedStacksCanBeAskedAgain)
{
    editedColumns m(fronts()[0]);
    const label now = m.editor.now();
    m.editor.touch(5);
    const labelList faces(facesOf(m, labelList(1, 5)));

    EXPECT_EQ(m.editor.touchedSince(now), faces);
    EXPECT_EQ(m.editor.touchedSince(now), faces);

    m.editor.touch(5);
    EXPECT_EQ(m.editor.touchedSince(now), faces);
}


TEST(layerEditor, columnsOfTheSameThicknessStayWhereTheyArePlaced)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        m.editor.setPoint
        (
            3, 2, m.editor.layers()(3, 2) + vector(0.001, 0.002, 0.003)
        );
        const pointField placed(m.editor.layers().points);
        m.editor.setThickness(3, m.editor.thickness()[3]);

        EXPECT_TRUE(movedColumns(m, placed).empty());
    }
}


TEST(layerEditor, lowerColumnsStandWhereTheyWerePlaced)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        for (label i = 1; i <= 4; ++i)
        {
            const vector aside(m.editor.heights(3)[i]*vector(0.1, 0.2, 0.3));
            m.editor.setPoint(3, i, m.editor.layers()(3, i) + aside);
        }
        const scalar thickness = 0.6*m.editor.thickness()[3];
        const vector offset(m.editor.offsetAt(3, thickness));
        m.editor.setThickness(3, thickness);

        EXPECT_NEAR
        (
            mag(m.end(3) - m.editor.layers()(3, 0) - thickness*offset), 0, 1e-15
        );
    }
}


TEST(layerEditor, turnedColumnsAreAsFarBesideAsTheyWerePlaced)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front), other(front);
        const vector d(0.05*(m.end(3) - m.editor.layers()(3, 0)));
        const vectorField directions
        (
            4, front.visibility.cones[3].axis + vector(0.05, 0.1, 0.15)
        );
        m.editor.setPoint(3, 4, m.end(3) + d);

        m.editor.setDirections(3, m.editor.state(3), directions);
        other.editor.setDirections(3, other.editor.state(3), directions);

        EXPECT_NEAR(mag(m.end(3) - other.end(3) - d), 0, 1e-15);
    }
}


TEST(layerEditor, touchedFacesAreThoseAroundMovedColumns)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const label now = m.editor.now();
        const pointField before(m.editor.layers().points);
        retreatColumns(m.editor, someColumns(m, 3), squeezeCause::validity);

        EXPECT_EQ
        (
            m.editor.touchedSince(now), facesOf(m, movedColumns(m, before))
        );
    }
}


//- Change a column in all that it has
static void change(editedColumns& m, const label c)
{
    const vector aside(0.1, 0.2, 0.3);
    m.editor.setThickness(c, 0.7*m.editor.thickness()[c], 0.4);
    m.editor.setDirections
    (
        c, m.editor.state(c),
        vectorField(4, aside + m.front.visibility.cones[c].axis)
    );
    m.editor.setPoint(c, 2, m.editor.layers()(c, 2) + 0.001*aside);
    m.editor.setCause(c, squeezeCause::intersection);
}


TEST(layerEditor, restoredColumnsAreAsTheyWere)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const pointField points(m.editor.layers().points);
        const scalarField thickness(m.editor.thickness());
        const List<squeezeCause> causes(m.editor.causes());
        const scalarList heights(SubList<scalar>
        (
            UList<scalar>(const_cast<scalar*>(m.editor.heights(3)), 5), 5
        ));

        const columnState before(m.editor.state(3));
        change(m, 3);
        EXPECT_NE(m.editor.layers().points, points);
        EXPECT_NE(m.editor.heights(3)[4], heights[4]);

        m.editor.restore(3, before);

        EXPECT_EQ(m.editor.layers().points, points);
        EXPECT_EQ(m.editor.thickness(), thickness);
        EXPECT_EQ(m.editor.causes(), causes);
        for (label i = 0; i < 5; ++i)
        {
            EXPECT_EQ(m.editor.heights(3)[i], heights[i]);
        }
    }
}


TEST(layerEditor, changesThatAreNotAcceptedLeaveNoTrace)
{
    editedColumns m(fronts()[0]);
    m.editor.record();
    const label now = m.editor.now();
    const columnState before(m.editor.state(3));
    change(m, 3);
    m.editor.restore(3, before);

    EXPECT_TRUE(m.editor.touchedSince(now).empty());
    EXPECT_FALSE(m.editor.isChanged(3));
}


TEST(layerEditor, rollBackUndoesAllChangesSinceKeep)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        m.editor.record();
        retreatColumns(m.editor, labelList(1, 7), squeezeCause::validity);
        m.editor.keep();
        const pointField points(m.editor.layers().points);
        const scalarField thickness(m.editor.thickness());

        for (label i = 0; i < 5; ++i)
        {
            retreatColumns(m.editor, labelList(1, 3), squeezeCause::gap);
        }
        turnColumns(m.editor, labelList(1, 3), m.nTurns);
        EXPECT_TRUE(m.editor.isChanged(3));
        EXPECT_NE(m.editor.layers().points, points);

        for (label c = 0; c < m.nColumns(); ++c)
        {
            if (m.editor.isChanged(c))
            {
                m.editor.rollBack(c);
            }
        }

        EXPECT_EQ(m.editor.layers().points, points);
        EXPECT_EQ(m.editor.thickness(), thickness);
        EXPECT_FALSE(m.editor.isChanged(3));
    }
}


TEST(layerEditor, keptColumnsAreNotChanged)
{
    editedColumns m(fronts()[0]);
    m.editor.record();
    retreatColumns(m.editor, labelList(1, 3), squeezeCause::validity);
    EXPECT_TRUE(m.editor.isChanged(3));

    m.editor.keep();
    EXPECT_FALSE(m.editor.isChanged(3));
}


TEST(layerEditor, onlyWhatTheJournalSaysHasMoved)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);

        for (label round = 0; round < 4; ++round)
        {
            const label now = m.editor.now();
            const pointField before(m.editor.layers().points);
            const labelList some(someColumns(m, 4));
            turnColumns(m.editor, some, m.nTurns);
            retreatColumns(m.editor, some, squeezeCause::validity);
            limitHeightJumps(m.editor, neighboursOnWall(m.front));
            const labelHashSet touched(m.editor.touchedSince(now));

            for (const label facei : facesOf(m, movedColumns(m, before)))
            {
                EXPECT_TRUE(touched.found(facei));
            }
        }
    }
}


// ************************************************************************* //
