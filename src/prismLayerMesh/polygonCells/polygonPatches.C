/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polygonPatches.H"

#include "layerPolygons.H"
#include "prismFaces.H"
#include "prismPolyMesh.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

polygonPatches::polygonPatches
(
    const prismLayers& layers,
    const labelListList& faceNeighbours,
    farFieldMesh& far
)
{
    const List<DynamicList<labelPair>> open(openEdges(layers, faceNeighbours));
    all = patchesOfMesh(layers, open.size(), far);
    const label firstOpen = layers.patchNames.size() + 1;
    labelList ofLayers(firstOpen + open.size(), label(-1));
    ofFar.setSize(far.topology.patchStarts.size(), -1);
    const List<labelPair> parts(partsOfPatches(layers, open.size(), far));
    forAll(parts, patchi)
    {
        if (parts[patchi].first() >= 0)
        {
            ofLayers[parts[patchi].first()] = patchi;
        }
        if (parts[patchi].second() >= 0)
        {
            ofFar[parts[patchi].second()] = patchi;
        }
    }
    const labelList starts(cornerStarts(layers));
    ofEdges.setSize(starts.last(), -1);
    forAll(open, i)
    {
        for (const labelPair& e : open[i])
        {
            ofEdges[starts[e.first()] + e.second()] = ofLayers[firstOpen + i];
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
