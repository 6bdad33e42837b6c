/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "anisotropicDiffusionTensor.H"
#include "controlEntries.H"
#include "harmonicField.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * * * Static Members  * * * * * * * * * * * * * //

namespace Foam
{
namespace diffusionTensors
{
    defineTypeNameAndDebug(anisotropic, 0);
    addToRunTimeSelectionTable(diffusionTensor, anisotropic, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::diffusionTensors::anisotropic::anisotropic(const dictionary& coeffs)
{
    checkKeys(coeffs, {"beta", "delta"});
    readBounded(coeffs, "beta", scalar(-4), scalar(0), beta_);
    readBounded(coeffs, "delta", scalar(0.05), scalar(100), delta_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::symmTensorField Foam::diffusionTensors::anisotropic::tensors
(
    const backgroundMesh& mesh,
    const scalarField& isotropic
) const
{
    const vectorField gradients(pointGradients(mesh, isotropic));

    // Bound on lambda, and with it on the condition of the tensors
    const scalar flat = 0.1;

    symmTensorField tensors(mesh.points.size(), Zero);

    for (const edge& e : mesh.edges)
    {
        const vector along = normalised(mesh.points[e.end()]
          - mesh.points[e.start()]);

        for (const label p : {e.start(), e.end()})
        {
            const scalar slope = mag(along & gradients[p])*mesh.gaps[p];
            tensors[p] += ::exp(::pow(max(slope, flat), beta_))*sqr(along);
        }
    }

    for (symmTensor& t : tensors)
    {
        t /= max(tr(t), VSMALL);
    }

    return tensors;
}


Foam::scalarField Foam::diffusionTensors::anisotropic::edgeWeights
(
    const backgroundMesh& mesh,
    const symmTensorField& tensors
) const
{
    scalarField weights(mesh.edges.size());

    forAll(weights, i)
    {
        const edge& e = mesh.edges[i];
        const vector along = normalised(mesh.points[e.end()]
          - mesh.points[e.start()]);

        const symmTensor t = tensors[e.start()] + tensors[e.end()];
        weights[i] = ::exp((along & t & along)/delta_);
    }

    return weights;
}


// ************************************************************************* //
