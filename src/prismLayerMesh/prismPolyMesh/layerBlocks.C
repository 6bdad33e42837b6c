/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerBlocks.H"

namespace Foam
{

label stacksPerBlock(const label nLayers)
{
    // A closed front of triangles has 2.5 faces for each cell
    return max(label(1), label(meshBlocks::blockSize/(2.5*nLayers)));
}


void appendStack
(
    const prismLayers& layers,
    const labelListList& faceNeighbours,
    const label fronti,
    faceBlock& block
)
{
    visitInternalFaces
    (
        layers.nLayers, faceNeighbours[fronti], fronti,
        [&](const label k, const label i, const label other)
        {
            const label celli = cellLabel(layers, fronti, i);
            appendFace(layers, prismFaceKey{fronti, k, i}, block.points);
            block.endFace
            (
                celli, k < 0 ? celli + 1 : cellLabel(layers, other, i)
            );
        }
    );
}


void appendPatchFace
(
    const prismLayers& layers,
    const prismFaceKey& key,
    faceBlock& block
)
{
    appendFace(layers, key, block.points);
    block.endFace(cellLabel(layers, key.front, max(key.level, label(1))));
}

} // End namespace Foam

// ************************************************************************* //
