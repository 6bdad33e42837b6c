/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planeOutlines.H"
#include "sidePatch.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void planeOutlines::set
(
    List<edgeList>& borders,
    List<edgeList>& limits
) const
{
    borders.setSize(gone_.size());
    limits.setSize(gone_.size());

    forAll(gone_, s)
    {
        for (const edge& e : outline(gone_[s]))
        {
            if (stayingEdges_.found(e))
            {
                borders[s].append(e);
            }
            else if (!wallEdges_.found(e))
            {
                limits[s].append(e);
            }
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
