/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "testSurfaces.H"
#include "ListOps.H"
#include "Random.H"

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wallSurface Foam::testSurfaces::renumbered
(
    const wallSurface& wall,
    const label seed
)
{
    Random random(seed);
    labelList newPoints(identity(wall.points.size()));
    labelList newFaces(identity(wall.faces.size()));
    random.shuffle(newPoints);
    random.shuffle(newFaces);

    wallSurface result(wall);
    result.points = reorder(newPoints, wall.points);
    result.faces = reorder(newFaces, wall.faces);
    result.patchIDs = reorder(newFaces, wall.patchIDs);

    for (face& f : result.faces)
    {
        inplaceRenumber(newPoints, f);
    }
    for (edge& e : result.border.edges)
    {
        inplaceRenumber(newPoints, e);
    }

    return result;
}


// ************************************************************************* //
