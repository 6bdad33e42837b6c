/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gradientPowerDiffusionTensor.H"
#include "controlEntries.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * * * Static Members  * * * * * * * * * * * * * //

namespace Foam
{
namespace diffusionTensors
{
    defineTypeNameAndDebug(gradientPower, 0);
    addToRunTimeSelectionTable(diffusionTensor, gradientPower, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::diffusionTensors::gradientPower::gradientPower(const dictionary& coeffs)
{
    checkKeys(coeffs, {"qConcave", "qConvex", "tau"});
    readBounded(coeffs, "qConcave", scalar(0), scalar(10), qConcave_);
    readBounded(coeffs, "qConvex", scalar(0), scalar(10), qConvex_);
    readBounded(coeffs, "tau", scalar(0.01), scalar(1), tau_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::symmTensorField Foam::diffusionTensors::gradientPower::tensors
(
    const backgroundMesh& mesh,
    const scalarField& isotropic
) const
{
    const vectorField gradients(scaledGradients(mesh, isotropic));
    symmTensorField tensors(mesh.points.size());
    forAll(tensors, p)
    {
        const scalar sigma = min(max(mag(gradients[p]), smallest), largest);
        const scalar q = sigma < 1 ? qConcave_ : qConvex_;
        const vector g(normalised(gradients[p]));

        tensors[p] = ::pow(sigma, q)*(tau_*symmTensor::I + (1 - tau_)*sqr(g));
    }

    return tensors;
}


// ************************************************************************* //
