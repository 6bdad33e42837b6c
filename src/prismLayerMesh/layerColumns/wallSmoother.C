/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "wallSmoother.H"

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wallSmoother Foam::makeWallSmoother
(
    const wallSurface& wall,
    const wallAddressing& addressing
)
{
    const label nPoints = wall.points.size();
    wallSmoother graph{addressing, {}, {}};
    graph.weights.setSize(nPoints);
    graph.spread.setSize(nPoints, 0);

    for (label p = 0; p < nPoints; ++p)
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

        graph.weights[p] = weights/sum(weights);
        graph.spread[p] = 0.5*nOthers/sum(weights);
    }

    return graph;
}


// ************************************************************************* //
