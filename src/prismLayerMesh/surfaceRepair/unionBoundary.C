/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "unionBoundary.H"
#include "bitSet.H"
#include "wallSides.H"
#include "windingNumber.H"

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

    void collectFacets();

    //- Sets the patch of each facet. The winding number is the same in front of
    //  all facets of a patch, and behind them. Returns the number of patches.
    label findPatches(labelList& patchOf) const;

public:

    explicit unionFacets(const wallSurface& surface);

    std::vector<facet> boundary();

    //- Points of all parts, rounded
    pointField points() const;

    //- Number of triangles that were divided, or are in the plane of another
    //  that they intersect
    label nDivided() const;
};


unionFacets::unionFacets(const wallSurface& surface)
:
    triangles_(surface.faces),
    divided_(divideTriangles(surface)),
    winding_(surface, divided_)
{}


void unionFacets::collectFacets()
{
    for (std::size_t k = 0; k < divided_.parts.size(); ++k)
    {
        facet f{divided_.parts[k], divided_.triangleOf[k], 1, 0};
        const std::vector<label>& others = divided_.inPlane[f.triangle];
        bool isFirst = true;

        if (!others.empty())
        {
            const triangle3 part = divided_.triangleOn(f.points);
            const point3 centre =
                CGAL::centroid(part[0], part[1], part[2]);
            const vector3 n = CGAL::normal(part[0], part[1], part[2]);

            for (const label j : others)
            {
                const triangle3 other = divided_.triangleOn(triangles_[j]);
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
            f.sqrArea = CGAL::to_double
            (
                divided_.triangleOn(f.points).squared_area()
            );
            facets_.push_back(f);
        }
    }
}


label unionFacets::findPatches(labelList& patchOf) const
{
    faceList faces(facets_.size());
    forAll(faces, i)
    {
        faces[i] = facets_[i].points;
    }
    const wallSides sides(makeWallSides(faces, divided_.points.size()));

    return findComponents(sides, faces.size(), patchOf, 2);
}


std::vector<facet> unionFacets::boundary()
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


pointField unionFacets::points() const
{
    pointField result(divided_.points.size());
    forAll(result, p)
    {
        result[p] = rounded(divided_.points[p]);
    }

    return result;
}


label unionFacets::nDivided() const
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

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
