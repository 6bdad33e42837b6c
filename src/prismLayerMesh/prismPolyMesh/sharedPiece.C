/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sharedPiece.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The process of each stack of the whole front. Collective
static labelList processorsOfStacks
(
    const layersDivider& divider,
    const prismLayers& own,
    const columnTeam& team,
    const stackDivision& divide
)
{
    const pointField centres
    (
        team.facesOnMaster(centresOfStacks(own), own.faces)
    );
    labelList processors
    (
        team.isMaster() ? divide(divider.neighbours(), centres) : labelList()
    );
    team.broadcast(processors);

    return processors;
}


//- Set the points of a piece, from the owners of its columns. Collective
static void setPoints
(
    const prismLayers& whole,
    const prismLayers& own,
    const columnTeam& team,
    layersPiece& piece
)
{
    labelList owners(piece.columns);
    for (label& c : owners)
    {
        c = team.owner(whole.root(c));
    }
    piece.layers.points = team.valuesOf
    (
        piece.columns, owners, own.points, own.nLayers + 1
    );
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

prismLayers wholeLayers(const layerFront& whole, const label nLayers)
{
    const wallSurface& surface = whole.surface;
    prismLayers layers;
    layers.nLayers = nLayers;
    layers.points.setSize(surface.points.size()*(nLayers + 1));
    layers.extraColumnPoints = whole.extraColumnPoints();
    layers.faces = surface.faces;
    layers.patchIDs = SubList<label>(surface.patchIDs, whole.nWallFaces);
    layers.patchNames = surface.patchNames;
    layers.patchTypes = surface.patchTypes;
    layers.border = surface.border;

    return layers;
}


layersPiece makeLayersPiece
(
    const prismLayers& whole,
    const prismLayers& own,
    const columnTeam& team,
    const stackDivision& divide
)
{
    layersPiece piece;
    {
        const layersDivider divider(whole);
        piece = divider.piece
        (
            processorsOfStacks(divider, own, team, divide), team.rank()
        );
    }
    setPoints(whole, own, team, piece);

    return piece;
}

} // End namespace Foam

// ************************************************************************* //
