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
#include <vector>

#include "frontTriangle.H"
#include "prismQuality.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

typedef CGAL::Box_intersection_d::Box_with_info_d
<
    double,
    3,
    const frontTriangle*
> triangleBox;


//- Triangles of one level of a front face: 0 the wall, else the outer surface.
//  Those of the latter that are degenerate are intersections, those of the wall
//  are nothing that their neighbours are not.
static void addTriangles
(
    const prismLayers& layers,
    const label facei,
    const label level,
    std::vector<frontTriangle>& triangles,
    DynamicList<labelPair>& intersections
)
{
    const face& f = layers.faces[facei];

    for (label k = 1; k + 1 < f.size(); ++k)
    {
        frontTriangle t;
        t.frontFace = facei + (level ? layers.faces.size() : 0);

        const label columns[3] = {f[0], f[k], f[k + 1]};

        for (int j = 0; j < 3; ++j)
        {
            t.labels[j] = layers.pointLabel(columns[j], level);
            t.points[j] = layers(columns[j], level);
        }

        if (!t.degenerate())
        {
            triangles.push_back(t);
        }
        else if (level)
        {
            intersections.append(labelPair(t.frontFace, t.frontFace));
        }
    }
}


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

Foam::List<Foam::labelPair> Foam::findIntersections(const prismLayers& layers)
{
    return findIntersections(layers, boolList(layers.faces.size(), true));
}


Foam::List<Foam::labelPair> Foam::findIntersections
(
    const prismLayers& layers,
    const boolList& candidates
)
{
    DynamicList<labelPair> pairs;

    // Each pair has one of the first
    std::vector<frontTriangle> first, second;

    forAll(layers.faces, facei)
    {
        addTriangles
        (
            layers, facei, layers.nLayers,
            candidates[facei] ? first : second, pairs
        );
        addTriangles(layers, facei, 0, second, pairs);
    }

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

    return List<labelPair>(std::move(pairs));
}


// ************************************************************************* //
