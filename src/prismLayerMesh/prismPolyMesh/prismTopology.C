/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismPolyMesh.H"
#include "findFaceNeighbours.H"
#include "meshOrder.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Copies a block of faces to its place in a mesh
static void copyFaces
(
    const faceBlock& block,
    const label firstFace,
    const label firstInternal,
    polyMeshTopology& mesh
)
{
    forAll(block.ends, i)
    {
        mesh.faces[firstFace + i] = face(block.face(i));
        mesh.owner[firstFace + i] = block.owner[i];
    }
    forAll(block.neighbour, i)
    {
        mesh.neighbour[firstInternal + i] = block.neighbour[i];
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

polyMeshTopology makeTopology(const meshOrder& order)
{
    const meshBlocks& blocks = order.blocks();
    polyMeshTopology mesh;
    mesh.faces.setSize(blocks.nFaces());
    mesh.owner.setSize(blocks.nFaces());
    mesh.neighbour.setSize(blocks.nInternalFaces());

    #pragma omp parallel for schedule(dynamic)
    for (label i = 0; i < blocks.nFaceBlocks; ++i)
    {
        copyFaces
        (
            blocks.faces(i), blocks.firstFaces[i], blocks.firstInternal[i], mesh
        );
    }

    mesh.patchStarts = order.patchStarts();
    const label nPatches = mesh.patchStarts.size() - 1;
    mesh.patchSizes.setSize(nPatches);
    forAll(mesh.patchSizes, patchi)
    {
        mesh.patchSizes[patchi] =
            mesh.patchStarts[patchi + 1] - mesh.patchStarts[patchi];
    }
    mesh.patchStarts.setSize(nPatches);

    return mesh;
}


polyMeshTopology makePrismTopology
(
    const prismLayers& layers,
    const labelListList& faceNeighbours,
    const UList<DynamicList<labelPair>>& open
)
{
    const farFieldMesh none;

    return makeTopology
    (
        meshOrder(layers, none, labelListList(faceNeighbours), open)
    );
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
