/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "normalSectors.H"
#include "sectorSearch.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

normalSectors makeNormalSectors
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const vectorField& neighbourDirections,
    const label p
)
{
    // On two side patches a column can only stand on the line of both
    return addressing.sidesOf(p).size() > 1
      ? normalSectors()
      : sectorSearch
        (
            wall, addressing, visibility, neighbourDirections, p
        ).best();
}

} // End namespace Foam

// ************************************************************************* //
