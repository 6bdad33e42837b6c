/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "planeTriangulation.H"
#include "Map.H"
#include "error.H"

#include <map>
#include <set>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef CGAL::Exact_predicates_inexact_constructions_kernel planeKernel;
typedef CGAL::Triangulation_vertex_base_with_info_2<label, planeKernel>
    planeVertex;
typedef CGAL::Constrained_triangulation_face_base_2<planeKernel> planeFace;
typedef CGAL::Triangulation_data_structure_2<planeVertex, planeFace> planeData;
typedef CGAL::Constrained_Delaunay_triangulation_2
<
    planeKernel, planeData, CGAL::No_constraint_intersection_tag
> planeTriangles;


typedef std::set<std::pair<label, label>> edgePairs;

//- Ends of edges, as they run or in both directions
static edgePairs pairsOf(const UList<edge>& edges, const bool both)
{
    edgePairs pairs;
    for (const edge& e : edges)
    {
        pairs.insert({e.start(), e.end()});

        if (both)
        {
            pairs.insert({e.end(), e.start()});
        }
    }

    return pairs;
}


namespace
{

class planeTriangulator
{
    const pointField& points_;

    //- Directions of the coordinates, in the order of rotation about the
    //  normal; in a plane two of the axes, so that nothing is rounded
    vector first_;
    vector second_;

    planeTriangles triangles_;
    Map<planeTriangles::Vertex_handle> vertices_;


    planeTriangles::Vertex_handle vertex(const label p)
    {
        if (!vertices_.found(p))
        {
            const auto handle = triangles_.insert
            (
                planeKernel::Point_2(points_[p] & first_, points_[p] & second_)
            );
            handle->info() = p;
            vertices_.insert(p, handle);
        }

        return vertices_[p];
    }


    void insert(const edge& e)
    {
        try
        {
            triangles_.insert_constraint(vertex(e.start()), vertex(e.end()));
        }
        catch (const planeTriangles::Intersection_of_constraints_exception&)
        {
            FatalErrorInFunction
                << "The edge from " << points_[e.start()] << " to "
                << points_[e.end()] << " crosses another edge of its side"
                << " patch" << nl << "The border of the wall on the side patch"
                << " must not cross itself: check the surface there"
                << exit(FatalError);
        }
    }

public:

    planeTriangulator(const pointField& points, const planeRegion& region)
    :
        points_(points)
    {
        direction largest = 0;
        for (direction d = 1; d < 3; ++d)
        {
            if (mag(region.normal[d]) > mag(region.normal[largest]))
            {
                largest = d;
            }
        }

        const bool along = region.normal[largest] > 0;
        first_ = Zero;
        second_ = Zero;
        first_[(largest + (along ? 1 : 2)) % 3] = 1;
        second_[(largest + (along ? 2 : 1)) % 3] = 1;

        if (region.isCurved)
        {
            first_ = normalised(second_ ^ region.normal);
            second_ = region.normal ^ first_;
        }

        for (const label p : region.points)
        {
            vertex(p);
        }
        for (const edge& e : region.boundary)
        {
            insert(e);
        }
        for (const edge& e : region.limits)
        {
            insert(e);
        }
        for (const edge& e : region.edges)
        {
            insert(e);
        }
    }


    //- The triangles that are joined, across no edge of the boundary, to those
    //  on its left
    faceList inside(const planeRegion& region) const;
};


//- Edge i of a triangle, which is opposite to its vertex i
static std::pair<label, label> directed
(
    const planeTriangles::Face_handle f,
    const int i
)
{
    return std::make_pair
    (
        f->vertex((i + 1) % 3)->info(), f->vertex((i + 2) % 3)->info()
    );
}


faceList planeTriangulator::inside(const planeRegion& region) const
{
    const edgePairs boundary(pairsOf(region.boundary, false));
    edgePairs barrier(pairsOf(region.boundary, true));
    barrier.merge(pairsOf(region.limits, true));

    std::set<planeTriangles::Face_handle> visited;
    std::vector<planeTriangles::Face_handle> found;

    const auto visit = [&](const planeTriangles::Face_handle f)
    {
        if (triangles_.is_infinite(f))
        {
            FatalErrorInFunction
                << "The boundary of a side patch is not closed near "
                << points_[region.boundary[0].start()] << nl
                << "The border of the wall on the side patch must be closed:"
                << " check the surface there" << exit(FatalError);
        }
        if (visited.insert(f).second)
        {
            found.push_back(f);
        }
    };

    for (auto f : triangles_.finite_face_handles())
    {
        for (int i = 0; i < 3; ++i)
        {
            if (boundary.count(directed(f, i)))
            {
                visit(f);
            }
        }
    }

    DynamicList<face> result;
    for (std::size_t k = 0; k < found.size(); ++k)
    {
        const auto f = found[k];
        face t(3);

        for (int i = 0; i < 3; ++i)
        {
            t[i] = f->vertex(i)->info();

            if (!barrier.count(directed(f, i)))
            {
                visit(f->neighbor(i));
            }
        }
        result.append(t);
    }

    return faceList(std::move(result));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

DynamicList<edge> dividedEdges
(
    const pointField& points,
    const UList<edge>& edges,
    const labelUList& at,
    const scalar tolerance
)
{
    DynamicList<edge> divided(edges.size());
    for (const edge& e : edges)
    {
        const point& a = points[e.start()];
        const vector ab(points[e.end()] - a);
        std::map<scalar, label> along;

        for (const label p : at)
        {
            const vector ap(points[p] - a);
            const scalar t = (ap & ab)/magSqr(ab);

            if (!e.found(p) && t > 0 && t < 1 && mag(ap - t*ab) < tolerance)
            {
                along.insert({t, p});
            }
        }

        label start = e.start();
        for (const auto& next : along)
        {
            divided.append(edge(start, next.second));
            start = next.second;
        }
        divided.append(edge(start, e.end()));
    }

    return divided;
}


faceList triangulatePlane(const pointField& points, const planeRegion& region)
{
    return planeTriangulator(points, region).inside(region);
}

} // End namespace Foam

// ************************************************************************* //
