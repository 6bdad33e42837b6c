/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farFieldMesh.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void farFieldMesh::keepPatches(const labelUList& kept)
{
    meshPatches keptPatches;
    labelList starts(1, topology.patchStarts[0]);
    labelList sizes(1, topology.patchSizes[0]);
    for (const label patchi : kept)
    {
        keptPatches.names.append(patches.names[patchi]);
        keptPatches.entries.append(patches.entries[patchi]);
        starts.append(topology.patchStarts[1 + patchi]);
        sizes.append(topology.patchSizes[1 + patchi]);
    }

    patches = keptPatches;
    topology.patchStarts = starts;
    topology.patchSizes = sizes;
}

} // End namespace Foam

// ************************************************************************* //
