/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "layerCell.H"
#include "prismQuality.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static inline scalar determinant
(
    const vector& u,
    const vector& v,
    const vector& w
)
{
    return
        u.x()*(v.y()*w.z() - v.z()*w.y())
      + u.y()*(v.z()*w.x() - v.x()*w.z())
      + u.z()*(v.x()*w.y() - v.y()*w.x());
}


//- Signs of the tetrahedra of one cell: floating point where that is certain
class tetSigns
{
    // A determinant above this has the sign that was computed
    scalar errorBound_;

public:

    //- For tetrahedra on the given points. The bound: entries, differences of
    //  coordinates, are off by u = 2^-53 of their size; a product of three of
    //  them in the sum of six by less than 8u; so the sum by less than 48u
    //  times the largest such product, rounded up to 64u. Far from the limits
    //  of the exponent, so that no underflow can matter.
    tetSigns(const point* const* points, const label nPoints)
    {
        vector low(*points[0]), high(low);

        for (label i = 1; i < nPoints; ++i)
        {
            low = min(low, *points[i]);
            high = max(high, *points[i]);
        }

        const vector span(high - low);

        errorBound_ =
            cmptMin(span) > 1e-90 && cmptMax(span) < 1e90
          ? 64*1.2e-16*span.x()*span.y()*span.z()
          : VGREAT;
    }


    //- Whether the tetrahedron is positive; not so where a coordinate is NaN
    bool operator()
    (
        const point& a,
        const point& b,
        const point& c,
        const point& d
    ) const
    {
        const scalar det = determinant(b - a, c - a, d - a);

        return
            det > errorBound_
         || (det >= -errorBound_ && orientation(a, b, c, d) > 0);
    }
};


//- The twelve tetrahedra on four of six points: the three subsets that span a
//  side are left out. Six are the corners, six have one edge below, another
//  one above and the side edge that joins them.
template<class Corner, class Other>
static bool checkPrism
(
    const point* const* p,
    const Corner& corner,
    const Other& other
)
{
    for (label k = 0; k < 3; ++k)
    {
        const label next = (k + 1)%3;
        const label prev = (k + 2)%3;

        const point& a = *p[k];
        const point& b = *p[k + 3];
        const point& aNext = *p[next];
        const point& bNext = *p[next + 3];
        const point& aPrev = *p[prev];
        const point& bPrev = *p[prev + 3];

        if
        (
            !corner(a, aNext, aPrev, b)
         || !corner(a, b, bNext, bPrev)
         || !other(a, aNext, bPrev, b)
         || !other(a, bNext, aPrev, b)
        )
        {
            return false;
        }
    }

    return true;
}


static bool isPositivePrism(const layerCell& cell)
{
    const point* p[6];

    for (label k = 0; k < 3; ++k)
    {
        p[k] = &cell.lower(k);
        p[k + 3] = &cell.upper(k);
    }

    const tetSigns positive(p, 6);

    return checkPrism(p, positive, positive);
}


//- Layer 1 on a triangle without area: a prism of which two or three lower
//  points are one. Tetrahedra on two of these are none.
static bool isPositiveCollapsedPrism(const layerCell& cell)
{
    const point* p[6];

    for (label k = 0; k < 3; ++k)
    {
        p[k] = &cell.root(k);
        p[k + 3] = &cell.upper(k);
    }

    const tetSigns positive(p, 6);

    const auto none = [](const point& a, const point& b, const point& c)
    {
        return &a == &b || &b == &c || &c == &a;
    };
    const auto positiveOrNone =
        [&](const point& a, const point& b, const point& c, const point& d)
    {
        return none(a, b, c) || none(a, b, d) || positive(a, b, c, d);
    };

    return checkPrism(p, positiveOrNone, positiveOrNone);
}


//- Layer 1 on a quadrilateral without area: a prism that lies on an edge of the
//  wall, between the triangles at the edge's ends. Its corners are positive,
//  and what is left of it in one of the ways of cutting it.
static bool isPositiveLyingPrism(const layerCell& cell)
{
    // From the first point to the second are two columns on one point
    const label k = &cell.root(0) == &cell.root(1) ? 0 : 3;

    const point* p[6] =
    {
        &cell.root(k), &cell.upper(k), &cell.upper((k + 1)%4),
        &cell.root((k + 2)%4), &cell.upper((k + 3)%4), &cell.upper((k + 2)%4)
    };

    const tetSigns positive(p, 6);
    bool any = false;

    return checkPrism
    (
        p,
        positive,
        [&](const point& a, const point& b, const point& c, const point& d)
        {
            any = any || positive(a, b, c, d);
            return true;
        }
    ) && any;
}


static bool hasPositiveCorners(const layerCell& cell)
{
    const label n = cell.size();

    for (label k = 0; k < n; ++k)
    {
        const label next = (k + 1)%n;
        const label prev = (k + n - 1)%n;

        const point& a = cell.lower(k);
        const point& b = cell.upper(k);

        const point* p[6] =
        {
            &a, &cell.lower(next), &cell.lower(prev),
            &b, &cell.upper(next), &cell.upper(prev)
        };

        const tetSigns positive(p, 6);

        if
        (
            !positive(a, *p[1], *p[2], b)
         || !positive(a, b, *p[4], *p[5])
        )
        {
            return false;
        }
    }

    return true;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool Foam::isPositive
(
    const prismLayers& layers,
    const label facei,
    const label i
)
{
    const layerCell cell(layers, facei, i);

    if (i == 1 && facei >= layers.nWallFaces())
    {
        return
            cell.size() == 3
          ? isPositiveCollapsedPrism(cell) : isPositiveLyingPrism(cell);
    }

    return cell.size() == 3 ? isPositivePrism(cell) : hasPositiveCorners(cell);
}


// ************************************************************************* //
