/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coreFaceZones.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

List<faceZoneParts> coreFaceZones
(
    const polyMeshParts& core,
    const labelUList& cells,
    const labelUList& faces,
    const Map<DynamicList<label>>& cutFaces
)
{
    DynamicList<faceZoneParts> zones;

    for (const faceZoneParts& zone : core.faceZones)
    {
        DynamicList<label> zoneFaces;
        DynamicList<bool> flips;
        forAll(zone.faces, i)
        {
            const label facei = zone.faces[i];
            if (faces[facei] >= 0)
            {
                zoneFaces.append(faces[facei]);
                flips.append(zone.flips[i]);
            }

            // Triangles of the cut point from tetrahedra to the cell that stays
            const bool turned = cells[core.topology.owner[facei]] >= 0;
            const labelList triangles
            (
                cutFaces.found(facei)
              ? labelList(cutFaces[facei]) : labelList()
            );
            zoneFaces.append(triangles);
            flips.append(boolList(triangles.size(), zone.flips[i] != turned));
        }
        zones.append({zone.name, zoneFaces, flips});
    }

    return List<faceZoneParts>(std::move(zones));
}

} // End namespace Foam

// ************************************************************************* //
