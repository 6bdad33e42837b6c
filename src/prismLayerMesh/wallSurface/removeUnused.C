/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "removeUnused.H"
#include "bitSet.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList removeUnusedPoints(faceList& faces, pointField& points)
{
    bitSet used(points.size());
    for (const face& f : faces)
    {
        used.set(f);
    }

    const labelList numbers(invert(used));
    inplaceSubset(used, points);

    for (face& f : faces)
    {
        inplaceRenumber(numbers, f);
    }

    return numbers;
}


void mergePatches(wallSurface& wall)
{
    bitSet used(wall.patchNames.size());
    used.set(wall.patchIDs);

    DynamicList<word> names, types;
    labelList numbers(used.size(), -1);

    for (const label i : used)
    {
        numbers[i] = names.find(wall.patchNames[i]);

        if (numbers[i] < 0)
        {
            numbers[i] = names.size();
            names.append(wall.patchNames[i]);

            if (wall.patchTypes.size())
            {
                types.append(wall.patchTypes[i]);
            }
        }
    }

    inplaceRenumber(numbers, wall.patchIDs);
    wall.patchNames = names;
    wall.patchTypes = types;
}

} // End namespace Foam

// ************************************************************************* //
