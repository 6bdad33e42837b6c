/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "changeRounds.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <omp.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- One of the values in a row is to be the sum of itself and its neighbour
struct additionInRow
{
    std::vector<label> tets;
    std::vector<label> around;
    label sum;
};


class rowOfValues
{
    const label mostStarts_;

public:

    //- Values by label, and the labels of all changes in their order
    std::vector<label> values;
    std::vector<label> starts;

    rowOfValues(const label n, const label mostStarts)
    :
        mostStarts_(mostStarts),
        values(n)
    {
        std::iota(values.begin(), values.end(), 1);
    }

    bool propose(const label i, additionInRow& change) const
    {
        change.tets = {i};
        change.around = {i + 1};
        change.sum = values[i] + values[i + 1];

        return i % 7;
    }

    bool asksAgain(label) const { return false; }

    void start(const additionInRow& change)
    {
        const label i = change.tets[0];
        EXPECT_EQ(change.sum, values[i] + values[i + 1]);
        starts.push_back(i);
    }

    void make(const additionInRow& change, std::vector<label>& next)
    {
        const label i = change.tets[0];
        values[i] = change.sum;
        if (i % 5 == 0)
        {
            next.push_back(i + 1);
        }
    }

    bool hasEnough() const { return label(starts.size()) >= mostStarts_; }
};


rowOfValues changed(const label mostStarts)
{
    rowOfValues row(101, mostStarts);
    std::vector<label> items(100);
    std::iota(items.begin(), items.end(), 0);
    changeRounds<label, additionInRow>(16).run(items, row);

    return row;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(changeRounds, makeEachChangeOnceAndThoseThatTheyAskFor)
{
    const rowOfValues row(changed(1000));
    std::vector<label> expected;
    for (label i = 0; i < 100; ++i)
    {
        if (i % 7)
        {
            expected.push_back(i);
            if (i % 5 == 0 && (i + 1) % 7)
            {
                expected.push_back(i + 1);
            }
        }
    }
    std::vector<label> starts(row.starts);
    std::sort(starts.begin(), starts.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(starts, expected);
}


TEST(changeRounds, areTheSameOnAnyNumberOfThreads)
{
    const label before = omp_get_max_threads();
    omp_set_num_threads(1);
    const rowOfValues first(changed(1000));
    for (const label n : {2, 3, 5})
    {
        omp_set_num_threads(n);
        const rowOfValues row(changed(1000));
        EXPECT_EQ(row.values, first.values) << n;
        EXPECT_EQ(row.starts, first.starts) << n;
    }
    omp_set_num_threads(before);
}


TEST(changeRounds, endWhereTheChangerHasEnough)
{
    const rowOfValues row(changed(20));
    EXPECT_GE(row.starts.size(), 20u);
    EXPECT_LT(row.starts.size(), 20u + 16u);
}


// ************************************************************************* //
