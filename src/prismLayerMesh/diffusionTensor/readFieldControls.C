/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readFieldControls.H"
#include "controlEntries.H"
#include "diffusionTensor.H"

namespace Foam
{

fieldControls readFieldControls
(
    const dictionary& dict,
    const bool onLevelSets
)
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
        dict, "tolerance",
        scalar(1e-14), scalar(0.1), controls.tolerance
    );

    // Its coefficients are checked here, not when they are used in mid-run
    controls.tensorCoeffs = optionalDict(dict, controls.tensor + "Coeffs");
    diffusionTensor::New(controls.tensor, controls.tensorCoeffs);

    return controls;
}

} // End namespace Foam

// ************************************************************************* //
