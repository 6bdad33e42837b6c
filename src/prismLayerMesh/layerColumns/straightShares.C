/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "straightShares.H"
#include "columnControls.H"
#include "wallSmoother.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

scalarField straightShares
(
    const layerFront& front,
    const scalarField& slopes,
    const scalarField& thickness,
    const columnTeam& team
)
{
    const scalar from = columnControls::concaveSlope;
    const scalar to = columnControls::convexSlope;
    scalarField shares(min(max((slopes - from)/(to - from), 0.0), 1.0));

    wallSmoother(front.surface, front.addressing).smooth
    (
        sqr(columnControls::slopeSmoothing*thickness),
        columnControls::maxScalarPasses,
        shares,
        team
    );

    return shares;
}


void straighten
(
    const gradientLines& straight,
    const scalarField& shares,
    gradientLines& lines
)
{
    forAll(lines.points, i)
    {
        const scalar share = shares[i/lines.nSamples];
        lines.points[i] += share*(straight.points[i] - lines.points[i]);
    }
}

} // End namespace Foam

// ************************************************************************* //
