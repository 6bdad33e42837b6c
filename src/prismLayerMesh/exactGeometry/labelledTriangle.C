/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "labelledTriangle.H"
#include "boundBox.H"

#include <algorithm>
#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

namespace Foam
{

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point3;
typedef Kernel::Triangle_3 Triangle3;
typedef Kernel::Segment_3 Segment3;


static inline Point3 toPoint3(const point& p)
{
    return Point3(p.x(), p.y(), p.z());
}


static inline Point3 corner(const labelledTriangle& t, const int k)
{
    return toPoint3(t.points[k%3]);
}


static inline Triangle3 triangle3(const labelledTriangle& t)
{
    return Triangle3(corner(t, 0), corner(t, 1), corner(t, 2));
}


//- The edge opposite to corner k
static inline Segment3 edgeOpposite(const labelledTriangle& t, const int k)
{
    return Segment3(corner(t, k + 1), corner(t, k + 2));
}


//- On which side of the triangle's plane p is
static inline int side(const labelledTriangle& t, const point& p)
{
    return orientation(t.points[0], t.points[1], t.points[2], p);
}


// The filters below spare most pairs the exact predicates, which on flat walls
// would have to compute exactly nearly everywhere. A filter decides only if the
// sign is certain, by this bound in units u = 2^-53 of one rounding.
// Differences of coordinates are off by u of their size. A projection m & d, a
// sum of three products with such differences, is off by less than 6u of the
// sum of the magnitudes. The components of a cross product of differences are
// off by less than 4u of the sums of magnitudes, the vector a ^ b by less than
// 6u |a||b|, and (a ^ b) & (a ^ c) by less than 16u |a|^2 |b||c|. The bound is
// 32u. Products do not underflow; if they overflow, the comparisons are false.
static const scalar roundingError = 32*1.2e-16;


static inline scalar magnitude(const vector& m, const vector& u)
{
    return mag(m.x()*u.x()) + mag(m.y()*u.y()) + mag(m.z()*u.z());
}


//- Whether a plane of normal m certainly separates a (below) from b. If the
//  corners skipA and skipB are one point, the plane runs through that point,
//  the origin; both are -1 if there is no such point.
static bool apart
(
    const labelledTriangle& a,
    const labelledTriangle& b,
    const vector& m,
    const point& origin,
    const int skipA,
    const int skipB
)
{
    scalar highA = -VGREAT;
    scalar lowB = VGREAT;

    for (int k = 0; k < 3; ++k)
    {
        const vector u(a.points[k] - origin);
        const vector v(b.points[k] - origin);

        if (k != skipA)
        {
            highA = max(highA, (m & u) + roundingError*magnitude(m, u));
        }

        if (k != skipB)
        {
            lowB = min(lowB, (m & v) - roundingError*magnitude(m, v));
        }
    }

    return skipA < 0 ? highA < lowB : (highA < 0 && lowB > 0);
}


//- Triangles with a common edge, opposite to corners ka and kb, intersect if
//  one is folded onto the other
static bool intersectAtEdge
(
    const labelledTriangle& a,
    const int ka,
    const labelledTriangle& b,
    const int kb
)
{
    const point& start = a.points[(ka + 1)%3];
    const point& end = a.points[(ka + 2)%3];
    const vector edge(end - start);
    const vector u(a.points[ka] - start);
    const vector v(b.points[kb] - start);

    // On different sides of the edge, seen along the normals
    if (((edge ^ u) & (edge ^ v)) < -roundingError*magSqr(edge)*mag(u)*mag(v))
    {
        return false;
    }

    return
        !side(a, b.points[kb])
     && CGAL::coplanar_orientation
        (
            toPoint3(start), toPoint3(end), corner(a, ka), corner(b, kb)
        ) == CGAL::POSITIVE;
}


//- Whether the edge of a opposite to the common corner ka meets the plane of b
static bool reachesPlane
(
    const labelledTriangle& a,
    const int ka,
    const labelledTriangle& b
)
{
    const int start = side(b, a.points[(ka + 1)%3]);

    return !start || start != side(b, a.points[(ka + 2)%3]);
}


//- Triangles with one common point, corners ka and kb, intersect if the
//  opposite edge of one meets the other
static bool intersectAtPoint
(
    const labelledTriangle& a,
    const int ka,
    const labelledTriangle& b,
    const int kb
)
{
    const point& origin = a.points[ka];

    vector m(Zero);
    for (int k = 1; k < 3; ++k)
    {
        const vector u(a.points[(ka + k)%3] - origin);
        const vector v(b.points[(kb + k)%3] - origin);
        m += v/max(mag(v), VSMALL) - u/max(mag(u), VSMALL);
    }

    if (apart(a, b, m, origin, ka, kb))
    {
        return false;
    }

    return
        reachesPlane(a, ka, b)
     && reachesPlane(b, kb, a)
     && (
            CGAL::do_intersect(edgeOpposite(a, ka), triangle3(b))
         || CGAL::do_intersect(edgeOpposite(b, kb), triangle3(a))
        );
}


static bool intersectElsewhere
(
    const labelledTriangle& a,
    const labelledTriangle& b
)
{
    vector m(Zero);
    for (int k = 0; k < 3; ++k)
    {
        m += b.points[k] - a.points[k];
    }

    return
        !apart(a, b, m, a.points[0], -1, -1)
     && CGAL::do_intersect(triangle3(a), triangle3(b));
}


int orientation(const point& a, const point& b, const point& c, const point& d)
{
    return CGAL::orientation
    (
        toPoint3(a), toPoint3(b), toPoint3(c), toPoint3(d)
    );
}


int sideOfSphere
(
    const point& a,
    const point& b,
    const point& c,
    const point& d,
    const point& x
)
{
    return CGAL::side_of_oriented_sphere
    (
        toPoint3(a), toPoint3(b), toPoint3(c), toPoint3(d), toPoint3(x)
    );
}


bool isCollinear(const point& a, const point& b, const point& c)
{
    return CGAL::collinear(toPoint3(a), toPoint3(b), toPoint3(c));
}


std::vector<labelledTriangle> labelledTriangles
(
    const UList<face>& triangles,
    const pointField& points,
    const labelUList& faceLabels
)
{
    std::vector<labelledTriangle> list(triangles.size());

    forAll(triangles, i)
    {
        list[i].facei = faceLabels[i];

        for (label k = 0; k < 3; ++k)
        {
            list[i].labels[k] = triangles[i][k];
            list[i].points[k] = points[triangles[i][k]];
        }
    }

    return list;
}


bool intersect(const labelledTriangle& a, const labelledTriangle& b)
{
    // The number of common points, their last corners, and the sums of their
    // corners: the sum of two of the corners 0, 1, 2 tells the third
    int nCommon = 0, ka = 0, kb = 0, sumA = 0, sumB = 0;

    for (int i = 0; i < 3; ++i)
    {
        for (int j = 0; j < 3; ++j)
        {
            if (a.labels[i] == b.labels[j])
            {
                ++nCommon;
                ka = i;
                kb = j;
                sumA += i;
                sumB += j;
            }
        }
    }

    switch (nCommon)
    {
        case 0: return intersectElsewhere(a, b);
        case 1: return intersectAtPoint(a, ka, b, kb);
        case 2: return intersectAtEdge(a, 3 - sumA, b, 3 - sumB);
        default: return true;
    }
}


// * * * * * * * * * * * *  Triangle Intersections * * * * * * * * * * * * * //

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
//  each, and some more that are in several (benchmarks/numbers/README.md); with
//  fewer if there were less slabs than threads
static const std::size_t perSlab = 20000;
static const std::size_t leastPerSlab = 1000;
static const std::size_t fewSlabs = 16;

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
    const std::size_t n = std::max
    (
        triangles.size()/perSlab,
        std::min(triangles.size()/leastPerSlab, fewSlabs)
    );
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
