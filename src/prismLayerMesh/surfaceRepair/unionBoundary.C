/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bitSet.H"
#include "cgalMeshes.H"
#include "HashTable.H"
#include "treeBoundBox.H"
#include "triFace.H"
#include "unions.H"
#include "wallPredicates.H"
#include "wallSides.H"

#include <algorithm>
#include <map>
#include <random>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace Foam
{

namespace
{

typedef CGAL::Exact_predicates_exact_constructions_kernel exactKernel;
typedef exactKernel::Point_3 point3;
typedef exactKernel::Triangle_3 triangle3;
typedef exactKernel::Vector_3 vector3;


point rounded(const point3& x)
{
    return point
    (
        CGAL::to_double(x.x()), CGAL::to_double(x.y()), CGAL::to_double(x.z())
    );
}


//- Projects a plane along the coordinate in which its normal is largest
class planeProjection
{
    const exactKernel::Plane_3 plane_;

    //- The coordinate that is dropped
    int dropped_ = 0;

public:

    explicit planeProjection(const exactKernel::Plane_3& plane)
    :
        plane_(plane)
    {
        const vector3 n = plane_.orthogonal_vector();
        for (int k = 1; k < 3; ++k)
        {
            if (CGAL::abs(n[k]) > CGAL::abs(n[dropped_]))
            {
                dropped_ = k;
            }
        }
    }

    //- Whether the projection turns triangles round
    bool turns() const
    {
        return plane_.orthogonal_vector()[dropped_] < 0;
    }

    exactKernel::Point_2 operator()(const point3& x) const
    {
        return exactKernel::Point_2
        (
            x[(dropped_ + 1) % 3], x[(dropped_ + 2) % 3]
        );
    }

    //- Returns the point of the plane that has this projection
    point3 inverse(const exactKernel::Point_2& x) const
    {
        const vector3 n = plane_.orthogonal_vector();
        const int i = (dropped_ + 1) % 3;
        const int j = (dropped_ + 2) % 3;
        exactKernel::FT c[3];
        c[i] = x[0];
        c[j] = x[1];
        c[dropped_] = -(n[i]*c[i] + n[j]*c[j] + plane_.d())/n[dropped_];

        return point3(c[0], c[1], c[2]);
    }
};


//- The arrangement of triangles that intersect: each triangle is divided along
//  its intersections with the others, by exact constructions. Two of the parts
//  have at most points and edges in common, except that parts in the same plane
//  may cover each other.
struct dividedTriangles
{
    //- The points of the surface, and then the points at which it is divided
    std::vector<point3> points;

    //- Parts of triangles, oriented as the triangles
    std::vector<face> parts;

    //- The triangle that each part belongs to. The parts of a triangle follow
    //  each other.
    std::vector<label> triangleOf;

    //- For each triangle: the triangles in its plane that intersect it, in
    //  ascending order
    std::vector<std::vector<label>> inPlane;

    triangle3 triangleOn(const face& f) const
    {
        return triangle3(points[f[0]], points[f[1]], points[f[2]]);
    }
};


//- A triangulation of a triangle's plane; its points know their labels
typedef CGAL::Triangulation_data_structure_2
<
    CGAL::Triangulation_vertex_base_with_info_2<label, exactKernel>,
    CGAL::Constrained_triangulation_face_base_2<exactKernel>
>
planeStructure;

typedef CGAL::Constrained_Delaunay_triangulation_2
<
    exactKernel, planeStructure, CGAL::Exact_intersections_tag
>
planeTriangulation;


//- The object of a type in what CGAL returns of an intersection, or null
template<class Type, class Variant>
const Type* alternative(const Variant& common)
{
    #if CGAL_VERSION_NR >= 1060000000
    return std::get_if<Type>(&common);
    #else
    return boost::get<Type>(&common);
    #endif
}


//- Returns pairs of triangles on the same three points
DynamicList<labelPair> onSamePoints(const faceList& triangles)
{
    HashTable<DynamicList<label>, triFace, triFace::Hash<>> groups
    (
        2*triangles.size()
    );
    DynamicList<labelPair> pairs;
    forAll(triangles, i)
    {
        DynamicList<label>& same = groups(triFace(triangles[i]));
        for (const label j : same)
        {
            pairs.append(labelPair(j, i));
        }
        same.append(i);
    }

    return pairs;
}


class triangleDivider
{
    const faceList& triangles_;
    dividedTriangles result_;

    //- Labels of the points on triangles that are divided
    std::map<point3, label> labels_;

    //- For each triangle: the triangles that intersect it
    std::vector<std::vector<label>> partners_;

    triangle3 triangle(const label i) const
    {
        return result_.triangleOn(triangles_[i]);
    }

    label labelOf(const point3& x)
    {
        const auto inserted = labels_.emplace(x, result_.points.size());
        if (inserted.second)
        {
            result_.points.push_back(x);
        }

        return inserted.first->second;
    }

    //- Adds the intersection with another triangle to a triangulation
    void insert
    (
        const triangle3& a,
        const triangle3& b,
        const planeProjection& project,
        planeTriangulation& plane
    ) const
    {
        const auto common = CGAL::intersection(a, b);
        if (!common)
        {
            return;
        }

        // The corners of the intersection, in their order around it
        std::vector<point3> corners;
        if (const auto* x = alternative<point3>(*common))
        {
            corners = {*x};
        }
        else if (const auto* s = alternative<exactKernel::Segment_3>(*common))
        {
            corners = {s->source(), s->target()};
        }
        else if (const auto* t = alternative<triangle3>(*common))
        {
            corners = {(*t)[0], (*t)[1], (*t)[2]};
        }
        else
        {
            corners = *alternative<std::vector<point3>>(*common);
        }

        auto last = plane.insert(project(corners.back()));
        for (const point3& x : corners)
        {
            const auto next = plane.insert(project(x));
            if (next != last)
            {
                plane.insert_constraint(last, next);
            }
            last = next;
        }
    }

    void divide(const label i)
    {
        const triangle3 t = triangle(i);
        const planeProjection project(t.supporting_plane());

        planeTriangulation plane;
        for (int k = 0; k < 3; ++k)
        {
            plane.insert_constraint(project(t[k]), project(t[(k + 1) % 3]));
        }
        for (const label j : partners_[i])
        {
            insert(t, triangle(j), project, plane);
        }

        for (const auto v : plane.finite_vertex_handles())
        {
            v->info() = labelOf(project.inverse(v->point()));
        }

        for (const auto f : plane.finite_face_handles())
        {
            face part{f->vertex(0)->info(), f->vertex(1)->info(),
                f->vertex(2)->info()};
            if (project.turns())
            {
                part.flip();
            }
            result_.parts.push_back(part);
            result_.triangleOf.push_back(i);
        }
    }

public:

    explicit triangleDivider(const wallSurface& surface)
    :
        triangles_(surface.faces),
        partners_(surface.faces.size())
    {
        result_.points = cgalPoints<point3>(surface.points);
        result_.inPlane.resize(triangles_.size());
    }

    //- Finds the triangles that intersect
    void findPartners(const wallSurface& surface)
    {
        DynamicList<labelPair> pairs(onSamePoints(triangles_));
        pairs.append(findIntersectingFaces(surface, bitSet(triangles_.size())));

        for (const labelPair& pair : pairs)
        {
            const label i = pair.first();
            const label j = pair.second();
            partners_[i].push_back(j);
            partners_[j].push_back(i);

            const exactKernel::Plane_3 plane = triangle(i).supporting_plane();
            const triangle3 other = triangle(j);
            if
            (
                plane.has_on(other[0]) && plane.has_on(other[1])
             && plane.has_on(other[2])
            )
            {
                result_.inPlane[i].push_back(j);
                result_.inPlane[j].push_back(i);
            }
        }

        for (std::vector<label>& others : result_.inPlane)
        {
            std::sort(others.begin(), others.end());
        }
    }

    dividedTriangles divide()
    {
        forAll(triangles_, i)
        {
            if (!partners_[i].empty())
            {
                for (const label p : triangles_[i])
                {
                    labels_.emplace(result_.points[p], p);
                }
            }
        }

        forAll(triangles_, i)
        {
            if (partners_[i].empty())
            {
                result_.parts.push_back(triangles_[i]);
                result_.triangleOf.push_back(i);
            }
            else
            {
                divide(i);
            }
        }

        return result_;
    }
};


//- Divides the triangles of a surface. All faces are triangles with area, and
//  no two points are equal.
dividedTriangles divideTriangles(const wallSurface& surface)
{
    triangleDivider divider(surface);
    divider.findPartners(surface);

    return divider.divide();
}


//- Calls visit(j) for the triangles that cover a part of triangle i
template<class Visit>
void visitCovering
(
    const dividedTriangles& divided,
    const faceList& triangles,
    const face& part,
    const label i,
    const Visit& visit
)
{
    const std::vector<label>& others = divided.inPlane[i];
    if (others.empty())
    {
        return;
    }

    const triangle3 t = divided.triangleOn(part);
    const point3 centre = CGAL::centroid(t[0], t[1], t[2]);
    for (const label j : others)
    {
        if (divided.triangleOn(triangles[j]).has_on(centre))
        {
            visit(j);
        }
    }
}


pointField roundedPoints(const dividedTriangles& divided)
{
    pointField result(divided.points.size());
    forAll(result, p)
    {
        result[p] = rounded(divided.points[p]);
    }

    return result;
}


// * * * * * * * * * * * * * *  Winding Number * * * * * * * * * * * * * * * //

//- The winding number of a surface in front of its triangles, exactly.
class windingNumber
{
    const faceList& triangles_;
    const dividedTriangles& divided_;

    //- Size of the surface [m], and the boxes of its triangles
    const scalar size_;
    std::vector<treeBoundBox> boxes_;

    //- Returns whether the number could be found along a direction: whether the
    //  ray runs through no edge of a triangle
    bool along
    (
        const vector3& direction,
        const face& part,
        const label triangle,
        label& number
    ) const
    {
        const triangle3 p = divided_.triangleOn(part);
        const point3 begin = CGAL::centroid(p[0], p[1], p[2]);
        const point3 end = begin + direction;
        const std::vector<label>& inPlane = divided_.inPlane[triangle];
        const point from = rounded(begin);
        const point to = from + 2*size_*normalised(rounded(end) - from);
        point hit;
        number = 0;

        forAll(triangles_, i)
        {
            if
            (
                i == triangle || !boxes_[i].intersects(from, to, hit)
             || std::binary_search(inPlane.begin(), inPlane.end(), i)
            )
            {
                continue;
            }

            const triangle3 t = divided_.triangleOn(triangles_[i]);
            label nSides[3] = {0, 0, 0};
            for (int k = 0; k < 3; ++k)
            {
                ++nSides[1 + CGAL::orientation(begin, end, t[k], t[k + 1])];
            }
            if (nSides[0] && nSides[2])
            {
                continue;
            }

            const vector3 n = CGAL::normal(t[0], t[1], t[2]);
            const int along = CGAL::sign(n*direction);
            const int side = CGAL::orientation(t[0], t[1], t[2], begin);
            if (side == 0 || along == side)
            {
                continue;
            }
            if (nSides[1] || along == 0)
            {
                // Through an edge of the triangle, or within its plane
                return false;
            }
            number += along;
        }

        return true;
    }

public:

    windingNumber(const wallSurface& surface, const dividedTriangles& divided)
    :
        triangles_(surface.faces),
        divided_(divided),
        size_(boundBox(surface.points, false).mag())
    {
        boxes_.reserve(triangles_.size());
        for (const face& f : triangles_)
        {
            treeBoundBox box(surface.points, f);
            box.min() -= vector::uniform(1e-9*size_);
            box.max() += vector::uniform(1e-9*size_);
            boxes_.push_back(box);
        }
    }

    //- Returns the winding number in front of a part of a triangle.
    //  part: points of the part, the normal pointing to the front
    label inFront(const face& part, const label triangle) const
    {
        const triangle3 p = divided_.triangleOn(part);
        const vector3 n = CGAL::normal(p[0], p[1], p[2]);
        const vector normal
        (
            normalised(rounded(CGAL::ORIGIN + n) - point::zero)
        );

        std::mt19937 random(triangle);
        std::uniform_real_distribution<scalar> share(-0.3, 0.3);
        label number = 0;

        for (;;)
        {
            const vector3 direction
            (
                normal.x() + share(random), normal.y() + share(random),
                normal.z() + share(random)
            );
            if (n*direction > 0 && along(direction, part, triangle, number))
            {
                return number;
            }
        }
    }
};


// * * * * * * * * * * * * * *  Union Boundary * * * * * * * * * * * * * * * //

//- A part of a triangle, and how much the winding number is larger behind it
//  than in front of it: at least 1
struct facet
{
    face points;
    label triangle;
    label jump;

    //- Square of the area [m4]
    scalar sqrArea;
};


//- Finds the facets on which the winding number changes from 0 to more
class unionFacets
{
    const faceList& triangles_;
    const dividedTriangles divided_;
    const windingNumber winding_;

    std::vector<facet> facets_;

    void collectFacets()
    {
        for (std::size_t k = 0; k < divided_.parts.size(); ++k)
        {
            facet f{divided_.parts[k], divided_.triangleOf[k], 1, 0};
            bool isFirst = true;
            const auto count = [&](const label j)
            {
                const triangle3 part = divided_.triangleOn(f.points);
                const triangle3 other = divided_.triangleOn(triangles_[j]);
                const vector3 n = CGAL::normal(part[0], part[1], part[2]);
                isFirst = isFirst && f.triangle < j;
                f.jump +=
                    CGAL::normal(other[0], other[1], other[2])*n > 0 ? 1 : -1;
            };
            visitCovering(divided_, triangles_, f.points, f.triangle, count);

            if (f.jump < 0)
            {
                f.jump = -f.jump;
                f.points.flip();
            }
            if (isFirst && f.jump)
            {
                f.sqrArea = CGAL::to_double
                (
                    divided_.triangleOn(f.points).squared_area()
                );
                facets_.push_back(f);
            }
        }
    }

    //- Sets the patch of each facet. The winding number is the same in front of
    //  all facets of a patch, and behind them. Returns the number of patches.
    label findPatches(labelList& patchOf) const
    {
        faceList faces(facets_.size());
        forAll(faces, i)
        {
            faces[i] = facets_[i].points;
        }
        const wallSides sides(makeWallSides(faces, divided_.points.size()));

        return findComponents(sides, faces.size(), patchOf, 2);
    }

public:

    explicit unionFacets(const wallSurface& surface)
    :
        triangles_(surface.faces),
        divided_(divideTriangles(surface)),
        winding_(surface, divided_)
    {}

    std::vector<facet> boundary()
    {
        collectFacets();
        labelList patchOf;
        labelList largest(findPatches(patchOf), -1);
        forAll(patchOf, i)
        {
            label& l = largest[patchOf[i]];
            l = l < 0 || facets_[l].sqrArea < facets_[i].sqrArea ? i : l;
        }

        boolList isBoundary(largest.size());
        forAll(largest, patchi)
        {
            const facet& f = facets_[largest[patchi]];
            const label inFront = winding_.inFront(f.points, f.triangle);
            isBoundary[patchi] = inFront < 1 && inFront + f.jump >= 1;
        }

        std::vector<facet> result;
        forAll(patchOf, i)
        {
            if (isBoundary[patchOf[i]])
            {
                result.push_back(facets_[i]);
            }
        }

        return result;
    }

    //- Points of all parts, rounded
    pointField points() const { return roundedPoints(divided_); }

    //- Number of triangles that were divided, or are in the plane of another
    //  that they intersect
    label nDivided() const
    {
        labelList nParts(triangles_.size(), Zero);
        for (const label i : divided_.triangleOf)
        {
            ++nParts[i];
        }

        label n = 0;
        forAll(nParts, i)
        {
            n += nParts[i] > 1 || !divided_.inPlane[i].empty();
        }

        return n;
    }
};


} // End anonymous namespace


dividedSurface divideAtIntersections(const wallSurface& surface)
{
    const dividedTriangles divided(divideTriangles(surface));
    DynamicList<face> faces(divided.parts.size());
    DynamicList<label> triangleOf(divided.parts.size());
    for (std::size_t k = 0; k < divided.parts.size(); ++k)
    {
        const label i = divided.triangleOf[k];
        bool isFirst = true;
        visitCovering
        (
            divided, surface.faces, divided.parts[k], i,
            [&](const label j) { isFirst = isFirst && i < j; }
        );
        if (isFirst)
        {
            faces.append(divided.parts[k]);
            triangleOf.append(i);
        }
    }

    return dividedSurface
    {
        roundedPoints(divided), faceList(std::move(faces)),
        labelList(std::move(triangleOf))
    };
}


unionBoundary findUnionBoundary(const wallSurface& surface)
{
    unionFacets facets(surface);
    const std::vector<facet> boundary(facets.boundary());

    bitSet isThere(surface.faces.size());
    unionBoundary result;
    result.points = facets.points();
    result.faces.setSize(boundary.size());
    forAll(result.faces, i)
    {
        result.faces[i] = boundary[i].points;
        isThere.set(boundary[i].triangle);
    }
    result.nDivided = facets.nDivided();
    result.nInside = isThere.size() - isThere.count();

    return result;
}

} // End namespace Foam

// ************************************************************************* //
