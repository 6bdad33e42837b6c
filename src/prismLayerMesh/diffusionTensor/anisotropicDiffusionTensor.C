/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "anisotropicDiffusionTensor.H"
#include "controlEntries.H"
#include "harmonicField.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * * * Static Members  * * * * * * * * * * * * * //

namespace Foam
{
namespace diffusionTensors
{
    defineTypeNameAndDebug(anisotropic, 0);
    addToRunTimeSelectionTable(diffusionTensor, anisotropic, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Bound on lambda, and with it on the condition of the tensors
static const scalar flat = 0.1;

//- Intervals of the integrals over c
static const label nIntervals = 200;

//- Slopes per unit, and the largest of them, for which the integrals are
//  tabulated; the tensors of larger ones hardly differ
static const label nPerUnit = 100;
static const label maxSlope = 4;


//- a of a slope sigma: the mean of c^2, weighted by exp(lambda)
static scalar alongGradient(const scalar sigma, const scalar beta)
{
    // The largest lambda, so that nothing overflows
    const scalar largest = ::pow(flat, beta);
    scalar sum = 0, sumSqr = 0;

    for (label k = 0; k < nIntervals; ++k)
    {
        const scalar c = (k + 0.5)/nIntervals;
        const scalar weight =
            ::exp(::pow(max(sigma*c, flat), beta) - largest);

        sum += weight;
        sumSqr += weight*sqr(c);
    }

    return sumSqr/sum;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::diffusionTensors::anisotropic::anisotropic(const dictionary& coeffs)
{
    checkKeys(coeffs, {"beta", "delta"});
    readBounded(coeffs, "beta", scalar(-4), scalar(0), beta_);
    readBounded(coeffs, "delta", scalar(0.05), scalar(100), delta_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::symmTensorField Foam::diffusionTensors::anisotropic::tensors
(
    const backgroundMesh& mesh,
    const scalarField& isotropic
) const
{
    scalarField table(maxSlope*nPerUnit + 1);
    forAll(table, i)
    {
        table[i] = alongGradient(i/scalar(nPerUnit), beta_);
    }

    const vectorField gradients(pointGradients(mesh, isotropic));
    symmTensorField tensors(mesh.points.size());

    forAll(tensors, p)
    {
        const scalar sigma = mag(gradients[p])*mesh.gaps[p];
        const label i = min(label(sigma*nPerUnit + 0.5), table.size() - 1);
        const scalar a = table[i];
        const vector g(normalised(gradients[p]));

        tensors[p] = 0.5*(1 - a)*symmTensor::I + 0.5*(3*a - 1)*sqr(g);

        // Of a gradient without a direction
        tensors[p] /= tr(tensors[p]);
    }

    return tensors;
}


Foam::scalarField Foam::diffusionTensors::anisotropic::edgeWeights
(
    const backgroundMesh& mesh,
    const symmTensorField& tensors
) const
{
    scalarField weights(max(cotangentWeights(mesh), scalar(0)));

    forAll(weights, i)
    {
        const edge& e = mesh.edges[i];
        const vector unit
        (
            normalised(mesh.points[e.end()] - mesh.points[e.start()])
        );
        const symmTensor t = tensors[e.start()] + tensors[e.end()];

        weights[i] *= ::exp((unit & t & unit)/delta_);
    }

    return weights;
}


// ************************************************************************* //
