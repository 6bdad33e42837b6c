/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismPolyMesh.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Gives the faces of the far field the labels that its points have in the mesh
static void setMeshPoints
(
    const prismLayers& layers,
    const label nLayerPoints,
    farFieldMesh& far
)
{
    const label nColumns = layers.nColumns();

    for (face& f : far.topology.faces)
    {
        for (label& p : f)
        {
            p = p < nColumns
              ? layers.pointLabel(p, layers.nLayers)
              : nLayerPoints + p - nColumns;
        }
    }
}


//- Internal faces of the layers, and after those of each last cell those to the
//  far field
static void addLayerFaces
(
    const prismLayers& layers,
    const polyMeshTopology& prisms,
    const label firstFar,
    farFieldMesh& far,
    polyMeshTopology& mesh
)
{
    const label n = layers.nLayers;
    const label nInternal = prisms.neighbour.size();
    const label start = far.topology.patchStarts[0];
    label facei = 0;
    label outeri = 0;

    // Cells of the far field on a last cell, with their faces
    DynamicList<labelPair> neighbours;

    forAll(layers.faces, fronti)
    {
        const label last = fronti*n + n - 1;

        for (; facei < nInternal && prisms.owner[facei] <= last; ++facei)
        {
            mesh.append
            (
                face(prisms.faces[facei]),
                prisms.owner[facei],
                prisms.neighbour[facei]
            );
        }

        neighbours.clear();
        for
        (
            ;
            outeri < far.frontFaces.size() && far.frontFaces[outeri] == fronti;
            ++outeri
        )
        {
            const label i = start + outeri;
            neighbours.append(labelPair(far.topology.owner[i], i));
        }
        std::sort(neighbours.begin(), neighbours.end());

        for (const labelPair& b : neighbours)
        {
            face& f = far.topology.faces[b.second()];
            f.flip();
            mesh.append(std::move(f), last, firstFar + b.first());
        }
    }
}


static void addPatchFaces
(
    const polyMeshTopology& prisms,
    const label patchi,
    polyMeshTopology& mesh
)
{
    const label start = prisms.patchStarts[patchi];

    for (label i = start; i < start + prisms.patchSizes[patchi]; ++i)
    {
        mesh.append(face(prisms.faces[i]), prisms.owner[i]);
    }
}


//- Gives the zones the labels of the mesh. Cells of the far field follow the
//  cells of the layers; the list has the new label of each face.
static void renumberZones
(
    const label nFrontFaces,
    const label nLayers,
    const labelList& newFaces,
    farFieldMesh& far
)
{
    for (cellZoneParts& zone : far.cellZones)
    {
        DynamicList<label> cells
        (
            zone.frontFaces.size()*nLayers + zone.cells.size()
        );
        for (const label fronti : zone.frontFaces)
        {
            for (label i = 0; i < nLayers; ++i)
            {
                cells.append(fronti*nLayers + i);
            }
        }
        for (const label celli : zone.cells)
        {
            cells.append(nFrontFaces*nLayers + celli);
        }
        zone.cells.transfer(cells);
    }

    for (faceZoneParts& zone : far.faceZones)
    {
        inplaceRenumber(newFaces, zone.faces);
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

polyMeshTopology joinFarField
(
    const prismLayers& layers,
    const polyMeshTopology& prisms,
    const label nLayerPoints,
    farFieldMesh& far
)
{
    const label firstFar = layers.faces.size()*layers.nLayers;
    const wordList sideNames(sidePatchNames(layers.border));
    labelList newFaces(far.topology.faces.size(), -1);

    const polyMeshTopology& t = far.topology;
    polyMeshTopology mesh;
    mesh.reserve
    (
        prisms.faces.size() + t.faces.size(),
        prisms.neighbour.size() + t.neighbour.size() + far.frontFaces.size()
    );
    const auto addFar = [&](const label facei)
    {
        newFaces[facei] = mesh.faces.size();
        const label neighbour =
            facei < t.neighbour.size() ? firstFar + t.neighbour[facei] : -1;
        const label owner = firstFar + t.owner[facei];
        mesh.append(std::move(far.topology.faces[facei]), owner, neighbour);
    };

    setMeshPoints(layers, nLayerPoints, far);
    addLayerFaces(layers, prisms, firstFar, far, mesh);
    forAll(t.neighbour, facei)
    {
        addFar(facei);
    }
    forAll(layers.patchNames, patchi)
    {
        mesh.startPatch();
        addPatchFaces(prisms, patchi, mesh);
    }

    forAll(far.patches.names, patchi)
    {
        // After those of the wall and the outer surface
        mesh.startPatch();
        const label side = sideNames.find(far.patches.names[patchi]);
        if (side >= 0)
        {
            addPatchFaces(prisms, layers.patchNames.size() + 1 + side, mesh);
        }

        for (label i = 0; i < t.patchSizes[1 + patchi]; ++i)
        {
            addFar(t.patchStarts[1 + patchi] + i);
        }
    }

    renumberZones(layers.faces.size(), layers.nLayers, newFaces, far);

    return mesh;
}

} // End namespace Foam

// ************************************************************************* //
