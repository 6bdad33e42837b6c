/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "isotropicDiffusionTensor.H"
#include "controlEntries.H"
#include "harmonicField.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * * * Static Members  * * * * * * * * * * * * * //

namespace Foam
{
namespace diffusionTensors
{
    defineTypeNameAndDebug(isotropic, 0);
    addToRunTimeSelectionTable(diffusionTensor, isotropic, empty);
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::diffusionTensors::isotropic::declare(controlEntries&)
{}


Foam::symmTensorField Foam::diffusionTensors::isotropic::tensors
(
    const backgroundMesh& mesh,
    const scalarField&
) const
{
    return symmTensorField(mesh.points.size(), symmTensor(symmTensor::I));
}


// ************************************************************************* //
