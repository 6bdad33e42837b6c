/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "explicitGains.H"
#include "DynamicList.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A least-squares matrix of unit vectors with a smaller determinant has no
//  inverse: the neighbours are in a plane
static constexpr scalar leastDeterminant = 1e-9;


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

scalar cellGain(const UList<schemeFace>& faces, const scalar volume)
{
    scalar diagonal = 0;
    bool isValid = volume > 0;
    vector ownGradient(Zero);
    for (const schemeFace& f : faces)
    {
        diagonal += f.implicit;
        isValid = isValid && f.isSeen;
        ownGradient += f.ownShare*f.explicitArea;
    }
    if (!isValid)
    {
        return invalidGain;
    }

    scalar own = 0;
    scalar others = 0;
    for (const schemeFace& f : faces)
    {
        const scalar along = f.area & ownGradient;
        own += f.ownShare*along;
        others += f.otherShare*mag(along);
    }

    // The gradient in a neighbour has half of the values at each face
    for (const schemeFace& f : faces)
    {
        for (const schemeFace& g : faces)
        {
            others += f.otherShare*0.5*mag(g.area & f.explicitArea);
        }
    }

    return (mag(own) + others)/(volume*diagonal);
}


scalar leastSquaresGain(const UList<schemeFace>& faces)
{
    symmTensor sum(Zero);
    scalar diagonal = 0;
    vector ownArea(Zero);
    for (const schemeFace& f : faces)
    {
        sum += sqr(f.d)/max(magSqr(f.d), VSMALL);
        diagonal += f.implicit;
        ownArea += f.ownShare*f.explicitArea;
    }
    if (det(sum) < leastDeterminant)
    {
        return invalidGain;
    }

    const symmTensor inverse(inv(sum));
    scalar own = 0;
    scalar others = 0;
    for (const schemeFace& g : faces)
    {
        const vector slope(inverse & (g.d/max(magSqr(g.d), VSMALL)));
        const scalar along = slope & ownArea;
        own += along;
        others += mag(along);

        // The gradient in a neighbour has the slopes of the cell
        for (const schemeFace& f : faces)
        {
            others += f.otherShare*mag(slope & f.explicitArea);
        }
    }

    return (mag(own) + others)/diagonal;
}


scalarField explicitGains(const finiteVolumes& mesh)
{
    scalarField gains(mesh.cellVolumes.size());

    #pragma omp parallel
    {
        DynamicList<schemeFace> seen;

        #pragma omp for schedule(static)
        forAll(gains, c)
        {
            gains[c] = gainOf(mesh, c, seen);
        }
    }

    return gains;
}

} // End namespace Foam

// ************************************************************************* //
