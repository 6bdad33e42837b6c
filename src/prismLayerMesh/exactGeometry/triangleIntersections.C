/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>

#include "boundBox.H"
#include "labelledTriangle.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef CGAL::Box_intersection_d::Box_with_info_d
<
    double,
    3,
    const labelledTriangle*
> triangleBox;

//- Number of boxes below which CGAL scans rather than building its segment
//  tree; for triangles of a surface much more than its default
static const std::ptrdiff_t cutoff = 1000;

//- Triangles are looked at in slabs of space with about so many of the first
//  each, and some more that are in several (benchmarks/numbers/README.md)
static const std::size_t perSlab = 20000;

//- Slabs are chosen by so many triangles for each
static const std::size_t samplesPerSlab = 50;


typedef std::vector<const labelledTriangle*> triangleList;


static scalar lowest(const labelledTriangle& t, const direction axis)
{
    return min(t.points[0][axis], min(t.points[1][axis], t.points[2][axis]));
}


static scalar highest(const labelledTriangle& t, const direction axis)
{
    return max(t.points[0][axis], max(t.points[1][axis], t.points[2][axis]));
}


static std::vector<triangleBox> boxesOf(const triangleList& triangles)
{
    std::vector<triangleBox> boxes;
    boxes.reserve(triangles.size());

    for (const labelledTriangle* t : triangles)
    {
        boxes.emplace_back
        (
            CGAL::Bbox_3
            (
                lowest(*t, 0), lowest(*t, 1), lowest(*t, 2),
                highest(*t, 0), highest(*t, 1), highest(*t, 2)
            ),
            t
        );
    }

    return boxes;
}


static direction longestAxis(const std::vector<labelledTriangle>& triangles)
{
    boundBox box(boundBox::invertedBox);
    for (const labelledTriangle& t : triangles)
    {
        box.add(t.points[0]);
    }
    const vector span(triangles.empty() ? vector(Zero) : box.span());

    return
        span.x() >= max(span.y(), span.z()) ? vector::X
      : span.y() >= span.z() ? vector::Y : vector::Z;
}


//- Where slabs across an axis begin, but for the first one
static std::vector<scalar> slabStarts
(
    const std::vector<labelledTriangle>& triangles,
    const direction axis
)
{
    const std::size_t n = triangles.size()/perSlab;
    std::vector<scalar> samples;
    for (std::size_t i = 0; i < n*samplesPerSlab; ++i)
    {
        samples.push_back
        (
            lowest(triangles[i*triangles.size()/(n*samplesPerSlab)], axis)
        );
    }
    std::sort(samples.begin(), samples.end());

    std::vector<scalar> starts;
    for (std::size_t i = 1; i < n; ++i)
    {
        starts.push_back(samples[i*samplesPerSlab]);
    }

    return starts;
}


//- The triangles in each slab
static std::vector<triangleList> inSlabs
(
    const std::vector<labelledTriangle>& triangles,
    const std::vector<scalar>& starts,
    const direction axis
)
{
    std::vector<triangleList> slabs(starts.size() + 1);
    const auto slabOf = [&](const scalar x)
    {
        return std::upper_bound(starts.begin(), starts.end(), x)
          - starts.begin();
    };

    for (const labelledTriangle& t : triangles)
    {
        const auto last = slabOf(highest(t, axis));
        for (auto i = slabOf(lowest(t, axis)); i <= last; ++i)
        {
            slabs[i].push_back(&t);
        }
    }

    return slabs;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void addIntersections
(
    const std::vector<labelledTriangle>& first,
    const std::vector<labelledTriangle>& second,
    DynamicList<labelPair>& pairs
)
{
    const direction axis = longestAxis(first);
    const std::vector<scalar> starts(slabStarts(first, axis));
    const std::vector<triangleList> ofFirst(inSlabs(first, starts, axis));
    const std::vector<triangleList> ofSecond(inSlabs(second, starts, axis));

    // Of each slab those among the first, and those with the second
    const label nTasks = 2*ofFirst.size();
    List<DynamicList<labelPair>> found(nTasks);

    #pragma omp parallel for schedule(dynamic)
    for (label i = 0; i < nTasks; ++i)
    {
        const auto add = [&](const triangleBox& a, const triangleBox& b)
        {
            if (intersect(*a.info(), *b.info()))
            {
                const label fa = a.info()->facei;
                const label fb = b.info()->facei;

                found[i].append(labelPair(min(fa, fb), max(fa, fb)));
            }
        };

        if (i % 2 == 0)
        {
            auto a = boxesOf(ofFirst[i/2]);
            CGAL::box_self_intersection_d(a.begin(), a.end(), add, cutoff);
        }
        else if (ofSecond[i/2].size())
        {
            auto a = boxesOf(ofFirst[i/2]), b = boxesOf(ofSecond[i/2]);
            CGAL::box_intersection_d
            (
                b.begin(), b.end(), a.begin(), a.end(), add, cutoff
            );
        }
    }

    for (const DynamicList<labelPair>& list : found)
    {
        pairs.append(list);
    }

    std::sort(pairs.begin(), pairs.end());
    pairs.setSize(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
}

} // End namespace Foam

// ************************************************************************* //
