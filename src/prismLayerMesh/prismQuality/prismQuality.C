/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/


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


//- The columns of a front face, from below to above a layer
class layerCell
{
    const prismLayers& layers_;
    const face& columns_;
    const label level_;

public:

    layerCell(const prismLayers& layers, const label facei, const label i)
    :
        layers_(layers),
        columns_(layers.faces[facei]),
        level_(i)
    {}

    label size() const
    {
        return columns_.size();
    }

    const point& lower(const label k) const
    {
        return layers_(columns_[k], level_ - 1);
    }

    const point& upper(const label k) const
    {
        return layers_(columns_[k], level_);
    }
};


//- The twelve tetrahedra on four of six points: the three subsets that span a
//  side are left out. Six are the corners, six have one edge below, another
//  one above and the side edge that joins them.
static bool isPositivePrism(const layerCell& cell)
{
    const point* p[6];

    for (label k = 0; k < 3; ++k)
    {
        p[k] = &cell.lower(k);
        p[k + 3] = &cell.upper(k);
    }

    const tetSigns positive(p, 6);

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
            !positive(a, aNext, aPrev, b)
         || !positive(a, b, bNext, bPrev)
         || !positive(a, aNext, bPrev, b)
         || !positive(a, bNext, aPrev, b)
        )
        {
            return false;
        }
    }

    return true;
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


//- Lowest layer of the stack whose cell is not positive, or 0
static label lowestInvalidLayer(const prismLayers& layers, const label facei)
{
    for (label i = 1; i <= layers.nLayers; ++i)
    {
        if (!isPositive(layers, facei, i))
        {
            return i;
        }
    }

    return 0;
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

    return cell.size() == 3 ? isPositivePrism(cell) : hasPositiveCorners(cell);
}


Foam::scalar Foam::scaledJacobian
(
    const prismLayers& layers,
    const label facei,
    const label i
)
{
    const layerCell cell(layers, facei, i);
    const label n = cell.size();

    vector lowerBefore(cell.lower(0) - cell.lower(n - 1));
    vector upperBefore(cell.upper(0) - cell.upper(n - 1));
    scalar lowerLength = mag(lowerBefore);
    scalar upperLength = mag(upperBefore);

    scalar worst = GREAT;

    for (label k = 0; k < n; ++k)
    {
        const label next = k + 1 < n ? k + 1 : 0;

        const vector lower(cell.lower(next) - cell.lower(k));
        const vector upper(cell.upper(next) - cell.upper(k));
        const vector side(cell.upper(k) - cell.lower(k));

        const scalar lowerLengthBefore = lowerLength;
        const scalar upperLengthBefore = upperLength;
        lowerLength = mag(lower);
        upperLength = mag(upper);
        const scalar sideLength = mag(side);

        worst = min
        (
            worst,
            determinant(lowerBefore, lower, side)
           /max(lowerLengthBefore*lowerLength*sideLength, VSMALL)
        );
        worst = min
        (
            worst,
            determinant(upperBefore, upper, side)
           /max(upperLengthBefore*upperLength*sideLength, VSMALL)
        );

        lowerBefore = lower;
        upperBefore = upper;
    }

    return worst;
}


Foam::List<Foam::labelPair> Foam::findInvalidStacks(const prismLayers& layers)
{
    return findInvalidStacks(layers, identity(layers.faces.size()));
}


Foam::List<Foam::labelPair> Foam::findInvalidStacks
(
    const prismLayers& layers,
    const labelUList& candidates
)
{
    DynamicList<labelPair> invalid;

    for (const label facei : candidates)
    {
        const label i = lowestInvalidLayer(layers, facei);

        if (i)
        {
            invalid.append(labelPair(facei, i));
        }
    }

    sort(invalid);

    return List<labelPair>(std::move(invalid));
}


Foam::layerCertificate Foam::certify(const prismLayers& layers)
{
    layerCertificate certificate;
    certificate.nCells = layers.faces.size()*layers.nLayers;
    certificate.worstJacobian.setSize(layers.faces.size());

    forAll(layers.faces, facei)
    {
        scalar worst = GREAT;

        for (label i = 1; i <= layers.nLayers; ++i)
        {
            worst = min(worst, scaledJacobian(layers, facei, i));
            certificate.nInvalidCells += !isPositive(layers, facei, i);
        }

        certificate.worstJacobian[facei] = worst;
    }

    certificate.nIntersectingPairs = findIntersections(layers).size();

    return certificate;
}


// ************************************************************************* //
