/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/


#include "prismPolyMesh.H"
#include "labelPairHashes.H"
#include "ListOps.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static void badEdge
(
    const prismLayers& layers,
    const label facei,
    const edge& e,
    const char* what
)
{
    FatalErrorInFunction
        << "The edge of front face " << facei << " from "
        << layers(e.first(), 0) << " to " << layers(e.second(), 0)
        << ' ' << what << ". Check the surface" << exit(FatalError);
}


//- The front face of each edge in the direction of the face. The front face
//  beyond an edge has the reverse edge.
static labelPairLookup facesOfEdges(const prismLayers& layers)
{
    labelPairLookup faceOf(4*layers.faces.size());

    forAll(layers.faces, facei)
    {
        for (const edge& e : layers.faces[facei].edges())
        {
            if (!faceOf.insert(e, facei))
            {
                badEdge
                (
                    layers, facei, e,
                    faceOf.found(e.reverseEdge())
                  ? "has more than two faces" : "has two faces that are flipped"
                );
            }
        }
    }

    return faceOf;
}


//- The front face beyond edge k of a front face, or -1
static label faceBeyond
(
    const prismLayers& layers,
    const labelPairLookup& faceOf,
    const label facei,
    const label k
)
{
    return faceOf.lookup(layers.faces[facei].faceEdge(k).reverseEdge(), -1);
}


static label cellLabel(const prismLayers& layers, const label f, const label i)
{
    return f*layers.nLayers + i - 1;
}


//- Points on level i of a front face
static face faceAt(const prismLayers& layers, const label facei, const label i)
{
    face f(layers.faces[facei]);

    for (label& p : f)
    {
        p = layers.pointLabel(p, i);
    }

    return f;
}


//- The side of layer i on edge k of a front face. Columns on one point of the
//  wall have a triangle between them.
static face sideFace
(
    const prismLayers& layers,
    const label facei,
    const label k,
    const label i
)
{
    const edge e(layers.faces[facei].faceEdge(k));
    const label start = layers.pointLabel(e.first(), i - 1);
    const label end = layers.pointLabel(e.second(), i - 1);

    face f(start == end ? 3 : 4);
    f[0] = start;
    f[1] = end;
    f[f.size() - 2] = layers.pointLabel(e.second(), i);
    f[f.size() - 1] = layers.pointLabel(e.first(), i);

    return f;
}


//- Upper-triangular order: of the faces of a cell to cells of higher label, the
//  first is the one to the next layer, and those to the stacks of higher front
//  faces follow
static void addInternalFaces
(
    const prismLayers& layers,
    const labelPairLookup& faceOf,
    polyMeshTopology& mesh
)
{
    // Higher front faces beyond, and the edges to them
    DynamicList<labelPair> sides(16);

    forAll(layers.faces, facei)
    {
        sides.clear();

        forAll(layers.faces[facei], k)
        {
            const label beyond = faceBeyond(layers, faceOf, facei, k);

            if (beyond > facei)
            {
                sides.append(labelPair(beyond, k));
            }
        }

        std::sort(sides.begin(), sides.end());

        for (label i = 1; i <= layers.nLayers; ++i)
        {
            const label celli = cellLabel(layers, facei, i);

            if (i < layers.nLayers)
            {
                mesh.append(faceAt(layers, facei, i), celli, celli + 1);
            }

            for (const labelPair& side : sides)
            {
                mesh.append
                (
                    sideFace(layers, facei, side.second(), i),
                    celli,
                    cellLabel(layers, side.first(), i)
                );
            }
        }
    }
}


//- One patch for each of the wall's, whose faces are seen from below
static void addWallFaces(const prismLayers& layers, polyMeshTopology& mesh)
{
    const labelListList patchFaces
    (
        invertOneToMany(layers.patchNames.size(), layers.patchIDs)
    );

    for (const labelList& faces : patchFaces)
    {
        mesh.startPatch();

        for (const label facei : faces)
        {
            mesh.append
            (
                faceAt(layers, facei, 0).reverseFace(),
                cellLabel(layers, facei, 1)
            );
        }
    }
}


static void addOuterFaces(const prismLayers& layers, polyMeshTopology& mesh)
{
    const label n = layers.nLayers;
    mesh.startPatch();

    forAll(layers.faces, facei)
    {
        mesh.append(faceAt(layers, facei, n), cellLabel(layers, facei, n));
    }
}


static void addOpenSides
(
    const prismLayers& layers,
    const labelPairLookup& faceOf,
    polyMeshTopology& mesh
)
{
    mesh.startPatch();

    forAll(layers.faces, facei)
    {
        forAll(layers.faces[facei], k)
        {
            const bool open = faceBeyond(layers, faceOf, facei, k) < 0;

            for (label i = 1; open && i <= layers.nLayers; ++i)
            {
                mesh.append
                (
                    sideFace(layers, facei, k, i), cellLabel(layers, facei, i)
                );
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void polyMeshTopology::reserve(const label nFaces, const label nInternal)
{
    faces.reserve(nFaces);
    owner.reserve(nFaces);
    neighbour.reserve(nInternal);
}


void polyMeshTopology::append
(
    face&& f,
    const label ownerCell,
    const label neighbourCell
)
{
    faces.append(std::move(f));
    owner.append(ownerCell);

    if (neighbourCell >= 0)
    {
        neighbour.append(neighbourCell);
    }
    else
    {
        ++patchSizes.last();
    }
}


void polyMeshTopology::startPatch()
{
    patchStarts.append(faces.size());
    patchSizes.append(0);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

polyMeshTopology makePrismTopology(const prismLayers& layers)
{
    const labelPairLookup faceOf(facesOfEdges(layers));
    label nOpen = 0;
    forAllConstIters(faceOf, iter)
    {
        nOpen += !faceOf.found(edge(iter.key()).reverseEdge());
    }

    const label n = layers.nLayers;
    const label nFront = layers.faces.size();
    const label nInternal = nFront*(n - 1) + (faceOf.size() - nOpen)/2*n;

    polyMeshTopology mesh;
    mesh.reserve(nInternal + nFront + layers.nWallFaces() + nOpen*n, nInternal);
    addInternalFaces(layers, faceOf, mesh);
    addWallFaces(layers, mesh);
    addOuterFaces(layers, mesh);

    if (nOpen)
    {
        addOpenSides(layers, faceOf, mesh);
    }

    return mesh;
}

} // End namespace Foam

// ************************************************************************* //
