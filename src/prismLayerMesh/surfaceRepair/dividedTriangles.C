/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dividedTriangles.H"
#include "bitSet.H"
#include "cgalMeshes.H"
#include "HashTable.H"
#include "triFace.H"
#include "unions.H"
#include "wallPredicates.H"

#include <algorithm>
#include <map>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace Foam
{

namespace
{

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

} // End anonymous namespace


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

pointField dividedTriangles::roundedPoints() const
{
    pointField result(points.size());
    forAll(result, p)
    {
        result[p] = rounded(points[p]);
    }

    return result;
}


std::vector<label> dividedTriangles::covering
(
    const faceList& triangles,
    const face& part,
    const label i
) const
{
    std::vector<label> found;
    if (inPlane[i].empty())
    {
        return found;
    }

    const triangle3 t = triangleOn(part);
    const point3 centre = CGAL::centroid(t[0], t[1], t[2]);
    for (const label j : inPlane[i])
    {
        if (triangleOn(triangles[j]).has_on(centre))
        {
            found.push_back(j);
        }
    }

    return found;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

point rounded(const point3& x)
{
    return point
    (
        CGAL::to_double(x.x()), CGAL::to_double(x.y()), CGAL::to_double(x.z())
    );
}


dividedTriangles divideTriangles(const wallSurface& surface)
{
    triangleDivider divider(surface);
    divider.findPartners(surface);

    return divider.divide();
}


dividedSurface divideAtIntersections(const wallSurface& surface)
{
    const dividedTriangles divided(divideTriangles(surface));
    DynamicList<face> faces(divided.parts.size());
    DynamicList<label> triangleOf(divided.parts.size());
    DynamicList<bool> covers(divided.parts.size());
    for (std::size_t k = 0; k < divided.parts.size(); ++k)
    {
        // The first of those that cover each other
        const label i = divided.triangleOf[k];
        const std::vector<label> others
        (
            divided.covering(surface.faces, divided.parts[k], i)
        );
        if (others.empty() || i < others.front())
        {
            faces.append(divided.parts[k]);
            triangleOf.append(i);
            covers.append(!others.empty());
        }
    }

    return dividedSurface
    {
        divided.roundedPoints(), faceList(std::move(faces)),
        labelList(std::move(triangleOf)), boolList(std::move(covers))
    };
}

} // End namespace Foam

// ************************************************************************* //
