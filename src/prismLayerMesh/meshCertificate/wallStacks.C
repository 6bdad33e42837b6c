/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "wallStacks.H"

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::labelList Foam::countLayers
(
    const polyhedralMesh& mesh,
    const labelUList& wallFaces,
    const boolList& positive
)
{
    labelList nLayers(wallFaces.size(), Zero);

    forAll(wallFaces, i)
    {
        label facei = wallFaces[i];
        label celli = mesh.owner(facei);

        while (celli >= 0 && positive[celli])
        {
            const label next = mesh.opposite(facei, celli);

            // Opposite to each other, or a walk might not end
            if (next < 0 || mesh.opposite(next, celli) != facei)
            {
                break;
            }

            ++nLayers[i];
            facei = next;
            celli = mesh.beyond(facei, celli);
        }
    }

    return nLayers;
}


// ************************************************************************* //
