/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismFaces.H"
#include "EdgeMap.H"
#include "prismPolyMesh.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

face sideFace
(
    const prismLayers& layers,
    const edge& e,
    const label i
)
{
    const label start = layers.pointLabel(e.first(), i - 1);
    const label end = layers.pointLabel(e.second(), i - 1);

    face f(start == end ? 3 : 4);
    f[0] = start;
    f[1] = end;
    f[f.size() - 2] = layers.pointLabel(e.second(), i);
    f[f.size() - 1] = layers.pointLabel(e.first(), i);

    return f;
}


face prismFace
(
    const prismLayers& layers,
    const label facei,
    const label k,
    const label i
)
{
    return
        k >= 0 ? sideFace(layers, layers.faces[facei].faceEdge(k), i)
      : i > 0 ? faceAt(layers, facei, i)
      : faceAt(layers, facei, 0).reverseFace();
}


List<DynamicList<labelPair>> openEdges
(
    const prismLayers& layers,
    const labelListList& faceNeighbours
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
            if (faceNeighbours[facei][k] < 0)
            {
                edges[patchOf.lookup(f.faceEdge(k), names.size())].append
                (
                    labelPair(facei, k)
                );
            }
        }
    }

    if (edges.last().empty())
    {
        edges.setSize(names.size());
    }

    return edges;
}


label nHigherNeighbours(const labelUList& faceNeighbours, const label facei)
{
    return std::count_if
    (
        faceNeighbours.begin(), faceNeighbours.end(),
        [&](const label other) { return other > facei; }
    );
}


labelList firstInternalFaces
(
    const labelListList& faceNeighbours,
    const label nLayers
)
{
    labelList starts(faceNeighbours.size() + 1, 0);
    forAll(faceNeighbours, facei)
    {
        starts[facei + 1] = starts[facei] + nLayers - 1
          + nHigherNeighbours(faceNeighbours[facei], facei)*nLayers;
    }

    return starts;
}

} // End namespace Foam

// ************************************************************************* //
