/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sparsePoints.H"
#include "ranges.H"

#include <cmath>
#include <cstdint>
#include <set>
#include <unordered_map>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Grids of cells, one for each power of two of the distance, so wide that a
//  ball of that distance reaches into no more than two cells of each axis
class pointGrids
{
    std::unordered_map<std::uint64_t, label> first_;
    labelList next_;
    std::set<int> levels_;

    static std::uint64_t mixed(std::uint64_t h, std::int64_t k)
    {
        h ^= std::uint64_t(k) + 0x9e3779b97f4a7c15ull + (h << 6) + (h >> 2);
        return h*0xbf58476d1ce4e5b9ull;
    }

    static std::uint64_t key
    (
        int level,
        std::int64_t i,
        std::int64_t j,
        std::int64_t k
    )
    {
        return mixed(mixed(mixed(mixed(17, level), i), j), k);
    }

    static std::int64_t cell(const scalar x, const int level)
    {
        return std::int64_t(std::floor(std::ldexp(x, -(level + 2))));
    }

public:

    explicit pointGrids(const label nPoints)
    :
        next_(nPoints, -1)
    {}

    static int level(const scalar distance)
    {
        return std::ilogb(distance);
    }

    const std::set<int>& levels() const
    {
        return levels_;
    }

    void insert(const label pointi, const point& x, const int level)
    {
        levels_.insert(level);

        const std::uint64_t k =
            key(level, cell(x.x(), level), cell(x.y(), level),
                cell(x.z(), level));

        const auto found = first_.emplace(k, pointi);
        if (!found.second)
        {
            next_[pointi] = found.first->second;
            found.first->second = pointi;
        }
    }

    //- Whether test(label) holds for a point in the cells around x
    template<class Test>
    bool any
    (
        const point& x,
        const scalar radius,
        const int level,
        const Test& test
    ) const
    {
        const point lo = x - point::uniform(radius);
        const point hi = x + point::uniform(radius);

        for (auto i = cell(lo.x(), level); i <= cell(hi.x(), level); ++i)
        for (auto j = cell(lo.y(), level); j <= cell(hi.y(), level); ++j)
        for (auto k = cell(lo.z(), level); k <= cell(hi.z(), level); ++k)
        {
            const auto found = first_.find(key(level, i, j, k));

            if (found == first_.end())
            {
                continue;
            }

            for (label q = found->second; q >= 0; q = next_[q])
            {
                if (test(q))
                {
                    return true;
                }
            }
        }

        return false;
    }
};

} // End anonymous namespace

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList sparsePoints(const pointField& points, const scalarField& distances)
{
    pointGrids grids(points.size());
    DynamicList<label> kept(points.size());
    forAll(points, p)
    {
        auto near = [&](const label q)
        {
            return magSqr(points[q] - points[p])
              < sqr(min(distances[p], distances[q]));
        };

        const auto isFree = [&](const int level)
        {
            const scalar radius =
                min(distances[p], std::ldexp(scalar(1), level + 1));

            return !grids.any(points[p], radius, level, near);
        };

        // Most points are near to one of the same level
        const int own = pointGrids::level(distances[p]);
        const bool free =
            (!grids.levels().count(own) || isFree(own))
         && allOf(grids.levels(), [&](const int level)
            {
                return level == own || isFree(level);
            });

        if (free)
        {
            grids.insert(p, points[p], own);
            kept.append(p);
        }
    }

    return labelList(std::move(kept));
}

} // End namespace Foam

// ************************************************************************* //
