/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/


#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <vector>

#include "prismQuality.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


//- A triangle of the wall or of the outer surface
struct frontTriangle
{
    //- Labels, and the points themselves
    label labels[3];
    point points[3];

    //- As in the pairs of findIntersections
    label frontFace;

    Point3 point3(const int k) const
    {
        return toPoint3(points[k%3]);
    }

    Triangle3 triangle3() const
    {
        return Triangle3(point3(0), point3(1), point3(2));
    }

    //- The edge opposite to a corner
    Segment3 segment3(const int k) const
    {
        return Segment3(point3(k + 1), point3(k + 2));
    }

    bool degenerate() const
    {
        return CGAL::collinear(point3(0), point3(1), point3(2));
    }

    //- On which side of the triangle's plane p is
    int side(const point& p) const
    {
        return orientation(points[0], points[1], points[2], p);
    }
};


// Projections are sums of three products of differences of coordinates: off
// by less than 8*2^-53 of the sum of magnitudes. Coordinates are not so small
// that products underflow, or the comparisons are false.
static const scalar projectionError = 1e-15;

typedef CGAL::Box_intersection_d::Box_with_info_d
<
    double,
    3,
    const frontTriangle*
> triangleBox;


static inline scalar magnitude(const vector& m, const vector& u)
{
    return mag(m.x()*u.x()) + mag(m.y()*u.y()) + mag(m.z()*u.z());
}


//- Whether a plane of normal m through a corner of both, or between two without
//  a common corner, separates a (below) from b, certainly. Else the exact
//  predicates decide; on flat walls they would have to compute exactly nearly
//  everywhere, which is slow.
static bool apart
(
    const frontTriangle& a,
    const frontTriangle& b,
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
            highA = max(highA, (m & u) + projectionError*magnitude(m, u));
        }

        if (k != skipB)
        {
            lowB = min(lowB, (m & v) - projectionError*magnitude(m, v));
        }
    }

    return skipA < 0 ? highA < lowB : (highA < 0 && lowB > 0);
}


//- Triangles with a common edge, opposite to corners ka and kb, intersect when
//  one is folded onto the other
static bool intersectAtEdge
(
    const frontTriangle& a,
    const int ka,
    const frontTriangle& b,
    const int kb
)
{
    const point& start = a.points[(ka + 1)%3];
    const point& end = a.points[(ka + 2)%3];
    const vector edge(end - start);
    const vector u(a.points[ka] - start);
    const vector v(b.points[kb] - start);

    // On different sides of the edge, seen along the normals
    if
    (
        ((edge ^ u) & (edge ^ v))
      < -64*projectionError*magSqr(edge)*mag(u)*mag(v)
    )
    {
        return false;
    }

    return
        !a.side(b.points[kb])
     && CGAL::coplanar_orientation
        (
            toPoint3(start), toPoint3(end), a.point3(ka), b.point3(kb)
        ) == CGAL::POSITIVE;
}


//- Whether the edge of a opposite to its corner ka, the common one, meets the
//  plane of b
static bool reachesPlane
(
    const frontTriangle& a,
    const int ka,
    const frontTriangle& b
)
{
    const int start = b.side(a.points[(ka + 1)%3]);

    return !start || start != b.side(a.points[(ka + 2)%3]);
}


//- Triangles with one common point, corners ka and kb, intersect when the
//  opposite edge of one meets the other
static bool intersectAtPoint
(
    const frontTriangle& a,
    const int ka,
    const frontTriangle& b,
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
            CGAL::do_intersect(a.segment3(ka), b.triangle3())
         || CGAL::do_intersect(b.segment3(kb), a.triangle3())
        );
}


static bool intersectElsewhere(const frontTriangle& a, const frontTriangle& b)
{
    vector m(Zero);
    for (int k = 0; k < 3; ++k)
    {
        m += b.points[k] - a.points[k];
    }

    return
        !apart(a, b, m, a.points[0], -1, -1)
     && CGAL::do_intersect(a.triangle3(), b.triangle3());
}


static bool intersect(const frontTriangle& a, const frontTriangle& b)
{
    // Common points, the last such corners, and the sums of such corners: of
    // two of the corners 0, 1, 2 the sum tells the third
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


//- Triangles of one level: 0 the wall, else the outer surface. Those of the
//  latter that are degenerate are intersections, those of the wall are nothing
//  that their neighbours are not.
static std::vector<frontTriangle> trianglesOf
(
    const prismLayers& layers,
    const label level,
    DynamicList<labelPair>& intersections
)
{
    const label start = level ? layers.faces.size() : 0;

    std::vector<frontTriangle> triangles;
    triangles.reserve(layers.faces.size());

    forAll(layers.faces, facei)
    {
        const face& f = layers.faces[facei];

        for (label k = 1; k + 1 < f.size(); ++k)
        {
            frontTriangle t;
            t.frontFace = start + facei;

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

    return triangles;
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

int Foam::orientation
(
    const point& a,
    const point& b,
    const point& c,
    const point& d
)
{
    return CGAL::orientation
    (
        toPoint3(a), toPoint3(b), toPoint3(c), toPoint3(d)
    );
}


Foam::List<Foam::labelPair> Foam::findIntersections(const prismLayers& layers)
{
    DynamicList<labelPair> pairs;

    const auto wall = trianglesOf(layers, 0, pairs);
    const auto outer = trianglesOf(layers, layers.nLayers, pairs);
    std::vector<triangleBox> wallBoxes(boxes(wall));
    std::vector<triangleBox> outerBoxes(boxes(outer));

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
        outerBoxes.begin(), outerBoxes.end(), test, cutoff
    );
    CGAL::box_intersection_d
    (
        wallBoxes.begin(), wallBoxes.end(),
        outerBoxes.begin(), outerBoxes.end(),
        test, cutoff
    );

    std::sort(pairs.begin(), pairs.end());
    pairs.setSize(std::unique(pairs.begin(), pairs.end()) - pairs.begin());

    return List<labelPair>(std::move(pairs));
}


// ************************************************************************* //
