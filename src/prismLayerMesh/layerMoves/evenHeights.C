/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "evenHeights.H"
#include "DynamicList.H"
#include "labelList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Sweeps over all faces and neighbours at most; each carries a change at
//  least one face further
static const label maxSweeps = 100;

//- What is left of the height of a column at least where a face is too high,
//  and where it is higher than a neighbour: a first height that is right counts
//  for more than one that is even beside a place that is not
static const scalar leastForBound = 0.1;
static const scalar leastForNeighbour = 0.7;

//- Height to which columns are lowered at least, over that of the neighbour for
//  which they are
static const scalar lowestShare = 0.8;

//- Excess of a face that is let be
static const scalar slack = 1e-3;


class heightSweeps
{
    const evenHeights& given_;

    //- Faces of each column
    List<DynamicList<label>> columnFaces_;

    scalarField factors_;
    scalarField faceHeights_;

    scalar height(const label facei, const label k) const
    {
        return given_.heights[facei][k]*factors_[given_.faces[facei][k]];
    }

    void setFaceHeight(label facei);

    //- Lower a column by a factor, not below least of what it was at first.
    //  False where it stays.
    bool lower(label c, scalar factor, scalar least);

    //- Lower the tallest columns of a face that is too high
    bool lowerTallest(label facei);

    //- Lower the columns of a face that another one does not have
    bool lowerBeside(label facei, label other);


public:

    heightSweeps(const evenHeights& given, label nColumns);

    //- False where nothing had to be lowered
    bool sweep();

    const scalarField& factors() const
    {
        return factors_;
    }
};


heightSweeps::heightSweeps(const evenHeights& given, const label nColumns)
:
    given_(given),
    columnFaces_(nColumns),
    factors_(nColumns, 1.0),
    faceHeights_(given.faces.size())
{
    forAll(given_.faces, facei)
    {
        for (const label c : given_.faces[facei])
        {
            columnFaces_[c].append(facei);
        }
        setFaceHeight(facei);
    }
}


void heightSweeps::setFaceHeight(const label facei)
{
    const label m = given_.faces[facei].size();
    faceHeights_[facei] = 0;

    for (label k = 0; k < m; ++k)
    {
        faceHeights_[facei] += height(facei, k)/m;
    }
}


bool heightSweeps::lower
(
    const label c,
    const scalar factor,
    const scalar least
)
{
    const scalar lowered = max(factors_[c]*factor, least);

    if (lowered >= factors_[c])
    {
        return false;
    }

    factors_[c] = lowered;

    for (const label facei : columnFaces_[c])
    {
        setFaceHeight(facei);
    }

    return true;
}


bool heightSweeps::lowerTallest(const label facei)
{
    const label m = given_.faces[facei].size();
    const scalar sum = m*given_.largest[facei];

    // The level to which they come down: one after the other passes it
    scalar level = given_.largest[facei];

    for (label pass = 0; pass < m; ++pass)
    {
        scalar below = 0;
        label nAbove = 0;

        for (label k = 0; k < m; ++k)
        {
            const scalar h = height(facei, k);
            below += h <= level ? h : 0;
            nAbove += h > level;
        }

        level = nAbove ? (sum - below)/nAbove : level;
    }

    bool any = false;
    for (label k = 0; k < m; ++k)
    {
        const scalar h = height(facei, k);
        any |=
            h > level
         && lower(given_.faces[facei][k], level/h, leastForBound);
    }

    return any;
}


bool heightSweeps::lowerBeside(const label facei, const label other)
{
    const face& f = given_.faces[facei];
    const scalar bound = given_.maxChange*faceHeights_[other];
    scalar shared = 0, own = 0;
    label nOwn = 0;

    forAll(f, k)
    {
        const bool isShared = given_.faces[other].found(f[k]);
        (isShared ? shared : own) += height(facei, k);
        nOwn += !isShared;
    }

    // Not so low that they would be the low ones
    const scalar lowered = max
    (
        f.size()*bound - shared, nOwn*lowestShare*faceHeights_[other]
    );
    bool any = false;

    for (const label c : f)
    {
        any |=
            !given_.faces[other].found(c)
         && lower(c, lowered/max(own, VSMALL), leastForNeighbour);
    }

    return any;
}


bool heightSweeps::sweep()
{
    bool any = false;

    forAll(given_.faces, facei)
    {
        if (faceHeights_[facei] > (1 + slack)*given_.largest[facei])
        {
            any |= lowerTallest(facei);
        }
    }

    for (const labelPair& pair : given_.neighbours)
    {
        const bool firstIsHigher =
            faceHeights_[pair.first()] > faceHeights_[pair.second()];
        const label high = firstIsHigher ? pair.first() : pair.second();
        const label low = firstIsHigher ? pair.second() : pair.first();

        if
        (
            faceHeights_[high]
          > (1 + slack)*given_.maxChange*faceHeights_[low]
        )
        {
            any |= lowerBeside(high, low);
        }
    }

    return any;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::evenHeights::factors(const label nColumns) const
{
    heightSweeps sweeps(*this, nColumns);

    for (label i = 0; i < maxSweeps && sweeps.sweep(); ++i)
    {}

    return sweeps.factors();
}


// ************************************************************************* //
