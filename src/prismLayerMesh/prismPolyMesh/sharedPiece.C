/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sharedPiece.H"
#include "layersDivider.H"
#include "SubField.H"

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
    const pointField centres(team.faces.onMaster(centresOfStacks(own)));
    const labelListList neighbours(divider.neighbours());
    labelList processors
    (
        team.isMaster() ? divide(neighbours, centres) : labelList()
    );
    team.broadcast(processors);

    return processors;
}


//- Set the points of a piece, from the owners of its columns. Collective
static void setPoints
(
    const prismLayers& own,
    const columnTeam& team,
    layersPiece& piece
)
{
    labelList owners(piece.columns.size());
    forAll(owners, c)
    {
        owners[c] = team.owner(piece.columns[piece.layers.root(c)]);
    }
    piece.layers.points = team.columns.at
    (
        piece.columns, owners, own.points, own.nLayers + 1
    );
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

pointField centresOfStacks(const prismLayers& layers)
{
    pointField centres(layers.faces.size(), Zero);
    const label n = layers.nLayers + 1;

    forAll(centres, facei)
    {
        const face& f = layers.faces[facei];
        for (const label c : f)
        {
            centres[facei] += sum(SubField<point>(layers.points, n, c*n));
        }
        centres[facei] /= f.size()*n;
    }

    return centres;
}


layersPiece makeLayersPiece
(
    const prismLayers& own,
    const columnTeam& team,
    const stackDivision& divide
)
{
    layersPiece piece;
    {
        const layersDivider divider(own, team);
        const labelList processors
        (
            processorsOfStacks(divider, own, team, divide)
        );
        piece = divider.assemble
        (
            team.exchange(divider.stacksByProcess(processors, team.size())),
            processors
        );
    }
    setPoints(own, team, piece);

    return piece;
}

} // End namespace Foam

// ************************************************************************* //
