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

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::addIntersections
(
    const std::vector<frontTriangle>& first,
    const std::vector<frontTriangle>& second,
    DynamicList<labelPair>& pairs
)
{
    std::vector<triangleBox> firstBoxes(boxes(first));
    std::vector<triangleBox> secondBoxes(boxes(second));

    const auto test = [&pairs](const triangleBox& a, const triangleBox& b)
    {
        if (intersect(*a.info(), *b.info()))
        {
            const label fa = a.info()->frontFace;
            const label fb = b.info()->frontFace;

            pairs.append(labelPair(min(fa, fb), max(fa, fb)));
        }
    };

    // Where CGAL turns from its segment tree to scanning: with triangles of a
    // surface much later than its default
    const std::ptrdiff_t cutoff = 4000;

    CGAL::box_self_intersection_d
    (
        firstBoxes.begin(), firstBoxes.end(), test, cutoff
    );
    CGAL::box_intersection_d
    (
        secondBoxes.begin(), secondBoxes.end(),
        firstBoxes.begin(), firstBoxes.end(),
        test, cutoff
    );

    std::sort(pairs.begin(), pairs.end());
    pairs.setSize(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
}


// ************************************************************************* //
