/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "unions.H"
#include "bitSet.H"
#include "dividedTriangles.H"
#include "treeBoundBox.H"
#include "wallSides.H"

#include <algorithm>
#include <random>

namespace Foam
{

namespace
{

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
            const std::vector<label> others
            (
                divided_.covering(triangles_, f.points, f.triangle)
            );
            for (const label j : others)
            {
                const triangle3 part = divided_.triangleOn(f.points);
                const triangle3 other = divided_.triangleOn(triangles_[j]);
                const vector3 n = CGAL::normal(part[0], part[1], part[2]);
                isFirst = isFirst && f.triangle < j;
                f.jump +=
                    CGAL::normal(other[0], other[1], other[2])*n > 0 ? 1 : -1;
            }

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
    pointField points() const { return divided_.roundedPoints(); }

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
