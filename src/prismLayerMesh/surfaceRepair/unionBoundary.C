/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "unionBoundary.H"
#include "divideTriangles.H"
#include "faceGroups.H"
#include "treeBoundBox.H"

#include <algorithm>
#include <random>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

typedef exactKernel::Point_3 point3;
typedef exactKernel::Triangle_3 triangle3;
typedef exactKernel::Vector_3 vector3;

//- A part of a triangle, and how much the winding number is larger behind it
//  than in front of it: at least 1
struct facet
{
    face points;
    label triangle;
    label jump;
};


//- Finds the facets on which the winding number changes from 0 to more
class unionFacets
{
    const faceList& triangles_;
    const dividedTriangles divided_;
    std::vector<treeBoundBox> boxes_;
    scalar size_;

    std::vector<facet> facets_;
    std::vector<scalar> areas_;

    triangle3 onPoints(const face& f) const
    {
        const std::vector<point3>& points = divided_.points;

        return triangle3(points[f[0]], points[f[1]], points[f[2]]);
    }

    void collectFacets();

    //- Returns groups of facets. The winding number is the same in front of all
    //  facets of a group, and behind them.
    std::vector<std::vector<label>> patches() const;

    //- Returns whether the number could be found along a direction
    bool windingAlong
    (
        const vector3& direction,
        const facet& f,
        label& number
    ) const;

    //- The winding number in front of a facet
    label windingInFront(const facet& f) const;

public:

    explicit unionFacets(const wallSurface& surface);

    std::vector<facet> boundary();

    //- Points of all parts, rounded
    pointField points() const;

    //- Whether each triangle was divided, or is in the plane of another that it
    //  intersects
    std::vector<bool> areDivided() const;
};


point rounded(const point3& x)
{
    return point
    (
        CGAL::to_double(x.x()), CGAL::to_double(x.y()), CGAL::to_double(x.z())
    );
}


unionFacets::unionFacets(const wallSurface& surface)
:
    triangles_(surface.faces),
    divided_(divideTriangles(surface)),
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


void unionFacets::collectFacets()
{
    for (std::size_t k = 0; k < divided_.parts.size(); ++k)
    {
        facet f{divided_.parts[k], divided_.triangleOf[k], 1};
        const std::vector<label>& others = divided_.inPlane[f.triangle];
        bool isFirst = true;

        if (!others.empty())
        {
            const triangle3 part = onPoints(f.points);
            const point3 centre =
                CGAL::centroid(part[0], part[1], part[2]);
            const vector3 n = CGAL::normal(part[0], part[1], part[2]);

            for (const label j : others)
            {
                const triangle3 other = onPoints(triangles_[j]);
                if (other.has_on(centre))
                {
                    isFirst = isFirst && f.triangle < j;
                    f.jump +=
                        CGAL::normal(other[0], other[1], other[2])*n > 0
                      ? 1
                      : -1;
                }
            }
        }

        if (f.jump < 0)
        {
            f.jump = -f.jump;
            f.points.flip();
        }
        if (isFirst && f.jump)
        {
            facets_.push_back(f);
            areas_.push_back
            (
                CGAL::to_double(onPoints(f.points).squared_area())
            );
        }
    }
}


std::vector<std::vector<label>> unionFacets::patches() const
{
    const edgeFaceMap onEdges
    (
        facesOnEdges
        (
            facets_.size(), [&](const label i) -> const face&
            {
                return facets_[i].points;
            }
        )
    );

    return groupsOf(facets_.size(), [&](const label i, const auto& visit)
    {
        for (const edge& e : facets_[i].points.edges())
        {
            const std::vector<label>& around = onEdges.at(ordered(e));
            if (around.size() == 2)
            {
                visit(around[0]);
                visit(around[1]);
            }
        }
    });
}


bool unionFacets::windingAlong
(
    const vector3& direction,
    const facet& f,
    label& number
) const
{
    const triangle3 part = onPoints(f.points);
    const point3 begin = CGAL::centroid(part[0], part[1], part[2]);
    const point3 end = begin + direction;
    const std::vector<label>& inPlane = divided_.inPlane[f.triangle];
    const point from = rounded(begin);
    const point to = from + 2*size_*normalised(rounded(end) - from);
    point hit;
    number = 0;

    forAll(triangles_, i)
    {
        if
        (
            i == f.triangle || !boxes_[i].intersects(from, to, hit)
         || std::binary_search(inPlane.begin(), inPlane.end(), i)
        )
        {
            continue;
        }

        const triangle3 t = onPoints(triangles_[i]);
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


label unionFacets::windingInFront(const facet& f) const
{
    const triangle3 part = onPoints(f.points);
    const vector3 n = CGAL::normal(part[0], part[1], part[2]);
    const vector normal =
        normalised(rounded(CGAL::ORIGIN + n) - point::zero);

    std::mt19937 random(f.triangle);
    std::uniform_real_distribution<scalar> share(-0.3, 0.3);
    label number = 0;

    for (;;)
    {
        const vector3 direction
        (
            normal.x() + share(random), normal.y() + share(random),
            normal.z() + share(random)
        );
        if (n*direction > 0 && windingAlong(direction, f, number))
        {
            return number;
        }
    }
}


std::vector<facet> unionFacets::boundary()
{
    collectFacets();
    std::vector<facet> result;

    for (const std::vector<label>& patch : patches())
    {
        const label largest = *std::max_element
        (
            patch.begin(), patch.end(), [&](const label i, const label j)
            {
                return areas_[i] < areas_[j];
            }
        );
        const facet& f = facets_[largest];
        const label inFront = windingInFront(f);

        if (inFront < 1 && inFront + f.jump >= 1)
        {
            for (const label i : patch)
            {
                result.push_back(facets_[i]);
            }
        }
    }

    return result;
}


pointField unionFacets::points() const
{
    pointField result(divided_.points.size());
    forAll(result, p)
    {
        result[p] = rounded(divided_.points[p]);
    }

    return result;
}


std::vector<bool> unionFacets::areDivided() const
{
    std::vector<label> nParts(triangles_.size(), 0);
    for (const label i : divided_.triangleOf)
    {
        ++nParts[i];
    }

    std::vector<bool> result(triangles_.size());
    forAll(triangles_, i)
    {
        result[i] = nParts[i] > 1 || !divided_.inPlane[i].empty();
    }

    return result;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

unionBoundary findUnionBoundary(const wallSurface& surface)
{
    unionFacets facets(surface);
    const std::vector<facet> boundary(facets.boundary());

    unionBoundary result;
    result.points = facets.points();
    result.faces.setSize(boundary.size());
    forAll(result.faces, i)
    {
        result.faces[i] = boundary[i].points;
        result.triangleOf.push_back(boundary[i].triangle);
    }
    result.isDivided = facets.areDivided();

    return result;
}

} // End namespace Foam

// ************************************************************************* //
