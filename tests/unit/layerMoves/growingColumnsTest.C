/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "movableColumns.H"

#include <gtest/gtest.h>

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


static bool grow(movableColumns& m, const label c)
{
    return m.moving.grow(m.moving.columnsBeside(c), neverAtFault);
}


//- A column that has retreated, with neighbours that had to follow
static label retreated(movableColumns& m)
{
    const label c = m.nColumns() - 1;

    for (label i = 0; i < 20; ++i)
    {
        m.moving.retreat(labelList(1, c), squeezeCause::validity);
    }

    return c;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(growingColumns, columnsBesideStandOnThePoint)
{
    for (const layerFront& front : fronts())
    {
        const movableColumns m(front);

        for (label c = 0; c < m.nColumns(); ++c)
        {
            const labelHashSet beside(m.moving.columnsBeside(c));

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


TEST(growingColumns, thoseThatDidNotRetreatStay)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        m.moving.takeCandidates();

        for (label c = 0; c < m.nColumns(); ++c)
        {
            EXPECT_FALSE(m.moving.lowered(c));
            EXPECT_FALSE(grow(m, c));
        }

        EXPECT_TRUE(m.moving.takeCandidates().empty());
    }
}


TEST(growingColumns, allGrowBackInTheEnd)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        const scalarField room(m.moving.room());
        const List<squeezeCause> causes(m.columns.causes);
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

        EXPECT_EQ(m.moving.room(), room);
        EXPECT_EQ(m.columns.causes, causes);
    }
}


TEST(growingColumns, theGradientStaysBounded)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        retreated(m);

        for (label c = 0; c < m.nColumns(); ++c)
        {
            grow(m, c);

            for (const label q : front.addressing.pointPoints[c])
            {
                EXPECT_LE
                (
                    mag(m.moving.room()[q] - m.moving.room()[c]),
                    layerColumns::maxSlope
                   *mag(front.surface.points[q] - front.surface.points[c])
                  + 1e-15
                );
            }
        }
    }
}


TEST(growingColumns, noneGrowsMoreThanItRetreats)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        const label c = retreated(m);
        const scalar before = m.moving.room()[c];

        EXPECT_TRUE(grow(m, c));
        EXPECT_GT(m.moving.room()[c], before);
        EXPECT_LE(m.moving.room()[c], before/0.8*(1 + 1e-12));
    }
}


TEST(growingColumns, thoseAtFaultThenStayAsTheyWere)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        const label c = retreated(m);
        const scalarField room(m.moving.room());
        const pointField points(m.moving.layers().points);
        m.moving.takeCandidates();

        EXPECT_FALSE
        (
            m.moving.grow(m.moving.columnsBeside(c), alwaysAtFault)
        );
        EXPECT_EQ(m.moving.room(), room);
        EXPECT_EQ(m.moving.layers().points, points);
        EXPECT_EQ(m.columns.causes[c], squeezeCause::validity);
        EXPECT_TRUE(m.moving.takeCandidates().empty());
    }
}


TEST(growingColumns, restoredOnesAreAsTheyWere)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        const labelList all(m.moving.columnsBeside(retreated(m)));
        const scalarField room(m.moving.room());
        const pointField points(m.moving.layers().points);

        List<movingColumns::posture> before;
        for (const label c : all)
        {
            before.append(m.moving.postureOf(c));
        }

        EXPECT_TRUE(m.moving.grow(all, neverAtFault));
        EXPECT_NE(m.moving.layers().points, points);

        forAll(all, i)
        {
            m.moving.restore(all[i], before[i]);
        }

        EXPECT_EQ(m.moving.room(), room);
        EXPECT_EQ(m.moving.layers().points, points);
    }
}

// ************************************************************************* //
