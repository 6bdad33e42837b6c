/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismPolyMesh.H"
#include "EdgeMap.H"
#include "facesBeyond.H"
#include "ListOps.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


//- Set the internal faces of the stack on a front face, from index 'at' on.
//  Upper-triangular order: of the faces of a cell to cells of higher label, the
//  first is the one to the next layer, and those to the stacks of higher front
//  faces follow.
static void setInternalFaces
(
    const prismLayers& layers,
    const labelUList& beyond,
    const label facei,
    label at,
    polyMeshTopology& mesh
)
{
    // Higher front faces beyond, and the edges to them
    DynamicList<labelPair> sides(16);
    forAll(beyond, k)
    {
        if (beyond[k] > facei)
        {
            sides.append(labelPair(beyond[k], k));
        }
    }
    std::sort(sides.begin(), sides.end());

    const auto set = [&](face&& f, const label celli, const label other)
    {
        mesh.faces[at] = std::move(f);
        mesh.owner[at] = celli;
        mesh.neighbour[at] = other;
        ++at;
    };

    for (label i = 1; i <= layers.nLayers; ++i)
    {
        const label celli = cellLabel(layers, facei, i);

        if (i < layers.nLayers)
        {
            set(faceAt(layers, facei, i), celli, celli + 1);
        }

        for (const labelPair& side : sides)
        {
            set
            (
                sideFace(layers, facei, side.second(), i),
                celli,
                cellLabel(layers, side.first(), i)
            );
        }
    }
}


static void addInternalFaces
(
    const prismLayers& layers,
    const labelListList& beyond,
    polyMeshTopology& mesh
)
{
    const label n = layers.nLayers;
    labelList starts(beyond.size() + 1, 0);
    forAll(beyond, facei)
    {
        label nHigher = 0;
        for (const label other : beyond[facei])
        {
            nHigher += other > facei;
        }
        starts[facei + 1] = starts[facei] + n - 1 + nHigher*n;
    }
    mesh.faces.setSize(starts.last());
    mesh.owner.setSize(starts.last());
    mesh.neighbour.setSize(starts.last());

    #pragma omp parallel for schedule(static, 256)
    forAll(beyond, facei)
    {
        setInternalFaces(layers, beyond[facei], facei, starts[facei], mesh);
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


//- Edges of front faces with nothing beyond, as face and index, by the patch of
//  sidePatchNames that they are on; those on none come last
static List<DynamicList<labelPair>> openEdges
(
    const prismLayers& layers,
    const labelListList& beyond
)
{
    const wordList names(sidePatchNames(layers.border));
    EdgeMap<label> patchOf(2*layers.border.edges.size());
    forAll(layers.border.edges, i)
    {
        const sidePatch& side =
            layers.border.sides[layers.border.edgeSides[i]];
        patchOf.insert(layers.border.edges[i], names.find(side.name));
    }

    List<DynamicList<labelPair>> edges(names.size() + 1);

    forAll(layers.faces, facei)
    {
        const face& f = layers.faces[facei];

        forAll(f, k)
        {
            if (beyond[facei][k] < 0)
            {
                edges[patchOf.lookup(f.faceEdge(k), names.size())].append
                (
                    labelPair(facei, k)
                );
            }
        }
    }

    return edges;
}


static void addOpenSides
(
    const prismLayers& layers,
    const UList<labelPair>& edges,
    polyMeshTopology& mesh
)
{
    mesh.startPatch();

    for (const labelPair& e : edges)
    {
        for (label i = 1; i <= layers.nLayers; ++i)
        {
            mesh.append
            (
                sideFace(layers, e.first(), e.second(), i),
                cellLabel(layers, e.first(), i)
            );
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


polyMeshTopology makePrismTopology(const prismLayers& layers)
{
    const labelListList beyond(facesBeyond(layers));
    const List<DynamicList<labelPair>> open(openEdges(layers, beyond));
    label nEdges = 0, nOpen = 0;
    for (const face& f : layers.faces)
    {
        nEdges += f.size();
    }
    for (const DynamicList<labelPair>& edges : open)
    {
        nOpen += edges.size();
    }

    const label n = layers.nLayers;
    const label nFront = layers.faces.size();
    const label nInternal = nFront*(n - 1) + (nEdges - nOpen)/2*n;

    polyMeshTopology mesh;
    mesh.reserve(nInternal + nFront + layers.nWallFaces() + nOpen*n, nInternal);
    addInternalFaces(layers, beyond, mesh);
    addWallFaces(layers, mesh);
    addOuterFaces(layers, mesh);

    forAll(open, patchi)
    {
        if (patchi < open.size() - 1 || open[patchi].size())
        {
            addOpenSides(layers, open[patchi], mesh);
        }
    }

    return mesh;
}

} // End namespace Foam

// ************************************************************************* //
