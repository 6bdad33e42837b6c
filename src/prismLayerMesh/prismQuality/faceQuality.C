/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "faceQuality.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

scalar cosineLack(const vector& area, const vector& between, const scalar aim)
{
    const scalar dot = between & area;
    const scalar squares = magSqr(between)*magSqr(area);

    // Most faces are good, and squares cost less than roots
    if (squares <= 0 || (dot > 0 && sqr(dot) >= sqr(aim)*squares))
    {
        return 0;
    }

    return aim - dot/Foam::sqrt(squares);
}


scalar wallCosine
(
    const faceGeometry& f,
    const faceGeometry& g,
    const vector& edge
)
{
    const scalar areas = mag(f.area)*mag(g.area);
    if (areas <= VSMALL)
    {
        return GREAT;
    }

    const vector side
    (
        edge ^ (f.area/mag(f.area) + g.area/mag(g.area))
    );
    const vector between(g.centre - f.centre);
    const scalar lengths = mag(side)*mag(between);

    return lengths > VSMALL
      ? min(mag(side & between)/lengths, scalar(1)) : GREAT;
}

} // End namespace Foam

// ************************************************************************* //
