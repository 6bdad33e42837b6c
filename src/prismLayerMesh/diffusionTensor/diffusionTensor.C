/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "diffusionTensor.H"
#include "harmonicField.H"

// * * * * * * * * * * * * * * * * Static Members  * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(diffusionTensor, 0);
    defineRunTimeSelectionTable(diffusionTensor, dictionary);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::diffusionTensor> Foam::diffusionTensor::New
(
    const word& name,
    const dictionary& coeffs
)
{
    const auto model = dictionaryConstructorTablePtr_->cfind(name);

    if (!model.found())
    {
        FatalIOErrorInFunction(coeffs)
            << "Unknown value of tensor: " << name << nl
            << "Valid ones: "
            << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
            << exit(FatalIOError);
    }

    return model.val()(coeffs);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::vectorField Foam::scaledGradients
(
    const backgroundMesh& mesh,
    const scalarField& field
)
{
    return vectorField(mesh.gaps*pointGradients(mesh, field));
}


Foam::symmTensorField Foam::tetMeans
(
    const backgroundMesh& mesh,
    const symmTensorField& tensors
)
{
    symmTensorField means(mesh.tets.size(), Zero);

    forAll(means, t)
    {
        for (const label p : mesh.tets[t])
        {
            means[t] += 0.25*tensors[p];
        }
    }

    return means;
}


// ************************************************************************* //
