/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

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
    addToRunTimeSelectionTable(diffusionTensor, isotropic, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::diffusionTensors::isotropic::isotropic(const dictionary& coeffs)
{
    checkKeys(coeffs, {});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::symmTensorField Foam::diffusionTensors::isotropic::tensors
(
    const backgroundMesh& mesh,
    const scalarField&
) const
{
    return symmTensorField(mesh.points.size(), symmTensor::I/3);
}


Foam::scalarField Foam::diffusionTensors::isotropic::edgeWeights
(
    const backgroundMesh& mesh,
    const symmTensorField&
) const
{
    return cotangentWeights(mesh);
}


// ************************************************************************* //
