/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "findFaceNeighbours.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- No front face is across an edge; the surface is at fault there
static constexpr label noNeighbour = -1;
static constexpr label faultyEdge = -2;


//- The front face across edge k of a front face; columnFaces has the front
//  faces on each column
static label faceNeighbour
(
    const prismLayers& layers,
    const labelListList& columnFaces,
    const label facei,
    const label k
)
{
    const edge e(layers.faces[facei].faceEdge(k));
    label neighbour = noNeighbour;
    label nFaces = 0;
    bool flipped = false;

    for (const label other : columnFaces[e.first()])
    {
        const int direction = layers.faces[other].edgeDirection(e);
        nFaces += direction != 0;

        if (direction && other != facei)
        {
            neighbour = other;
            flipped = flipped || direction > 0;
        }
    }

    return nFaces > 2 || flipped ? faultyEdge : neighbour;
}


static void requireNoFault
(
    const prismLayers& layers,
    const labelListList& faceNeighbours
)
{
    forAll(faceNeighbours, facei)
    {
        const label k = faceNeighbours[facei].find(faultyEdge);
        if (k >= 0)
        {
            const edge e(layers.faces[facei].faceEdge(k));

            FatalErrorInFunction
                << "The edge of front face " << facei << " from "
                << layers(e.first(), 0) << " to " << layers(e.second(), 0)
                << " has more than two faces, or two that are flipped."
                << " Check the surface" << exit(FatalError);
        }
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelListList findFaceNeighbours(const prismLayers& layers)
{
    const labelListList columnFaces
    (
        invertManyToMany<face, labelList>(layers.nColumns(), layers.faces)
    );
    labelListList faceNeighbours(layers.faces.size());

    #pragma omp parallel for schedule(static, 256)
    forAll(faceNeighbours, facei)
    {
        faceNeighbours[facei].setSize(layers.faces[facei].size());
        forAll(faceNeighbours[facei], k)
        {
            faceNeighbours[facei][k] =
                faceNeighbour(layers, columnFaces, facei, k);
        }
    }
    requireNoFault(layers, faceNeighbours);

    return faceNeighbours;
}

} // End namespace Foam

// ************************************************************************* //
