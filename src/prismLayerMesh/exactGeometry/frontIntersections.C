/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>

#include "frontTriangle.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

typedef CGAL::Box_intersection_d::Box_with_info_d
<
    double,
    3,
    const frontTriangle*
> triangleBox;

//- Where CGAL turns from its segment tree to scanning: with triangles of a
//  surface much later than its default
static const std::ptrdiff_t cutoff = 4000;


static std::vector<triangleBox> boxes
(
    const std::vector<frontTriangle>& triangles
)
{
    std::vector<triangleBox> result;
    result.reserve(triangles.size());

    for (const frontTriangle& t : triangles)
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


//- Adds the faces of triangles that intersect to a list of pairs
class pairsOf
{
    DynamicList<labelPair>& pairs_;

public:

    explicit pairsOf(DynamicList<labelPair>& pairs)
    :
        pairs_(pairs)
    {}

    void operator()(const triangleBox& a, const triangleBox& b) const
    {
        if (intersect(*a.info(), *b.info()))
        {
            const label fa = a.info()->frontFace;
            const label fb = b.info()->frontFace;

            pairs_.append(labelPair(min(fa, fb), max(fa, fb)));
        }
    }
};


static void addIntersectionsAmong
(
    const std::vector<frontTriangle>& triangles,
    DynamicList<labelPair>& pairs
)
{
    std::vector<triangleBox> all(boxes(triangles));

    CGAL::box_self_intersection_d
    (
        all.begin(), all.end(), pairsOf(pairs), cutoff
    );
}


static void addIntersectionsBetween
(
    const std::vector<frontTriangle>& first,
    const std::vector<frontTriangle>& second,
    DynamicList<labelPair>& pairs
)
{
    std::vector<triangleBox> firstBoxes(boxes(first));
    std::vector<triangleBox> secondBoxes(boxes(second));

    CGAL::box_intersection_d
    (
        secondBoxes.begin(), secondBoxes.end(),
        firstBoxes.begin(), firstBoxes.end(),
        pairsOf(pairs), cutoff
    );
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::addIntersections
(
    const std::vector<frontTriangle>& first,
    const std::vector<frontTriangle>& second,
    DynamicList<labelPair>& pairs
)
{
    DynamicList<labelPair> others;

    #pragma omp parallel sections
    {
        #pragma omp section
        addIntersectionsAmong(first, pairs);

        #pragma omp section
        addIntersectionsBetween(first, second, others);
    }

    pairs.append(others);

    std::sort(pairs.begin(), pairs.end());
    pairs.setSize(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
}


// ************************************************************************* //
