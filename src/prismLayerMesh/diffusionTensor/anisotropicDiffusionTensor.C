/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "anisotropicDiffusionTensor.H"
#include "controlEntries.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Static Members  * * * * * * * * * * * * * //

namespace Foam
{
namespace diffusionTensors
{
    defineTypeNameAndDebug(anisotropic, 0);
    addToRunTimeSelectionTable(diffusionTensor, anisotropic, empty);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The integral of exp(x c) over c from 0 to 1
static Foam::scalar allDirections(const Foam::scalar x)
{
    return x > 0 ? std::expm1(x)/x : 1;
}


//- The integral of exp(x c) c^2 over c from 0 to 1
static Foam::scalar normalPart(const Foam::scalar x)
{
    // Below that the series has more digits
    return x > 0.01
      ? (::exp(x)*(Foam::sqr(x) - 2*x + 2) - 2)/Foam::pow3(x)
      : 1.0/3 + x/4 + Foam::sqr(x)/10 + Foam::pow3(x)/36;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::diffusionTensors::anisotropic::declare(controlEntries& entries)
{
    entries.readBounded
    (
        "beta", beta_, -4, 0, "Factor of the drop of H along a direction"
    );
    entries.readBounded
    (
        "delta", delta_, 0.05, 100, "Smaller values make it more anisotropic"
    );
    entries.readBounded
    (
        "maxSlope", maxSlope_, 1, 10, "Cap on the slope of H"
    );
}


Foam::symmTensorField Foam::diffusionTensors::anisotropic::tensors
(
    const backgroundMesh& mesh,
    const scalarField& isotropic
) const
{
    const vectorField gradients(scaledGradients(mesh, isotropic));
    const scalar flat = normalPart(-beta_);
    symmTensorField tensors(mesh.points.size());
    forAll(tensors, p)
    {
        const scalar x = -beta_*min(mag(gradients[p]), maxSlope_);
        const scalar normal = normalPart(x);
        const scalar tangential = 0.5*(allDirections(x) - normal);
        const scalar kn = ::exp(2*(normal - flat)/delta_);
        const scalar kt = ::exp(2*(tangential - flat)/delta_);

        const vector g(normalised(gradients[p]));

        tensors[p] = kt*symmTensor::I + (kn - kt)*sqr(g);
    }

    return tensors;
}


// ************************************************************************* //
