/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "poorStacks.H"
#include "prismQuality.H"
#include "stackHeights.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Share of the best scaled Jacobian from which the centre of a prism is surely
//  inside
static const scalar prismShare = 0.2;


static scalar bestJacobian
(
    const face& f,
    const pointField& points,
    const wallVisibility& visibility
)
{
    scalar worst = GREAT;

    forAll(f, k)
    {
        const vector next = points[f.nextLabel(k)] - points[f[k]];
        const vector prev = points[f.prevLabel(k)] - points[f[k]];

        worst = min
        (
            worst,
            ((next ^ prev) & visibility.cones[f[k]].axis)
           /max(mag(next)*mag(prev), VSMALL)
        );
    }

    return worst;
}


//- Those of the candidates, in their order, for which a test holds that many
//  threads can make at once
template<class Test>
static labelList selected(const labelUList& candidates, const Test& test)
{
    boolList holds(candidates.size(), false);

    #pragma omp parallel for schedule(dynamic, 64) \
        if (candidates.size() > 128)
    for (label i = 0; i < candidates.size(); ++i)
    {
        holds[i] = test(candidates[i]);
    }

    const labelList held(findIndices(holds, true));

    return labelList(UIndirectList<label>(candidates, held));
}


//- Share of a good Jacobian below which a stack is poorer
static scalar shareOfPoorness(const scalar poorness)
{
    if (poorness < 1)
    {
        return 1 - poorness;
    }

    return poorness < 2 ? (1 - poorness)/(2 - poorness) : -GREAT;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::scalarField Foam::bestJacobians
(
    const wallSurface& wall,
    const wallVisibility& visibility
)
{
    scalarField jacobians(wall.faces.size());

    forAll(jacobians, facei)
    {
        jacobians[facei] =
            bestJacobian(wall.faces[facei], wall.points, visibility);
    }

    return jacobians;
}


bool Foam::isPoor
(
    const prismLayers& layers,
    const label facei,
    const scalar bestJacobian,
    const scalar share
)
{
    const scalar smallest = share*bestJacobian;

    return worstJacobian(layers, facei, smallest) < smallest;
}


bool Foam::isPositiveStack(const prismLayers& layers, const label facei)
{
    for (label i = layers.nLayers; i > 0; --i)
    {
        if (!isPositive(layers, facei, i))
        {
            return false;
        }
    }

    return true;
}


Foam::scalar Foam::poorness
(
    const prismLayers& layers,
    const label facei,
    const scalar goodJacobian,
    const scalar enough,
    const label lowest
)
{
    // Faces without area on the wall have only to be positive
    const scalar good = max(goodJacobian, SMALL);
    const scalar smallest = shareOfPoorness(enough)*good;
    const scalar share = worstJacobian(layers, facei, smallest, lowest)/good;

    return share >= 0 ? max(1 - share, scalar(0)) : 1 - share/(1 - share);
}


Foam::labelList Foam::findPoorStacks
(
    const prismLayers& layers,
    const scalarField& bestJacobians,
    const labelUList& candidates,
    const scalar share
)
{
    return selected
    (
        candidates,
        [&](const label facei)
        {
            return isPoor(layers, facei, bestJacobians[facei], share);
        }
    );
}


Foam::labelList Foam::findUncertifiedStacks
(
    const prismLayers& layers,
    const labelUList& candidates
)
{
    return selected
    (
        candidates,
        [&](const label facei)
        {
            stackHeights stack(layers);
            stack.compute(facei);

            return min(stack.heights()) <= 0
                || !isPositiveStack(layers, facei);
        }
    );
}


Foam::labelList Foam::findOutlyingCentres
(
    const prismLayers& layers,
    const scalarField& bestJacobians,
    const labelUList& candidates,
    labelList& patience
)
{
    const labelList outlying
    (
        selected
        (
            candidates,
            [&](const label facei)
            {
                const bool isPrism = layers.faces[facei].size() == 3;
                const scalar best = isPrism ? bestJacobians[facei] : GREAT;

                return patience[facei] > 0
                    && isPoor(layers, facei, best, prismShare)
                    && !hasPositivePyramids(layers, facei);
            }
        )
    );

    for (const label facei : outlying)
    {
        --patience[facei];
    }

    return outlying;
}

// ************************************************************************* //
