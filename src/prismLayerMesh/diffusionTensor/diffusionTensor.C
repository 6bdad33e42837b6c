/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "diffusionTensor.H"

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


// ************************************************************************* //
