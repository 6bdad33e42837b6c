/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::diffusionTensors::anisotropic::anisotropic(const dictionary& coeffs)
{
    checkKeys(coeffs, {"beta", "delta"});
    readBounded(coeffs, "beta", scalar(-4), scalar(0), beta_);
    readBounded(coeffs, "delta", scalar(0.05), scalar(100), delta_);
}


// * * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * //

Foam::scalar Foam::diffusionTensors::anisotropic::alongGradient
(
    const scalar sigma
) const
{
    // The largest lambda, so that nothing overflows
    const scalar largest = ::pow(flat, beta_);
    scalar sum = 0, sumSqr = 0;

    for (label k = 0; k < nIntervals; ++k)
    {
        const scalar c = (k + 0.5)/nIntervals;
        const scalar weight =
            ::exp(::pow(max(sigma*c, flat), beta_) - largest);

        sum += weight;
        sumSqr += weight*sqr(c);
    }

    return sumSqr/sum;
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
        table[i] = alongGradient(i/scalar(nPerUnit));
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

        // The trace is not 1 without a direction
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
