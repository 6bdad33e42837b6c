/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heightLimits.H"
#include "DynamicList.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

class heightSweeps
{
    const heightLimits& given_;
    const layerMoveControls& controls_;

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
    //  False if it stays.
    bool lower(label c, scalar factor, scalar least);

    //- Lower the tallest columns of a face that is too high
    bool lowerTallest(label facei);

    //- Lower the columns of a face that another one does not have
    bool lowerBeside(label facei, label other);

public:

    heightSweeps
    (
        const heightLimits& given,
        const layerMoveControls& controls,
        label nColumns
    );

    //- False if nothing had to be lowered
    bool sweep();

    const scalarField& factors() const
    {
        return factors_;
    }
};


heightSweeps::heightSweeps
(
    const heightLimits& given,
    const layerMoveControls& controls,
    const label nColumns
)
:
    given_(given),
    controls_(controls),
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


bool heightSweeps::lower(const label c, const scalar factor, const scalar least)
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
         && lower(given_.faces[facei][k], level/h, 0);
    }

    return any;
}


bool heightSweeps::lowerBeside(const label facei, const label other)
{
    const face& f = given_.faces[facei];
    const scalar bound = controls_.maxHeightJump*faceHeights_[other];
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
        f.size()*bound - shared,
        nOwn*controls_.leastOverNeighbour*faceHeights_[other]
    );
    bool any = false;

    for (const label c : f)
    {
        any |=
            !given_.faces[other].found(c)
         && lower(c, lowered/max(own, VSMALL), controls_.leastForJump);
    }

    return any;
}


bool heightSweeps::sweep()
{
    bool any = false;

    forAll(given_.faces, facei)
    {
        if (faceHeights_[facei] > (1 + controls_.slack)*given_.largest[facei])
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
          > (1 + controls_.slack)*controls_.maxHeightJump*faceHeights_[low]
        )
        {
            any |= lowerBeside(high, low);
        }
    }

    return any;
}

}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalarField heightLimits::factors
(
    const label nColumns,
    const layerMoveControls& controls
) const
{
    heightSweeps sweeps(*this, controls, nColumns);

    for (label i = 0; i < controls.maxSweeps && sweeps.sweep(); ++i)
    {}

    return sweeps.factors();
}

} // End namespace Foam

// ************************************************************************* //
