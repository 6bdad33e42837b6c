/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshPiece.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label meshPiece::faceAddress(const meshFace& f) const
{
    if (f.farFace >= 0)
    {
        return farFaces[f.farFace];
    }

    const meshStack& stack = stacks[f.key.front];
    const label i = f.key.level;
    if (f.key.edge >= 0)
    {
        const stackEdge& e = edges[stack.firstEdge + f.key.edge];
        const bool isAfterLevel = e.sideStride > 1 && i < layers.nLayers;
        const label facei = e.firstSide + (i - 1)*e.sideStride + isAfterLevel;

        return f.isTurned ? -(facei + 1) : facei + 1;
    }

    return 1 +
    (
        i == 0 ? stack.wallFace
      : i == layers.nLayers ? firstOuter + stack.stack
      : stack.firstFace + (i - 1)*stack.stride
    );
}


labelList meshPiece::cellAddressing() const
{
    const label n = layers.nLayers;
    DynamicList<label> addressing(stacks.size()*n + farCells.size());
    for (const meshStack& stack : stacks)
    {
        for (label i = 0; i < n; ++i)
        {
            addressing.append(stack.stack*n + i);
        }
    }
    for (const label celli : farCells)
    {
        addressing.append(nStacks*n + celli);
    }

    return labelList(std::move(addressing));
}


labelList meshPiece::pointAddressing() const
{
    const label n = layers.nLayers;
    const label nLayerPoints =
        layers.points.size() - layers.extraColumnPoints.size();
    labelList addressing(nLayerPoints + farPoints.size());
    forAll(columns, c)
    {
        const label whole = columns[c];
        const label nSkipped = max(whole - nWallPoints + 1, label(0));
        for (label i = nSkipped > 0; i <= n; ++i)
        {
            addressing[layers.pointLabel(c, i)] = whole*(n + 1) + i - nSkipped;
        }
    }

    // The far field's points follow all of those of the layers
    const label shift = nColumns*n + nWallPoints - nColumns;
    forAll(farPoints, i)
    {
        addressing[nLayerPoints + i] = farPoints[i] + shift;
    }

    return addressing;
}

} // End namespace Foam

// ************************************************************************* //
