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


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Unit vector along an edge
static vector along(const backgroundMesh& mesh, const edge& e)
{
    return normalised(mesh.points[e.end()] - mesh.points[e.start()]);
}

} // End namespace Foam


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

    auto lambda = [&](const label p, const vector& unit)
    {
        const scalar slope = mag(unit & gradients[p])*mesh.gaps[p];
        return ::pow(max(slope, flat), beta_);
    };

    // exp(lambda) overflows for steep powers; a factor at a point is nothing
    // to a tensor that is scaled
    scalarField largest(mesh.points.size(), 0);

    for (const edge& e : mesh.edges)
    {
        const vector unit(along(mesh, e));

        for (const label p : {e.start(), e.end()})
        {
            largest[p] = max(largest[p], lambda(p, unit));
        }
    }

    symmTensorField tensors(mesh.points.size(), Zero);

    for (const edge& e : mesh.edges)
    {
        const vector unit(along(mesh, e));

        for (const label p : {e.start(), e.end()})
        {
            tensors[p] += ::exp(lambda(p, unit) - largest[p])*sqr(unit);
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
        const vector unit(along(mesh, e));

        const symmTensor t = tensors[e.start()] + tensors[e.end()];
        weights[i] = ::exp((unit & t & unit)/delta_);
    }

    return weights;
}


// ************************************************************************* //
