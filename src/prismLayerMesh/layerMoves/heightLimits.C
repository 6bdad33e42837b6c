/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heightLimits.H"
#include "ListOps.H"
#include "stageProgress.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

class heightSweeps
{
    const heightLimits& given_;
    const layerMoveControls& controls_;
    const columnTeam& team_;

    //- Faces of each column, and indices of the pairs of neighbours with each
    //  face
    const labelListList columnFaces_;
    const labelListList facePairs_;

    scalarField factors_;
    scalarField faceHeights_;

    //- The factors that each face asks of its columns
    List<scalarList> asked_;

    scalar height(const label facei, const label k) const
    {
        return given_.heights[facei][k]*factors_[given_.faces[facei][k]];
    }

    void setFaceHeight(label facei);

    //- Ask for lower ones of the tallest columns of a face that is too high
    void askTallest(label facei);

    //- Ask for lower ones of the columns of a face that another face does not
    //  have
    void askBeside(label facei, label other);

    //- Ask what a face needs by the heights as they are
    void ask(label facei);

    //- The least factor that faces ask of a column
    scalar leastAsked(label c) const;

public:

    heightSweeps
    (
        const heightLimits& given,
        const layerMoveControls& controls,
        const columnTeam& team,
        label nColumns
    );

    //- Each own column takes the least factor that its faces ask for. False if
    //  none asked.
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
    const columnTeam& team,
    const label nColumns
)
:
    given_(given),
    controls_(controls),
    team_(team),
    columnFaces_(invertManyToMany<face, labelList>(nColumns, given.faces)),
    facePairs_
    (
        invertManyToMany<labelPair, labelList>
        (
            given.faces.size(), given.neighbours
        )
    ),
    factors_(nColumns, 1.0),
    faceHeights_(given.faces.size()),
    asked_(given.heights)
{}


void heightSweeps::setFaceHeight(const label facei)
{
    const label m = given_.faces[facei].size();
    faceHeights_[facei] = 0;

    for (label k = 0; k < m; ++k)
    {
        faceHeights_[facei] += height(facei, k)/m;
    }
}


void heightSweeps::askTallest(const label facei)
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

    for (label k = 0; k < m; ++k)
    {
        scalar& asked = asked_[facei][k];
        asked = min(asked, level/given_.heights[facei][k]);
    }
}


void heightSweeps::askBeside(const label facei, const label other)
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

    forAll(f, k)
    {
        if (!given_.faces[other].found(f[k]))
        {
            const scalar factor = factors_[f[k]]*lowered/max(own, VSMALL);
            scalar& asked = asked_[facei][k];
            asked = min(asked, max(factor, controls_.leastForJump));
        }
    }
}


void heightSweeps::ask(const label facei)
{
    asked_[facei] = 1.0;
    const scalar height = faceHeights_[facei]/(1 + controls_.slack);

    if (height > given_.largest[facei])
    {
        askTallest(facei);
    }

    for (const label pairi : facePairs_[facei])
    {
        const labelPair& pair = given_.neighbours[pairi];
        const label other = pair.other(facei);

        if (height > controls_.maxHeightJump*faceHeights_[other])
        {
            askBeside(facei, other);
        }
    }
}


scalar heightSweeps::leastAsked(const label c) const
{
    scalar least = 1;
    for (const label facei : columnFaces_[c])
    {
        least = min(least, asked_[facei][given_.faces[facei].find(c)]);
    }

    return least;
}


bool heightSweeps::sweep()
{
    bool any = false;

    #pragma omp parallel
    {
        #pragma omp for schedule(static, 256)
        forAll(given_.faces, facei)
        {
            setFaceHeight(facei);
        }

        #pragma omp for schedule(static, 256)
        forAll(given_.faces, facei)
        {
            ask(facei);
        }

        #pragma omp for schedule(static, 256) reduction(||: any)
        forAll(factors_, c)
        {
            const scalar least = team_.isOwn(c) ? leastAsked(c) : factors_[c];
            any = any || least < factors_[c];
            factors_[c] = min(factors_[c], least);
        }
    }

    team_.columns.update(factors_);

    return team_.any(any);
}

}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalarField heightLimits::factors
(
    const label nColumns,
    const layerMoveControls& controls,
    const columnTeam& team
) const
{
    heightSweeps sweeps(*this, controls, team, nColumns);

    repeatUntilStable
    (
        "limiting first heights", controls.maxSweeps,
        [&]() { return sweeps.sweep(); }
    );

    return sweeps.factors();
}

} // End namespace Foam

// ************************************************************************* //
