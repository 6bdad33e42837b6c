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
    addToRunTimeSelectionTable(diffusionTensor, gradientPower, empty);
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::diffusionTensors::gradientPower::declare(controlEntries& entries)
{
    entries.readBounded
    (
        "qConcave", qConcave_, 0, 10, "Exponent of the slope where H is flat"
    );
    entries.readBounded
    (
        "qConvex", qConvex_, 0, 10, "Exponent of the slope where H is steep"
    );
    entries.readBounded
    (
        "tau", tau_, 0.01, 1, "Conductivity along level sets over that across"
    );
}


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
