/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetAddressing.H"

#include <algorithm>
#include <array>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Sorts items by a first point, which makes buckets of a few items each, and
//  by the rest of their points
template<class Rest>
class pointBuckets
{
    typedef std::pair<Rest, label> keyed;

    labelList starts_;
    List<keyed> keys_;

public:

    //- Sorts n items into buckets by their first points.
    //  keyOf(i): returns the first point of item i, and the rest of its points
    template<class KeyOf>
    pointBuckets(const label nPoints, const label n, const KeyOf& keyOf)
    :
        starts_(nPoints + 1, 0),
        keys_(n)
    {
        for (label i = 0; i < n; ++i)
        {
            ++starts_[keyOf(i).first + 1];
        }
        for (label p = 0; p < nPoints; ++p)
        {
            starts_[p + 1] += starts_[p];
        }

        labelList ends(starts_);
        for (label i = 0; i < n; ++i)
        {
            const std::pair<label, Rest> key(keyOf(i));
            keys_[ends[key.first]++] = keyed(key.second, i);
        }
        #pragma omp parallel for schedule(dynamic, 1024)
        for (label p = 0; p < nPoints; ++p)
        {
            std::sort
            (
                keys_.begin() + starts_[p], keys_.begin() + starts_[p + 1]
            );
        }
    }

    //- Calls visit(rest, i, isNew) for the items of a point in their order;
    //  isNew is false if the last one was equal
    template<class Visit>
    void visit(const label p, const Visit& visit) const
    {
        for (label k = starts_[p]; k < starts_[p + 1]; ++k)
        {
            const bool isNew =
                k == starts_[p] || keys_[k].first != keys_[k - 1].first;
            visit(keys_[k].first, keys_[k].second, isNew);
        }
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

List<FixedList<label, 4>> tetNeighbours
(
    const tetCellList& tets,
    const label nPoints
)
{
    typedef std::array<label, 2> twoPoints;

    const pointBuckets<twoPoints> buckets
    (
        nPoints, 4*tets.size(),
        [&](const label k)
        {
            const tetCell& tet = tets[k/4];
            label f[3] =
                {tet[(k + 1) % 4], tet[(k + 2) % 4], tet[(k + 3) % 4]};
            std::sort(f, f + 3);
            return std::make_pair(f[0], twoPoints{f[1], f[2]});
        }
    );
    List<FixedList<label, 4>> neighbours(tets.size(), FixedList<label, 4>(-1));

    #pragma omp parallel for schedule(dynamic, 1024)
    for (label p = 0; p < nPoints; ++p)
    {
        label last = -1;

        buckets.visit
        (
            p,
            [&](const twoPoints&, const label k, const bool isNew)
            {
                if (!isNew)
                {
                    neighbours[k/4][k % 4] = last/4;
                    neighbours[last/4][last % 4] = k/4;
                }
                last = k;
            }
        );
    }

    return neighbours;
}


void setTetEdges
(
    const tetCellList& tets,
    const label nPoints,
    edgeList& edges,
    List<FixedList<label, 6>>& tetEdges
)
{
    static const label ends[6][2] =
        {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

    const pointBuckets<label> buckets
    (
        nPoints, 6*tets.size(),
        [&](const label k)
        {
            const label p = tets[k/6][ends[k % 6][0]];
            const label q = tets[k/6][ends[k % 6][1]];
            return std::make_pair(min(p, q), max(p, q));
        }
    );
    DynamicList<edge> found(2*tets.size());
    tetEdges.setSize(tets.size());

    for (label p = 0; p < nPoints; ++p)
    {
        buckets.visit
        (
            p,
            [&](const label q, const label k, const bool isNew)
            {
                if (isNew)
                {
                    found.append(edge(p, q));
                }
                tetEdges[k/6][k % 6] = found.size() - 1;
            }
        );
    }

    edges.transfer(found);
}

} // End namespace Foam

// ************************************************************************* //
