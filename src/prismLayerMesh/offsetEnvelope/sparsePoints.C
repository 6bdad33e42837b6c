/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sparsePoints.H"
#include "ranges.H"

#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Successive points of a batch are compared with all points before the batch,
//  on all threads, and then with each other
static constexpr label sparseBatch = 1024;


namespace
{

//- Points of the subset, in grids of cells: one for each power of two of the
//  distance, so wide that a ball of that distance reaches into no more than two
//  cells of each axis
class pointGrids
{
    const pointField& points_;
    const scalarField& distances_;

    std::unordered_map<std::uint64_t, label> first_;
    labelList next_;

    //- Levels of the points here, and the scale from coordinates to cells
    std::map<int, scalar> levels_;

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

    static std::int64_t cell(const scalar x, const scalar scale)
    {
        return std::int64_t(std::floor(scale*x));
    }

    //- Whether no point of a level is near to a point
    bool isFree(const label p, const int level, const scalar scale) const
    {
        const scalar radius =
            min(distances_[p], std::ldexp(scalar(1), level + 1));
        const point lo = points_[p] - point::uniform(radius);
        const point hi = points_[p] + point::uniform(radius);

        for (auto i = cell(lo.x(), scale); i <= cell(hi.x(), scale); ++i)
        for (auto j = cell(lo.y(), scale); j <= cell(hi.y(), scale); ++j)
        for (auto k = cell(lo.z(), scale); k <= cell(hi.z(), scale); ++k)
        {
            const auto found = first_.find(key(level, i, j, k));
            label q = found == first_.end() ? -1 : found->second;
            for (; q >= 0; q = next_[q])
            {
                if (areNear(p, q))
                {
                    return false;
                }
            }
        }

        return true;
    }

public:

    pointGrids(const pointField& points, const scalarField& distances)
    :
        points_(points),
        distances_(distances),
        next_(points.size(), -1)
    {}

    bool areNear(const label p, const label q) const
    {
        return magSqr(points_[q] - points_[p])
          < sqr(min(distances_[p], distances_[q]));
    }

    void insert(const label p)
    {
        const int level = std::ilogb(distances_[p]);
        const scalar scale = std::ldexp(scalar(1), -(level + 2));
        levels_[level] = scale;

        const point& x = points_[p];
        const std::uint64_t k = key
        (
            level, cell(x.x(), scale), cell(x.y(), scale), cell(x.z(), scale)
        );
        const auto found = first_.emplace(k, p);
        if (!found.second)
        {
            next_[p] = found.first->second;
            found.first->second = p;
        }
    }

    //- Whether no point here is near to a point
    bool isFree(const label p) const
    {
        // Most points are near to one of the same level
        const int own = std::ilogb(distances_[p]);
        const auto found = levels_.find(own);

        return
            (found == levels_.end() || isFree(p, own, found->second))
         && allOf(levels_, [&](const auto& level)
            {
                return level.first == own
                    || isFree(p, level.first, level.second);
            });
    }
};

} // End anonymous namespace

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList sparsePoints(const pointField& points, const scalarField& distances)
{
    pointGrids grids(points, distances);
    DynamicList<label> kept(points.size());
    boolList isFree(sparseBatch);
    for (label start = 0; start < points.size(); start += sparseBatch)
    {
        const label n = min(sparseBatch, points.size() - start);

        #pragma omp parallel for schedule(dynamic, 16)
        for (label i = 0; i < n; ++i)
        {
            isFree[i] = grids.isFree(start + i);
        }

        const label nBefore = kept.size();
        for (label p = start; p < start + n; ++p)
        {
            bool free = isFree[p - start];
            for (label k = nBefore; free && k < kept.size(); ++k)
            {
                free = !grids.areNear(p, kept[k]);
            }
            if (free)
            {
                kept.append(p);
            }
        }
        for (label k = nBefore; k < kept.size(); ++k)
        {
            grids.insert(kept[k]);
        }
    }

    return labelList(std::move(kept));
}

} // End namespace Foam

// ************************************************************************* //
