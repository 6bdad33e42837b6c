/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "faceQuality.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

scalar nonOrthoViolation
(
    const vector& area,
    const vector& between,
    const scalar target
)
{
    const scalar dot = between & area;
    const scalar squares = magSqr(between)*magSqr(area);

    // Most faces are good, and squares cost less than roots
    if (squares <= 0 || (dot > 0 && sqr(dot) >= sqr(target)*squares))
    {
        return 0;
    }

    return target - dot/Foam::sqrt(squares);
}

} // End namespace Foam

// ************************************************************************* //
