/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "editedColumns.H"
#include "retreatColumns.H"

#include <gtest/gtest.h>
#include <omp.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static bool neverAtFault(label)
{
    return false;
}


static bool alwaysAtFault(label)
{
    return true;
}


static bool grow(editedColumns& m, const label c)
{
    return growColumns(m.editor, labelList(1, c), neverAtFault).size();
}


//- A column that has retreated, with neighbours that had to follow
static label retreated(editedColumns& m)
{
    const label c = m.nColumns() - 1;

    for (label i = 0; i < 20; ++i)
    {
        retreatColumns(m.editor, labelList(1, c), squeezeCause::validity);
    }

    return c;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(growColumns, columnsBesideStandOnThePoint)
{
    for (const layerFront& front : fronts())
    {
        const editedColumns m(front);

        for (label c = 0; c < m.nColumns(); ++c)
        {
            const labelHashSet beside(m.editor.columnsBeside(c));

            for (label q = 0; q < m.nColumns(); ++q)
            {
                EXPECT_EQ
                (
                    beside.found(q),
                    front.wallPoints[q] == front.wallPoints[c]
                );
            }
        }
    }
}


TEST(growColumns, thoseThatDidNotRetreatStay)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const label now = m.editor.now();

        for (label c = 0; c < m.nColumns(); ++c)
        {
            EXPECT_FALSE(isLowered(m.editor, c));
            EXPECT_FALSE(grow(m, c));
        }

        EXPECT_TRUE(m.editor.touchedSince(now).empty());
    }
}


TEST(growColumns, allGrowBackInTheEnd)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const scalarField thickness(m.editor.thickness());
        const List<squeezeCause> causes(m.editor.causes());
        retreated(m);

        label nGrown = 1;
        while (nGrown)
        {
            nGrown = 0;
            for (label c = 0; c < m.nColumns(); ++c)
            {
                nGrown += grow(m, c);
            }
        }

        EXPECT_EQ(m.editor.thickness(), thickness);
        EXPECT_EQ(m.editor.causes(), causes);
    }
}


TEST(growColumns, theGradientStaysBounded)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        retreated(m);

        for (label c = 0; c < m.nColumns(); ++c)
        {
            grow(m, c);

            for (const label q : front.addressing.pointPoints[c])
            {
                EXPECT_LE
                (
                    mag(m.editor.thickness()[q] - m.editor.thickness()[c]),
                    layerColumns::maxSlope
                   *mag(front.surface.points[q] - front.surface.points[c])
                  + 1e-15
                );
            }
        }
    }
}


TEST(growColumns, noneGrowsMoreThanItRetreats)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const label c = retreated(m);
        const scalar before = m.editor.thickness()[c];

        EXPECT_TRUE(grow(m, c));
        EXPECT_GT(m.editor.thickness()[c], before);
        EXPECT_LE(m.editor.thickness()[c], before/0.8*(1 + 1e-12));
    }
}


TEST(growColumns, thoseAtFaultThenStayAsTheyWere)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const label c = retreated(m);
        const scalarField thickness(m.editor.thickness());
        const pointField points(m.editor.layers().points);
        const label now = m.editor.now();

        EXPECT_TRUE
        (
            growColumns(m.editor, labelList(1, c), alwaysAtFault).empty()
        );
        EXPECT_EQ(m.editor.thickness(), thickness);
        EXPECT_EQ(m.editor.layers().points, points);
        EXPECT_EQ(m.editor.causes()[c], squeezeCause::validity);
        EXPECT_TRUE(m.editor.touchedSince(now).empty());
    }
}


TEST(growColumns, numberOfThreadsChangesNothing)
{
    const label nThreads = omp_get_max_threads();

    for (const layerFront& front : fronts())
    {
        pointField points;

        for (const label n : {1, 4})
        {
            omp_set_num_threads(n);
            editedColumns m(front);
            retreated(m);
            const labelList grown
            (
                growColumns(m.editor, identity(m.nColumns()), neverAtFault)
            );

            EXPECT_FALSE(grown.empty());
            points = n == 1 ? m.editor.layers().points : points;
            EXPECT_EQ(m.editor.layers().points, points);
        }
    }

    omp_set_num_threads(nThreads);
}


TEST(growColumns, thoseRolledBackAreAsTheyWere)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const labelList all(m.editor.columnsBeside(retreated(m)));
        const scalarField thickness(m.editor.thickness());
        const pointField points(m.editor.layers().points);

        m.editor.record();
        EXPECT_EQ
        (
            growColumns(m.editor, all, neverAtFault),
            labelHashSet(all).sortedToc()
        );
        EXPECT_NE(m.editor.layers().points, points);

        for (const label c : all)
        {
            m.editor.rollBack(c);
        }

        EXPECT_EQ(m.editor.thickness(), thickness);
        EXPECT_EQ(m.editor.layers().points, points);
    }
}

// ************************************************************************* //
