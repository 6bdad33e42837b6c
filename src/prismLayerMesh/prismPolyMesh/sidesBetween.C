/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sidesBetween.H"

#include <algorithm>
#include <tuple>

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

List<sideBetween> sidesBetween
(
    const layersPiece& piece,
    const label processor
)
{
    DynamicList<sideBetween> sides;

    forAll(piece.processors, facei)
    {
        forAll(piece.processors[facei], k)
        {
            const label other = piece.processors[facei][k];
            if (other < 0 || other == processor)
            {
                continue;
            }
            const bool isTurned =
                piece.faceNeighbours[facei][k] < piece.stacks[facei];
            for (label i = 1; i <= piece.layers.nLayers; ++i)
            {
                sides.append
                ({
                    other, piece.labels(facei, k, i), {facei, k, i}, isTurned
                });
            }
        }
    }
    std::sort
    (
        sides.begin(), sides.end(),
        [](const sideBetween& a, const sideBetween& b)
        {
            return std::tie(a.processor, a.whole)
                 < std::tie(b.processor, b.whole);
        }
    );

    return List<sideBetween>(std::move(sides));
}


void appendSide
(
    const prismLayers& layers,
    const sideBetween& side,
    faceBlock& block
)
{
    // The face is of the stack with the lower label
    const prismFaceKey& key = side.key;
    const edge e(layers.faces[key.front].faceEdge(key.edge));
    block.points.append
    (
        side.isTurned
      ? sideFace(layers, e.reverseEdge(), key.level).reverseFace()
      : sideFace(layers, e, key.level)
    );
    block.endFace(cellLabel(layers, key.front, key.level));
}

} // End namespace Foam

// ************************************************************************* //
