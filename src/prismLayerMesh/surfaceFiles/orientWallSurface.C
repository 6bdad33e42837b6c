/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "orientWallSurface.H"
#include "wallPredicates.H"
#include "wallTopologyDefects.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A closed oriented manifold, by its labels alone
static bool isOrientable(const wallSurface& wall, const wallSides& sides)
{
    for (const face& f : wall.faces)
    {
        if (f.size() < 3 || hasRepeatedPoint(f))
        {
            return false;
        }
    }

    defectList defects(wall);
    const bool oriented = findBadEdges(sides, defects);
    findNonManifoldPoints(wall, sides, defects);

    return oriented && defects.empty();
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void orientAlike(wallSurface& wall)
{
    const wallSides sides(makeWallSides(wall));

    for (const label facei : findTurnedFaces(sides, wall.faces.size()))
    {
        wall.faces[facei].flip();
    }
}


label orientWallSurface(wallSurface& wall, const bool fluidOutside)
{
    const wallSides sides(makeWallSides(wall));

    if (wall.faces.empty() || !isOrientable(wall, sides))
    {
        return 0;
    }

    labelList componentOfFace;
    const label n = findComponents(sides, wall.faces.size(), componentOfFace);
    const bitSet inward(findInwardComponents(wall, componentOfFace, n));
    label nFlipped = 0;

    forAll(wall.faces, facei)
    {
        if (inward.test(componentOfFace[facei]) == fluidOutside)
        {
            wall.faces[facei].flip();
            ++nFlipped;
        }
    }

    return nFlipped;
}

} // End namespace Foam

// ************************************************************************* //
