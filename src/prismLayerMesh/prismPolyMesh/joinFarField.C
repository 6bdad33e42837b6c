/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "prismPolyMesh.H"
#include "ListOps.H"
#include "triangleIndex.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Labels in the mesh of the points of the far field: those on the layers are
//  the layers', the others come after these
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


//- Faces of the mesh, one after the other
struct faceAppender
{
    //- In the mesh, of the points of the far field
    const labelList& labels;

    DynamicList<face> faces;
    DynamicList<label> owner;
    DynamicList<label> neighbour;

    void append
    (
        const face& f,
        const label ownerCell,
        const label neighbourCell
    )
    {
        faces.append(f);
        owner.append(ownerCell);

        if (neighbourCell >= 0)
        {
            neighbour.append(neighbourCell);
        }
    }

    //- A face of the far field
    void appendFar
    (
        const face& f,
        const label ownerCell,
        const label neighbourCell
    )
    {
        append
        (
            face(UIndirectList<label>(labels, f)()),
            ownerCell, neighbourCell
        );
    }
};


//- Tetrahedra behind the triangles of the boundary: those on the layers, then
//  those of the far boundary
struct boundaryTets
{
    labelList onLayers;
    labelList onFar;
};


static boundaryTets findBoundaryTets(const farFieldMesh& far)
{
    const triangleIndex onLayers(makeTriangleIndex(far.outerTriangles));
    const triangleIndex onFar(makeTriangleIndex(far.boundaryTriangles));

    boundaryTets tets;
    tets.onLayers = labelList(far.outerTriangles.size(), -1);
    tets.onFar = labelList(far.boundaryTriangles.size(), -1);

    forAll(far.tets, t)
    {
        for (label i = 0; i < 4; ++i)
        {
            if (far.neighbours[t][i] < 0)
            {
                const triFace f(far.tets[t].face(i));
                const label triangle = onLayers.lookup(f, -1);

                if (triangle >= 0)
                {
                    tets.onLayers[triangle] = t;
                }
                else
                {
                    tets.onFar[onFar.lookup(f, -1)] = t;
                }
            }
        }
    }

    return tets;
}


//- Faces between layers, and after those of each last cell those to the
//  tetrahedra on it
static void addLayerFaces
(
    const prismLayers& layers,
    const polyMeshTopology& prisms,
    const farFieldMesh& far,
    const labelList& tets,
    faceAppender& to
)
{
    const label n = layers.nLayers;
    const label firstTet = layers.faces.size()*n;
    label facei = 0;
    label trianglei = 0;

    // Tetrahedra on a last cell, with their triangles
    DynamicList<labelPair> beyond;

    forAll(layers.faces, fronti)
    {
        const label last = fronti*n + n - 1;

        for
        (
            ;
            facei < prisms.neighbour.size() && prisms.owner[facei] <= last;
            ++facei
        )
        {
            to.append
            (
                prisms.faces[facei], prisms.owner[facei],
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
            to.appendFar
            (
                far.outerTriangles[b.second()], last, firstTet + b.first()
            );
        }
    }
}


static void addTetFaces
(
    const farFieldMesh& far,
    const label firstTet,
    faceAppender& to
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
            to.appendFar
            (
                far.tets[t].face(b.second()).triFaceFace(),
                firstTet + t, firstTet + b.first()
            );
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::polyMeshTopology Foam::joinFarField
(
    const prismLayers& layers,
    const polyMeshTopology& prisms,
    const label nLayerPoints,
    const farFieldMesh& far
)
{
    const labelList labels(meshLabels(layers, nLayerPoints, far));
    const boundaryTets tets(findBoundaryTets(far));
    const label firstTet = layers.faces.size()*layers.nLayers;

    const labelListList farFaces
    (
        invertOneToMany(far.patchNames.size(), far.patchIDs)
    );

    faceAppender to{labels, {}, {}, {}};
    to.faces.reserve(prisms.faces.size() + 2*far.tets.size());
    to.owner.reserve(prisms.faces.size() + 2*far.tets.size());
    to.neighbour.reserve(prisms.faces.size() + 2*far.tets.size());
    addLayerFaces(layers, prisms, far, tets.onLayers, to);
    addTetFaces(far, firstTet, to);

    polyMeshTopology mesh;

    forAll(layers.patchNames, patchi)
    {
        const label start = prisms.patchStarts[patchi];
        const label size = prisms.patchSizes[patchi];
        mesh.patchStarts.append(to.faces.size());
        mesh.patchSizes.append(size);

        for (label facei = start; facei < start + size; ++facei)
        {
            to.append(prisms.faces[facei], prisms.owner[facei], -1);
        }
    }

    // Seen from inside, the normals of the boundary's triangles point at us
    for (const labelList& triangles : farFaces)
    {
        mesh.patchStarts.append(to.faces.size());
        mesh.patchSizes.append(triangles.size());

        for (const label i : triangles)
        {
            to.appendFar
            (
                far.boundaryTriangles[i].reverseFace(),
                firstTet + tets.onFar[i], -1
            );
        }
    }

    mesh.faces.transfer(to.faces);
    mesh.owner.transfer(to.owner);
    mesh.neighbour.transfer(to.neighbour);

    return mesh;
}


// ************************************************************************* //
