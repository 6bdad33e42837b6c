/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "faceHeights.H"
#include "stackHeights.H"

namespace Foam
{

faceHeights makeFaceHeights
(
    const wallSurface& wall,
    const layerSpacing& request,
    const prismLayers& layers
)
{
    const label nFaces = wall.faces.size();
    const label n = layers.nLayers;

    faceHeights result;
    result.areas.setSize(nFaces);
    result.first.setSize(nFaces);
    result.firstOverRequest.setSize(nFaces);
    result.totalOverRequest.setSize(nFaces);
    result.growthOverRequest.setSize(nFaces*(n - 1));

    #pragma omp parallel for schedule(static, 256)
    forAll(wall.faces, facei)
    {
        const face& f = wall.faces[facei];
        stackHeights stack(layers);
        stack.compute(facei);
        const scalarField& heights = stack.heights();
        const scalar ratio = average(scalarField(request.ratio, f));

        result.areas[facei] = stack.wallArea();
        result.first[facei] = heights[0];
        result.firstOverRequest[facei] =
            heights[0]/average(scalarField(request.firstThickness, f));
        result.totalOverRequest[facei] =
            sum(heights)/average(scalarField(request.thickness, f));

        for (label i = 1; i < n; ++i)
        {
            result.growthOverRequest[facei*(n - 1) + i - 1] =
                heights[i]/(ratio*max(heights[i - 1], VSMALL));
        }
    }

    return result;
}


scalarField changesOverEdges
(
    const UList<labelPair>& edgeFaces,
    const scalarField& ofFaces
)
{
    scalarField changes(edgeFaces.size());

    forAll(changes, edgei)
    {
        const labelPair& faces = edgeFaces[edgei];
        const scalar a = ofFaces[faces.first()];
        const scalar b = faces.second() < 0 ? a : ofFaces[faces.second()];

        changes[edgei] = max(a, b)/max(min(a, b), VSMALL);
    }

    return changes;
}

} // End namespace Foam

// ************************************************************************* //
