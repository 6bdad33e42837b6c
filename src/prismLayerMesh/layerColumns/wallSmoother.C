/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "wallSmoother.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallSmoother::wallSmoother
(
    const wallSurface& wall,
    const wallAddressing& addressing
)
:
    addressing_(addressing),
    weights_(wall.points.size()),
    spread_(wall.points.size())
{
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

        weights_[p] = weights/sum(weights);
        spread_[p] = 0.5*nOthers/sum(weights);
    }
}


// ************************************************************************* //
