/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "editedColumns.H"
#include "leanColumns.H"
#include "retreatColumns.H"
#include "scaledJacobian.H"

#include <gtest/gtest.h>
#include <omp.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- How far the ends of a face's columns are from a point
static stackPenalty distanceTo(const editedColumns& m, const point& x)
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


//- Lean one column. False where it stays.
static bool lean(editedColumns& m, const label c, const stackPenalty& fault)
{
    return leanColumns
    (
        m.editor, labelList(1, c), fault, m.controls.maxLeans, m.nTries
    ).size();
}


static scalar atFault(label, label, scalar)
{
    return 1;
}


//- None where the end of a column is not at a point
static stackPenalty awayFrom
(
    const editedColumns& m,
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
    const editedColumns& m,
    const label c,
    const stackPenalty& fault
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

TEST(leanColumns, columnsLeanToWhatFaultsAsk)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);

        for (const label c : someColumns(m, 10))
        {
            const vector across(normalised(vector(1, 2, 3)));
            const auto fault = distanceTo(m, m.end(c) + across);
            const scalar before = sumOf(m, c, fault);
            const point end(m.end(c));

            if (lean(m, c, fault))
            {
                EXPECT_LE(sumOf(m, c, fault), 0.98*before);
                EXPECT_GT(mag(m.end(c) - end), 0);
            }
        }
    }
}


TEST(leanColumns, leanWhereAnyPlaceIsBetter)
{
    // But for those that would be too long for their height
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);

        for (label c = 0; c < m.nColumns(); ++c)
        {
            const scalar heightCosine = front.visibility.heightCosine
            (
                c, front.visibility.cones[c].axis
            );

            if (heightCosine*editedColumns::maxStretch > 1.1)
            {
                EXPECT_TRUE(lean(m, c, awayFrom(m, c, m.end(c))));
            }
        }
    }
}


TEST(leanColumns, faultsNeverGrow)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const scalarField best
        (
            attainableJacobians(front.surface, front.visibility)
        );
        const auto fault = [&](label facei, label lowest, scalar enough)
        {
            return jacobianPenalty
            (
                m.editor.layers(), facei, 20*best[facei], enough, lowest
            );
        };

        for (label round = 0; round < 5; ++round)
        {
            const labelList some(someColumns(m, 15));
            retreatColumns(m.editor, some, squeezeCause::validity);

            for (const label c : some)
            {
                const scalar before = sumOf(m, c, fault);
                lean(m, c, fault);

                EXPECT_LE(sumOf(m, c, fault), before + 1e-10);
            }
        }
    }
}


//- Points of the layers after all columns leaned to one side
static pointField leantOver(const layerFront& front, const int nThreads)
{
    const int before = omp_get_max_threads();
    omp_set_num_threads(nThreads);

    editedColumns m(front);
    leanColumns
    (
        m.editor, identity(m.nColumns()), distanceBeside(m), 10, m.nTries
    );

    omp_set_num_threads(before);

    return m.editor.layers().points;
}


TEST(leanColumns, threadsChangeNothing)
{
    for (const layerFront& front : fronts())
    {
        const pointField points(leantOver(front, 1));

        EXPECT_EQ(leantOver(front, 2), points);
        EXPECT_EQ(leantOver(front, 5), points);
    }
}


TEST(leanColumns, manyThatLeanAtOnceAreNotInEachOthersWay)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const auto fault = distanceBeside(m);
        const auto sum = [&]()
        {
            scalar all = 0;
            forAll(front.surface.faces, facei)
            {
                all += fault(facei, 1, GREAT);
            }
            return all;
        };

        const scalar before = sum();
        const labelList leaned
        (
            leanColumns
            (
                m.editor, identity(m.nColumns()), fault, 10, m.nTries
            )
        );

        EXPECT_GT(leaned.size(), m.nColumns()/4);
        EXPECT_LT(sum(), 0.9*before);
    }
}


TEST(leanColumns, stayWhereNothingIsBetter)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const pointField before(m.editor.layers().points);

        for (label c = 0; c < m.nColumns(); ++c)
        {
            EXPECT_FALSE(lean(m, c, atFault));
        }

        EXPECT_LT(max(mag(m.editor.layers().points - before)), 1e-14);
    }
}


TEST(leanColumns, stayAlsoAfterTheyHaveMoved)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const labelList some(someColumns(m, 20));

        for (label round = 0; round < 3; ++round)
        {
            turnColumns(m.editor, some, m.nTurns);
            const label c = some[round];
            lean(m, c, awayFrom(m, c, m.end(c)));
            retreatColumns(m.editor, some, squeezeCause::validity);
        }

        const pointField before(m.editor.layers().points);
        for (label c = 0; c < m.nColumns(); ++c)
        {
            EXPECT_FALSE(lean(m, c, atFault));
        }

        EXPECT_EQ(m.editor.layers().points, before);
    }
}


TEST(leanColumns, stayWithoutFaults)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);

        EXPECT_FALSE(lean(m, 3, [](label, label, scalar) { return 0; }));
    }
}


TEST(leanColumns, thoseThatStayAreNotMoved)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const label now = m.editor.now();
        lean(m, 3, atFault);

        EXPECT_TRUE(m.editor.touchedSince(now).empty());
    }
}


TEST(leanColumns, facesAroundThoseThatLeanAreMoved)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);

        for (const label c : someColumns(m, 15))
        {
            const label now = m.editor.now();
            const labelList faces
            (
                lean(m, c, awayFrom(m, c, m.end(c)))
              ? facesOf(m, labelList(1, c)) : labelList()
            );

            EXPECT_EQ(m.editor.touchedSince(now), faces);
        }
    }
}


TEST(leanColumns, leanTenTimesAtMost)
{
    editedColumns m(fronts()[0]);
    label n = 0;

    // Each time better than before
    scalar fault = 1e10;
    while (n < 100 && lean(m, 3, [&](label, label, scalar)
    {
        return fault *= 0.9;
    }))
    {
        ++n;
    }

    EXPECT_EQ(n, 10);
}


TEST(leanColumns, leanInsideTheirCones)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);

        for (const label c : someColumns(m, 15))
        {
            const point end(m.end(c));
            lean(m, c, [&](label, label, scalar)
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


// ************************************************************************* //
