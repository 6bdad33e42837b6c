/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "movableColumns.H"
#include "poorStacks.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- How far the ends of a face's columns are from a point
static movingColumns::faceFault distanceTo
(
    const movableColumns& m,
    const point& x
)
{
    return [&m, x](const label facei, label, scalar)
    {
        scalar sum = 0;
        for (const label c : m.front.surface.faces[facei])
        {
            sum += mag(m.end(c) - x);
        }
        return sum;
    };
}


static scalar atFault(label, label, scalar)
{
    return 1;
}


//- None where the end of a column is not at a point
static movingColumns::faceFault awayFrom
(
    const movableColumns& m,
    const label c,
    const point& x
)
{
    return [&m, c, x](label, label, scalar)
    {
        return mag(m.end(c) - x) > 1e-6 ? 0 : 1;
    };
}


//- Sum of the faults of the faces around a column
static scalar sumOf
(
    const movableColumns& m,
    const label c,
    const movingColumns::faceFault& fault
)
{
    scalar sum = 0;
    for (const label facei : m.front.addressing.pointFaces[c])
    {
        sum += fault(facei, 1, GREAT);
    }

    return sum;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(leaningColumns, columnsLeanToWhatFaultsAsk)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);

        for (const label c : someColumns(m, 10))
        {
            const vector across(normalised(vector(1, 2, 3)));
            const auto fault = distanceTo(m, m.end(c) + across);
            const scalar before = sumOf(m, c, fault);
            const point end(m.end(c));

            if (m.moving.lean(c, fault))
            {
                EXPECT_LE(sumOf(m, c, fault), 0.98*before);
                EXPECT_GT(mag(m.end(c) - end), 0);
            }
        }
    }
}


TEST(leaningColumns, leanWhereAnyPlaceIsBetter)
{
    // But for those that would be too long for their height
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);

        for (label c = 0; c < m.nColumns(); ++c)
        {
            const scalar heightCosine = front.visibility.heightCosine
            (
                c, front.visibility.cones[c].axis
            );

            if (heightCosine*movableColumns::maxStretch > 1.1)
            {
                EXPECT_TRUE(m.moving.lean(c, awayFrom(m, c, m.end(c))));
            }
        }
    }
}


TEST(leaningColumns, faultsNeverGrow)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        const scalarField best
        (
            bestJacobians(front.surface, front.visibility)
        );
        const auto fault = [&](label facei, label lowest, scalar enough)
        {
            return poorness
            (
                m.moving.layers(), facei, 20*best[facei], enough, lowest
            );
        };

        for (label round = 0; round < 5; ++round)
        {
            const labelList some(someColumns(m, 15));
            m.moving.retreat(some, squeezeCause::validity);

            for (const label c : some)
            {
                const scalar before = sumOf(m, c, fault);
                m.moving.lean(c, fault);

                EXPECT_LE(sumOf(m, c, fault), before + 1e-10);
            }
        }
    }
}


TEST(leaningColumns, stayWhereNothingIsBetter)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        const pointField before(m.moving.layers().points);

        for (label c = 0; c < m.nColumns(); ++c)
        {
            EXPECT_FALSE(m.moving.lean(c, atFault));
        }

        EXPECT_LT(max(mag(m.moving.layers().points - before)), 1e-14);
    }
}


TEST(leaningColumns, stayAlsoAfterTheyHaveMoved)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        const labelList some(someColumns(m, 20));

        for (label round = 0; round < 3; ++round)
        {
            m.moving.turn(some);
            const label c = some[round];
            m.moving.lean(c, awayFrom(m, c, m.end(c)));
            m.moving.retreat(some, squeezeCause::validity);
        }

        const pointField before(m.moving.layers().points);
        for (label c = 0; c < m.nColumns(); ++c)
        {
            EXPECT_FALSE(m.moving.lean(c, atFault));
        }

        EXPECT_EQ(m.moving.layers().points, before);
    }
}


TEST(leaningColumns, stayWithoutFaults)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);

        EXPECT_FALSE(m.moving.lean(3, [](label, label, scalar) { return 0; }));
    }
}


TEST(leaningColumns, thoseThatStayAreNotMoved)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        m.moving.takeCandidates();
        m.moving.takeMoved();
        m.moving.lean(3, atFault);

        EXPECT_TRUE(m.moving.takeCandidates().empty());
        EXPECT_FALSE(m.moving.takeMoved().found(true));
    }
}


TEST(leaningColumns, facesAroundThoseThatLeanAreMoved)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        m.moving.takeCandidates();
        m.moving.takeMoved();

        for (const label c : someColumns(m, 15))
        {
            const labelList faces
            (
                m.moving.lean(c, awayFrom(m, c, m.end(c)))
              ? facesOf(m, labelList(1, c)) : labelList()
            );

            EXPECT_EQ(m.moving.takeCandidates(), faces);
            EXPECT_EQ(findIndices(m.moving.takeMoved(), true), faces);
        }
    }
}


TEST(leaningColumns, leanTenTimesAtMost)
{
    movableColumns m(fronts()[0]);
    label n = 0;

    // Each time better than before
    scalar fault = 1e10;
    while (n < 100 && m.moving.lean(3, [&](label, label, scalar)
    {
        return fault *= 0.9;
    }))
    {
        ++n;
    }

    EXPECT_EQ(n, 10);
}


TEST(leaningColumns, leanInsideTheirCones)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);

        for (const label c : someColumns(m, 15))
        {
            const point end(m.end(c));
            m.moving.lean(c, [&](label, label, scalar)
            {
                return 1/(1e-6 + mag(m.end(c) - end));
            });

            for (const vector& n : front.visibility.cornerNormals[c])
            {
                EXPECT_GT((m.end(c) - m.front.surface.points[c]) & n, 0);
            }
        }
    }
}


TEST(leaningColumns, turnThreeTimesAtMost)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        label n = 0;

        while (n < 100 && m.moving.turn(labelList(1, 3)))
        {
            ++n;
        }

        EXPECT_EQ(n, 3);
    }
}


TEST(leaningColumns, movedFacesAreThoseAroundColumnsThatTurn)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        m.moving.takeCandidates();
        m.moving.takeMoved();

        m.moving.turn(labelList(1, 3));
        labelList columns(front.addressing.pointPoints[3]);
        columns.append(3);

        const labelList faces(facesOf(m, columns));
        EXPECT_EQ(m.moving.takeCandidates(), faces);
        EXPECT_EQ(findIndices(m.moving.takeMoved(), true), faces);
    }
}


// ************************************************************************* //
