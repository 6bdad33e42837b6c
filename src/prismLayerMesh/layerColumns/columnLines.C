/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnLines.H"
#include "diffusionTensor.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

columnLines makeColumnLines
(
    const backgroundMesh& mesh,
    const scalarField& isotropic,
    const columnStarts& starts,
    const lineDirections weighting
)
{
    return columnLines
    {
        makeGradientLines
        (
            mesh, isotropic, starts.wallPoints, starts.directions,
            requestedHeights(starts.spacing), weighting
        ),
        scalarField(mag(scaledGradients(mesh, isotropic)), starts.wallPoints)
    };
}

} // End namespace Foam

// ************************************************************************* //
