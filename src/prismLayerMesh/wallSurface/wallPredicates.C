/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>

#include <algorithm>
#include <vector>

#include "wallPredicates.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

typedef CGAL::Exact_predicates_inexact_constructions_kernel exactKernel;
typedef exactKernel::Point_3 exactPoint;
typedef exactKernel::Triangle_3 exactTriangle;
typedef exactKernel::Segment_3 exactSegment;
typedef CGAL::Surface_mesh<exactPoint> exactMesh;
typedef CGAL::Box_intersection_d::Box_with_info_d<double, 3, label> exactBox;


static exactPoint toExact(const point& p)
{
    return exactPoint(p.x(), p.y(), p.z());
}


//- Triangles of points that CGAL can read
struct exactSoup
{
    const pointField& coordinates;
    std::vector<exactPoint> points;
    labelList triangleFace;
    faceList triangles;

    explicit exactSoup(const wallSurface& wall)
    :
        coordinates(wall.points),
        triangles(wallTriangles(wall, triangleFace))
    {
        points.reserve(wall.points.size());

        for (const point& p : wall.points)
        {
            points.push_back(toExact(p));
        }
    }

    exactTriangle triangle(const label i) const
    {
        const face& t = triangles[i];

        return exactTriangle(points[t[0]], points[t[1]], points[t[2]]);
    }

    exactBox box(const label i) const
    {
        const face& t = triangles[i];

        return exactBox
        (
            points[t[0]].bbox() + points[t[1]].bbox() + points[t[2]].bbox(),
            i
        );
    }
};


//- s turned such that the points which it shares with t come first. Returns
//  their number.
static label sharedFirst(const face& s, const face& t, label turned[3])
{
    label nShared = 0;
    bool shared[3];

    for (label i = 0; i < 3; ++i)
    {
        shared[i] = (s[i] == t[0] || s[i] == t[1] || s[i] == t[2]);
        nShared += shared[i];
    }

    // The shared corner, or the corner after the one that is not shared
    label first = 0;
    while
    (
        (nShared == 1 && !shared[first])
     || (nShared == 2 && shared[(first + 2) % 3])
    )
    {
        ++first;
    }

    for (label i = 0; i < 3; ++i)
    {
        turned[i] = s[(first + i) % 3];
    }

    return nShared;
}


// The filters below spare most pairs the exact predicates. They are certain:
// differences of coordinates have relative errors of one rounding, so that
// products of them are off by less than this times the product of lengths.
static constexpr scalar rounding = 1e-14;


//- The triangles, of which none is the other's neighbour, lie on the two
//  sides of a plane
static bool areApart(const pointField& p, const face& s, const face& t)
{
    const point middle((p[s[0]] + p[s[1]] + p[s[2]])/3);
    const vector n((p[t[0]] + p[t[1]] + p[t[2]])/3 - middle);
    scalar high = -VGREAT, low = VGREAT, size = 0;

    for (label i = 0; i < 3; ++i)
    {
        const vector u(p[s[i]] - middle);
        const vector v(p[t[i]] - middle);
        high = max(high, u & n);
        low = min(low, v & n);
        size = max(size, max(magSqr(u), magSqr(v)));
    }

    return low - high > rounding*Foam::sqrt(size*magSqr(n));
}


//- The triangles, which share the point a[0] = b[0], lie on the two sides of
//  a plane through it
static bool pointAway
(
    const pointField& p,
    const label a[3],
    const label b[3]
)
{
    vector u[4];
    vector n(Zero);

    for (label i = 0; i < 4; ++i)
    {
        u[i] = (i < 2 ? p[a[i + 1]] - p[a[0]] : p[a[0]] - p[b[i - 1]]);
        u[i] /= mag(u[i]) + VSMALL;
        n += u[i];
    }

    for (label i = 0; i < 4; ++i)
    {
        if ((u[i] & n) < rounding*mag(n))
        {
            return false;
        }
    }

    return true;
}


//- The triangles, which share the side from a[0] to a[1], make an angle of
//  more than 90 degrees
static bool unfold(const pointField& p, const label a[3], const label b[3])
{
    const vector e(p[a[1]] - p[a[0]]);
    const vector u(p[a[2]] - p[a[0]]);
    const vector v(p[b[2]] - p[a[0]]);

    return
        ((e ^ u) & (e ^ v))
      < -rounding*magSqr(e)*Foam::sqrt(magSqr(u)*magSqr(v));
}


