/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>

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
static const std::ptrdiff_t cutoff = 4000;


static std::vector<triangleBox> boxes
(
    const std::vector<labelledTriangle>& triangles
)
{
    std::vector<triangleBox> result;
    result.reserve(triangles.size());

    for (const labelledTriangle& t : triangles)
    {
        const point low(min(t.points[0], min(t.points[1], t.points[2])));
        const point high(max(t.points[0], max(t.points[1], t.points[2])));

        result.emplace_back
        (
            CGAL::Bbox_3
            (
                low.x(), low.y(), low.z(), high.x(), high.y(), high.z()
            ),
            &t
        );
    }

    return result;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void addIntersections
(
    const std::vector<labelledTriangle>& first,
    const std::vector<labelledTriangle>& second,
    DynamicList<labelPair>& pairs
)
{
    // Those among the first, and those between the first and the second
    DynamicList<labelPair> among, between;

    const auto addTo = [](DynamicList<labelPair>& list)
    {
        return [&list](const triangleBox& a, const triangleBox& b)
        {
            if (intersect(*a.info(), *b.info()))
            {
                const label fa = a.info()->facei;
                const label fb = b.info()->facei;

                list.append(labelPair(min(fa, fb), max(fa, fb)));
            }
        };
    };

    #pragma omp parallel sections
    {
        #pragma omp section
        {
            auto a = boxes(first);

            CGAL::box_self_intersection_d
            (
                a.begin(), a.end(), addTo(among), cutoff
            );
        }

        #pragma omp section
        {
            auto a = boxes(first), b = boxes(second);

            CGAL::box_intersection_d
            (
                b.begin(), b.end(), a.begin(), a.end(), addTo(between), cutoff
            );
        }
    }

    pairs.append(among);
    pairs.append(between);

    std::sort(pairs.begin(), pairs.end());
    pairs.setSize(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
}

} // End namespace Foam

// ************************************************************************* //
