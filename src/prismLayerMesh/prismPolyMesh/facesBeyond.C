/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "facesBeyond.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- No front face is beyond an edge; the surface is at fault there
static constexpr label nothingBeyond = -1;
static constexpr label faultBeyond = -2;


//- The front face beyond edge k of a front face; columnFaces has the front
//  faces on each column
static label faceBeyond
(
    const prismLayers& layers,
    const labelListList& columnFaces,
    const label facei,
    const label k
)
{
    const edge e(layers.faces[facei].faceEdge(k));
    label beyond = nothingBeyond;
    label nFaces = 0;
    bool flipped = false;

    for (const label other : columnFaces[e.first()])
    {
        const int direction = layers.faces[other].edgeDirection(e);
        nFaces += direction != 0;

        if (direction && other != facei)
        {
            beyond = other;
            flipped = flipped || direction > 0;
        }
    }

    return nFaces > 2 || flipped ? faultBeyond : beyond;
}


static void requireNoFault
(
    const prismLayers& layers,
    const labelListList& beyond
)
{
    forAll(beyond, facei)
    {
        const label k = beyond[facei].find(faultBeyond);
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

labelListList facesBeyond(const prismLayers& layers)
{
    const labelListList columnFaces
    (
        invertManyToMany<face, labelList>(layers.nColumns(), layers.faces)
    );
    labelListList beyond(layers.faces.size());

    #pragma omp parallel for schedule(static, 256)
    forAll(beyond, facei)
    {
        beyond[facei].setSize(layers.faces[facei].size());
        forAll(beyond[facei], k)
        {
            beyond[facei][k] = faceBeyond(layers, columnFaces, facei, k);
        }
    }
    requireNoFault(layers, beyond);

    return beyond;
}

} // End namespace Foam

// ************************************************************************* //
