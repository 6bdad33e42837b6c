/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "percentiles.H"
#include "FixedList.H"

#include <algorithm>
#include <cstring>

#if defined(__GLIBCXX__) && defined(_OPENMP)
#include <parallel/algorithm>
#endif

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The shares of the values that are looked for [%]
static const label nShares = 7;
static const scalar shares[nShares] = {0, 1, 5, 50, 95, 99, 100};

typedef FixedList<std::int64_t, nShares> ranks;


//- Index of the value of the nearest rank, in ascending order
static std::int64_t rankOf(const scalar percent, const std::int64_t n)
{
    return std::int64_t(0.01*percent*(n - 1) + 0.5);
}


//- An integer for each value, in the same order
static std::int64_t orderOf(const scalar value)
{
    std::int64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));

    return bits < 0 ? std::int64_t(std::uint64_t(1) << 63) - bits : bits;
}


static scalar valueOf(const std::int64_t order)
{
    const std::int64_t bits =
        order < 0 ? std::int64_t(std::uint64_t(1) << 63) - order : order;
    scalar value = 0;
    std::memcpy(&value, &bits, sizeof(value));

    return value;
}


//- As std::nth_element, on several threads if the library can do that
template<class Iterator>
static void setNthElement(Iterator first, Iterator nth, Iterator last)
{
    #if defined(__GLIBCXX__) && defined(_OPENMP)
    __gnu_parallel::nth_element(first, nth, last);
    #else
    std::nth_element(first, nth, last);
    #endif
}


//- The percentiles of the values of one process
static percentiles ofOneProcess(scalarField& values)
{
    percentiles result;

    // What is below a rank that was found need not be looked at again
    auto start = values.begin();

    const auto percentile = [&](const scalar percent)
    {
        const label rank = label(rankOf(percent, values.size()));

        setNthElement(start, values.begin() + rank, values.end());
        start = values.begin() + rank;

        return *start;
    };

    result.mean = average(values);
    result.min = percentile(0);
    result.p1 = percentile(1);
    result.p5 = percentile(5);
    result.p50 = percentile(50);
    result.p95 = percentile(95);
    result.p99 = percentile(99);
    result.max = percentile(100);

    return result;
}


//- Number of values of all processes that are not above bounds
static ranks countUpTo
(
    const scalarField& ascending,
    const ranks& bounds,
    const columnTeam& team
)
{
    ranks own;
    forAll(own, i)
    {
        own[i] = std::upper_bound
        (
            ascending.begin(), ascending.end(), valueOf(bounds[i])
        ) - ascending.begin();
    }

    return team.reduce(own, [](ranks a, const ranks& b)
    {
        forAll(a, i)
        {
            a[i] += b[i];
        }

        return a;
    });
}


//- The percentiles of the values of all processes: bounds on each percentile
//  are halved until they meet
static percentiles ofTeam
(
    scalarField& values,
    const std::int64_t n,
    const columnTeam& team
)
{
    std::sort(values.begin(), values.end());
    const scalar least = values.size() ? values.first() : GREAT;
    const scalar most = values.size() ? values.last() : -GREAT;
    ranks low(orderOf(team.reduce(least, minOp<scalar>())));
    ranks high(orderOf(team.reduce(most, maxOp<scalar>())));

    while (low != high)
    {
        ranks middle;
        forAll(middle, i)
        {
            // Differences may be beyond the largest signed integer
            const std::uint64_t width =
                std::uint64_t(high[i]) - std::uint64_t(low[i]);
            middle[i] = std::int64_t(std::uint64_t(low[i]) + width/2);
        }
        const ranks nUpTo(countUpTo(values, middle, team));
        forAll(middle, i)
        {
            const bool isEnough = nUpTo[i] > rankOf(shares[i], n);
            low[i] = isEnough || low[i] == high[i] ? low[i] : middle[i] + 1;
            high[i] = isEnough ? middle[i] : high[i];
        }
    }

    return percentiles
    {
        team.sum(values.size() ? Foam::sum(values) : scalar(0))/n,
        valueOf(low[0]), valueOf(low[1]), valueOf(low[2]), valueOf(low[3]),
        valueOf(low[4]), valueOf(low[5]), valueOf(low[6])
    };
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

percentiles makePercentiles(scalarField values, const columnTeam& team)
{
    const std::int64_t n = team.sum(std::int64_t(values.size()));

    return
        n == 0 ? percentiles()
      : team.isAlone() ? ofOneProcess(values)
      : ofTeam(values, n, team);
}

} // End namespace Foam

// ************************************************************************* //
