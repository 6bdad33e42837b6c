/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismPolyMesh.H"
#include "findFaceNeighbours.H"
#include "prismFaces.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static void addInternalFaces
(
    const prismLayers& layers,
    const labelListList& faceNeighbours,
    const labelList& starts,
    polyMeshTopology& mesh
)
{
    mesh.faces.setSize(starts.last());
    mesh.owner.setSize(starts.last());
    mesh.neighbour.setSize(starts.last());

    #pragma omp parallel for schedule(static, 256)
    forAll(faceNeighbours, facei)
    {
        label at = starts[facei];
        visitInternalFaces
        (
            layers.nLayers, faceNeighbours[facei], facei,
            [&](const label k, const label i, const label other)
            {
                const label celli = cellLabel(layers, facei, i);
                mesh.faces[at] = prismFace(layers, facei, k, i);
                mesh.owner[at] = celli;
                mesh.neighbour[at] =
                    k < 0 ? celli + 1 : cellLabel(layers, other, i);
                ++at;
            }
        );
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

wordList sidePatchNames(const wallBorder& border)
{
    DynamicList<word> names;
    for (const sidePatch& side : border.sides)
    {
        if (!names.found(side.name))
        {
            names.append(side.name);
        }
    }

    return wordList(std::move(names));
}


polyMeshTopology makePrismTopology
(
    const prismLayers& layers,
    const labelListList& faceNeighbours,
    const UList<DynamicList<labelPair>>& open
)
{
    const label n = layers.nLayers;
    label nBoundary = layers.nWallFaces() + layers.faces.size();
    for (const DynamicList<labelPair>& edges : open)
    {
        nBoundary += edges.size()*n;
    }

    const labelList starts(firstInternalFaces(faceNeighbours, n));
    polyMeshTopology mesh;
    mesh.reserve(starts.last() + nBoundary, starts.last());
    addInternalFaces(layers, faceNeighbours, starts, mesh);
    visitBoundaryFaces
    (
        layers, open, [&]() { mesh.startPatch(); },
        [&](const label facei, const label k, const label i)
        {
            mesh.append
            (
                prismFace(layers, facei, k, i),
                cellLabel(layers, facei, max(i, label(1)))
            );
        }
    );

    return mesh;
}


polyMeshTopology makePrismTopology(const prismLayers& layers)
{
    const labelListList faceNeighbours(findFaceNeighbours(layers));

    return makePrismTopology
    (
        layers, faceNeighbours, openEdges(layers, faceNeighbours)
    );
}

} // End namespace Foam

// ************************************************************************* //
