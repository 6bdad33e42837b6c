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

fieldControls readFieldControls(const dictionary& dict, const bool onLevelSets)
{
    const wordList models
    (
        diffusionTensor::dictionaryConstructorTablePtr_->sortedToc()
    );
    wordList keys({"tensor", "solver", "tolerance"});
    for (const word& model : models)
    {
        keys.append(model + "Coeffs");
    }

    checkKeys(dict, keys);

    fieldControls controls;
    if (onLevelSets)
    {
        controls.tensor = fieldControls::levelSetTensor;
    }
    readChoice(dict, "tensor", models, controls.tensor);
    readChoice(dict, "solver", {"krylov", "iteration"}, controls.solver);
    readBounded
    (
        dict, "tolerance", scalar(1e-14), scalar(0.1), controls.tolerance
    );

    // Its coefficients are checked here, not when they are used in mid-run
    controls.tensorCoeffs = optionalDict(dict, controls.tensor + "Coeffs");
    diffusionTensor::New(controls.tensor, controls.tensorCoeffs);

    return controls;
}

} // End namespace Foam


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
            << listed(dictionaryConstructorTablePtr_->sortedToc()).c_str()
            << exit(FatalIOError);
    }

    return model.val()(coeffs);
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
