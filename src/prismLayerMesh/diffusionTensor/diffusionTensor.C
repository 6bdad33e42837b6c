/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "diffusionTensor.H"
#include "controlEntries.H"
#include "harmonicField.H"
#include "ranges.H"

namespace Foam
{

void declare(controlEntries& entries, fieldControls& controls)
{
    const wordList models
    (
        diffusionTensor::emptyConstructorTablePtr_->sortedToc()
    );
    entries.readChoice
    (
        "tensor", controls.tensor, models,
        "Conductivity of the field; anisotropic with levelSets"
    );
    entries.readChoice
    (
        "solver", controls.solver, {"krylov", "iteration"},
        "Conjugate gradients, or Algorithm 1 of the paper"
    );
    entries.readBounded
    (
        "tolerance", controls.tolerance, 1e-14, 0.1, "Tolerance of the solver"
    );

    // Coefficients are checked here, not when they are used in mid-run
    for (const word& model : models)
    {
        const word key(model + "Coeffs");
        const bool isThere = entries.readDict
        (
            key, "Of tensor " + model, [&](controlEntries& coeffs)
            {
                diffusionTensor::New(model)->declare(coeffs);
            }
        );
        if (isThere && model == controls.tensor)
        {
            controls.tensorCoeffs = optionalDict(*entries.dict(), key);
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Static Members  * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(diffusionTensor, 0);
    defineRunTimeSelectionTable(diffusionTensor, empty);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::diffusionTensor> Foam::diffusionTensor::New
(
    const word& name
)
{
    const auto model = emptyConstructorTablePtr_->cfind(name);

    if (!model.found())
    {
        FatalErrorInFunction
            << "Unknown value of tensor: " << name << nl
            << "Valid ones: "
            << listed(emptyConstructorTablePtr_->sortedToc()).c_str()
            << exit(FatalError);
    }

    return model.val()();
}


Foam::autoPtr<Foam::diffusionTensor> Foam::diffusionTensor::New
(
    const word& name,
    const dictionary& coeffs
)
{
    autoPtr<diffusionTensor> model(New(name));
    controlEntries::read
    (
        coeffs, [&](controlEntries& entries) { model->declare(entries); }
    );

    return model;
}


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