//- Whether two triangles meet elsewhere than in what they share by label
static bool intersect(const exactSoup& soup, const label i, const label j)
{
    const std::vector<exactPoint>& p = soup.points;
    const face& s = soup.triangles[i];
    const face& t = soup.triangles[j];
    label a[3], b[3];

    switch (sharedFirst(s, t, a))
    {
        case 0:
        {
            return
                !areApart(soup.coordinates, s, t)
             && CGAL::do_intersect(soup.triangle(i), soup.triangle(j));
        }
        case 1:
        {
            sharedFirst(t, s, b);
            const exactSegment u(p[a[1]], p[a[2]]), v(p[b[1]], p[b[2]]);

            // Beyond the common point, one's opposite side is in the other
            return
                !pointAway(soup.coordinates, a, b)
             && (
                    CGAL::do_intersect(u, soup.triangle(j))
                 || CGAL::do_intersect(v, soup.triangle(i))
                );
        }
        case 2:
        {
            sharedFirst(t, s, b);

            // One is folded flat on the other
            return
                !unfold(soup.coordinates, a, b)
             && CGAL::coplanar(p[a[0]], p[a[1]], p[a[2]], p[b[2]])
             && CGAL::coplanar_orientation(p[a[0]], p[a[1]], p[a[2]], p[b[2]])
             == CGAL::POSITIVE;
        }
    }

    return false;
}


static exactMesh toMesh(const exactSoup& soup)
{
    exactMesh mesh;
    mesh.reserve
    (
        soup.points.size(),
        3*soup.triangles.size()/2,
        soup.triangles.size()
    );

    for (const exactPoint& p : soup.points)
    {
        mesh.add_vertex(p);
    }

    typedef exactMesh::Vertex_index vertex;

    for (const face& t : soup.triangles)
    {
        mesh.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2]));
    }

    return mesh;
}


//- Whether the face of the mesh runs the other way than the triangle
static bool isTurned
(
    const exactMesh& mesh,
    const exactMesh::Face_index f,
    const face& triangle
)
{
    const exactMesh::Halfedge_index h = mesh.halfedge(f);
    const label a(mesh.source(h));
    const label b(mesh.target(h));

    return triangle[triangle.fcIndex(triangle.find(a))] != b;
}


//- Six times the volume, seen from the middle for the sake of rounding
static scalar sixVolumes(const wallSurface& wall)
{
    const point middle(average(wall.points));
    scalar sum = 0;

    for (const face& f : wall.faces)
    {
        const vector a(wall.points[f[0]] - middle);

        for (label i = 2; i < f.size(); ++i)
        {
            const vector b(wall.points[f[i - 1]] - middle);
            const vector c(wall.points[f[i]] - middle);
            sum += (a ^ b) & c;
        }
    }

    return sum;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool Foam::isCollinear(const point& a, const point& b, const point& c)
{
    return CGAL::collinear(toExact(a), toExact(b), toExact(c));
}


Foam::List<Foam::labelPair> Foam::findIntersectingFaces
(
    const wallSurface& wall,
    const bitSet& skip
)
{
    const exactSoup soup(wall);
    std::vector<exactBox> boxes;
    boxes.reserve(soup.triangles.size());

    forAll(soup.triangles, i)
    {
        if (!skip.test(soup.triangleFace[i]))
        {
            boxes.push_back(soup.box(i));
        }
    }

    DynamicList<labelPair> pairs;

    CGAL::box_self_intersection_d
    (
        boxes.begin(),
        boxes.end(),
        [&](const exactBox& one, const exactBox& other)
        {
            const label i = one.info();
            const label j = other.info();

            if (intersect(soup, i, j))
            {
                const label f = soup.triangleFace[i];
                const label g = soup.triangleFace[j];
                pairs.append(labelPair(min(f, g), max(f, g)));
            }
        }
    );

    // Two polygons can meet in several triangles
    std::sort(pairs.begin(), pairs.end());
    pairs.setSize
    (
        std::unique(pairs.begin(), pairs.end()) - pairs.begin()
    );

    return List<labelPair>(std::move(pairs));
}


Foam::bitSet Foam::findInwardComponents
(
    const wallSurface& wall,
    const labelUList& componentOfFace,
    const label nComponents
)
{
    bitSet inward(nComponents);

    if (nComponents == 1)
    {
        inward.set(0, sixVolumes(wall) < 0);

        return inward;
    }

    const exactSoup soup(wall);
    exactMesh mesh(toMesh(soup));
    CGAL::Polygon_mesh_processing::orient_to_bound_a_volume(mesh);

    forAll(soup.triangles, i)
    {
        if (isTurned(mesh, exactMesh::Face_index(i), soup.triangles[i]))
        {
            inward.set(componentOfFace[soup.triangleFace[i]]);
        }
    }

    return inward;
}


// ************************************************************************* //
