/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gradientPowerDiffusionTensor.H"
#include "controlEntries.H"
#include "harmonicField.H"
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
    checkKeys(coeffs, {"q"});
    readBounded(coeffs, "q", scalar(0), scalar(10), q_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::symmTensorField Foam::diffusionTensors::gradientPower::tensors
(
    const backgroundMesh& mesh,
    const scalarField& isotropic
) const
{
    const vectorField gradients(pointGradients(mesh, isotropic));
    symmTensorField tensors(mesh.points.size());

    forAll(tensors, v)
    {
        const scalar slope = mag(gradients[v])*mesh.gaps[v];
        const scalar bounded = min(max(slope, smallest), largest);
        tensors[v] = ::pow(bounded, q_)*symmTensor::I/3;
    }

    return tensors;
}


Foam::scalarField Foam::diffusionTensors::gradientPower::edgeWeights
(
    const backgroundMesh& mesh,
    const symmTensorField& tensors
) const
{
    scalarField conductivities(mesh.tets.size(), 0);
    forAll(conductivities, t)
    {
        for (const label v : mesh.tets[t])
        {
            conductivities[t] += 0.25*tr(tensors[v]);
        }
    }

    return max(cotangentWeights(mesh, conductivities), scalar(0));
}


// ************************************************************************* //
