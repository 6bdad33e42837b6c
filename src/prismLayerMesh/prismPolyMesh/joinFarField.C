/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismPolyMesh.H"
#include "ListOps.H"
#include "triangleIndex.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The labels in the mesh of the points of the far field
static labelList meshLabels
(
    const prismLayers& layers,
    const label nLayerPoints,
    const farFieldMesh& far
)
{
    const label nColumns = layers.nColumns();
    labelList labels(far.points.size());

    forAll(labels, p)
    {
        labels[p] = p < nColumns
          ? layers.pointLabel(p, layers.nLayers) : nLayerPoints + p - nColumns;
    }

    return labels;
}


//- A face of the far field with the labels of the mesh
static face farFace(const labelList& labels, const labelUList& f)
{
    return face(UIndirectList<label>(labels, f)());
}


//- The tetrahedra on the outer triangles, then those on the far boundary's
static labelList boundaryTets(const farFieldMesh& far)
{
    faceList triangles(far.outerTriangles);
    triangles.append(far.boundaryTriangles);
    const triangleIndex index(makeTriangleIndex(triangles));
    labelList tets(triangles.size(), -1);

    forAll(far.tets, t)
    {
        for (label i = 0; i < 4; ++i)
        {
            if (far.neighbours[t][i] < 0)
            {
                tets[index[far.tets[t].face(i)]] = t;
            }
        }
    }

    return tets;
}


//- Internal faces of the layers, and after those of each last cell those to the
//  tetrahedra on it
static void addLayerFaces
(
    const prismLayers& layers,
    const polyMeshTopology& prisms,
    const farFieldMesh& far,
    const labelList& tets,
    const labelList& labels,
    polyMeshTopology& mesh
)
{
    const label n = layers.nLayers;
    const label firstTet = layers.faces.size()*n;
    const label nInternal = prisms.neighbour.size();
    label facei = 0;
    label trianglei = 0;

    // Tetrahedra on a last cell, with their triangles
    DynamicList<labelPair> beyond;

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

        beyond.clear();
        for
        (
            ;
            trianglei < far.outerFaces.size()
         && far.outerFaces[trianglei] == fronti;
            ++trianglei
        )
        {
            beyond.append(labelPair(tets[trianglei], trianglei));
        }
        std::sort(beyond.begin(), beyond.end());

        for (const labelPair& b : beyond)
        {
            mesh.append
            (
                farFace(labels, far.outerTriangles[b.second()]),
                last,
                firstTet + b.first()
            );
        }
    }
}


static void addTetFaces
(
    const farFieldMesh& far,
    const label firstTet,
    const labelList& labels,
    polyMeshTopology& mesh
)
{
    // Later tetrahedra, with the face to them
    DynamicList<labelPair> beyond(4);

    forAll(far.tets, t)
    {
        beyond.clear();
        for (label i = 0; i < 4; ++i)
        {
            if (far.neighbours[t][i] > t)
            {
                beyond.append(labelPair(far.neighbours[t][i], i));
            }
        }
        std::sort(beyond.begin(), beyond.end());

        for (const labelPair& b : beyond)
        {
            mesh.append
            (
                farFace(labels, far.tets[t].face(b.second()).triFaceFace()),
                firstTet + t,
                firstTet + b.first()
            );
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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

polyMeshTopology joinFarField
(
    const prismLayers& layers,
    const polyMeshTopology& prisms,
    const label nLayerPoints,
    const farFieldMesh& far
)
{
    const labelList labels(meshLabels(layers, nLayerPoints, far));
    const labelList tets(boundaryTets(far));
    const label firstTet = layers.faces.size()*layers.nLayers;
    const label nFaces = prisms.faces.size() + 2*far.tets.size();

    polyMeshTopology mesh;
    mesh.reserve(nFaces, nFaces);
    addLayerFaces(layers, prisms, far, tets, labels, mesh);
    addTetFaces(far, firstTet, labels, mesh);

    forAll(layers.patchNames, patchi)
    {
        mesh.startPatch();
        addPatchFaces(prisms, patchi, mesh);
    }

    // Seen from inside, the normals of the boundary's triangles point at us
    const labelListList farFaces
    (
        invertOneToMany(far.patchNames.size(), far.patchIDs)
    );

    const wordList sideNames(sidePatchNames(layers.border));

    forAll(farFaces, patchi)
    {
        mesh.startPatch();

        // After those of the wall and the outer surface
        const label side = sideNames.find(far.patchNames[patchi]);
        if (side >= 0)
        {
            const label sidei = layers.patchNames.size() + 1 + side;
            addPatchFaces(prisms, sidei, mesh);
        }

        for (const label i : farFaces[patchi])
        {
            mesh.append
            (
                farFace(labels, far.boundaryTriangles[i].reverseFace()),
                firstTet + tets[far.outerTriangles.size() + i]
            );
        }
    }

    return mesh;
}

} // End namespace Foam

// ************************************************************************* //
