/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSmoother.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

wallSmoother::wallSmoother
(
    const wallSurface& wall,
    const wallAddressing& addressing
)
:
    addressing_(addressing),
    weights_(wall.points.size()),
    spread_(wall.points.size())
{
    #pragma omp parallel for schedule(static, 256)
    forAll(weights_, p)
    {
        const labelList& neighbours = addressing.pointPoints[p];
        scalarField weights(neighbours.size());
        label nOthers = 0;

        forAll(neighbours, i)
        {
            const scalar lengthSqr =
                magSqr(wall.points[neighbours[i]] - wall.points[p]);
            weights[i] = lengthSqr > 0 ? 1/lengthSqr : 0;
            nOthers += lengthSqr > 0;
        }

        // At the rim of a share there are columns without known neighbours
        weights_[p] = nOthers ? scalarField(weights/sum(weights)) : weights;
        spread_[p] = nOthers ? 0.5*nOthers/sum(weights) : GREAT;
    }
}

} // End namespace Foam

// ************************************************************************* //
