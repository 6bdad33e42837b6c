/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "tallColumns.H"
#include "boolList.H"
#include "ListOps.H"

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::labelList Foam::tallColumns
(
    const faceList& faces,
    const UList<labelPair>& pairs,
    const scalarField& room,
    const scalar share
)
{
    boolList tall(room.size(), false);

    for (const labelPair& pair : pairs)
    {
        scalar tallest = 0;
        for (const label facei : pair)
        {
            for (const label c : faces[facei])
            {
                tallest = max(tallest, room[c]);
            }
        }

        for (const label facei : pair)
        {
            for (const label c : faces[facei])
            {
                tall[c] = tall[c] || room[c] >= share*tallest;
            }
        }
    }

    return findIndices(tall, true);
}


// ************************************************************************* //
