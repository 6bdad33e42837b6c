/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismFaces.H"
#include "cyclicColumns.H"
#include "EdgeMap.H"
#include "ListOps.H"
#include "prismPolyMesh.H"
#include "prismQuality.H"

namespace Foam
{

//- No front face is across an edge; the surface is at fault there
static constexpr label noNeighbour = -1;
static constexpr label faultyEdge = -2;


//- The front face across edge k of a front face; columnFaces has the front
//  faces on each column
static label faceNeighbour
(
    const prismLayers& layers,
    const labelListList& columnFaces,
    const label facei,
    const label k
)
{
    const edge e(layers.faces[facei].faceEdge(k));
    label neighbour = noNeighbour;
    label nFaces = 0;
    bool flipped = false;

    for (const label other : columnFaces[e.first()])
    {
        const int direction = layers.faces[other].edgeDirection(e);
        nFaces += direction != 0;

        if (direction && other != facei)
        {
            neighbour = other;
            flipped = flipped || direction > 0;
        }
    }

    return nFaces > 2 || flipped ? faultyEdge : neighbour;
}


static void requireNoFault
(
    const prismLayers& layers,
    const labelListList& faceNeighbours
)
{
    forAll(faceNeighbours, facei)
    {
        const label k = faceNeighbours[facei].find(faultyEdge);
        if (k >= 0)
        {
            const edge e(layers.faces[facei].faceEdge(k));

            FatalErrorInFunction
                << "The edge of front face " << facei << " from "
                << layers(e.first(), 0) << " to " << layers(e.second(), 0)
                << " has more than two faces, or two that are flipped."
                << " Check the surface" << exit(FatalError);
        }
    }
}


labelListList findFaceNeighbours(const prismLayers& layers)
{
    const labelListList columnFaces
    (
        invertManyToMany<face, labelList>(layers.nColumns(), layers.faces)
    );
    labelListList faceNeighbours(layers.faces.size());

    #pragma omp parallel for schedule(static, 256)
    forAll(faceNeighbours, facei)
    {
        faceNeighbours[facei].setSize(layers.faces[facei].size());
        forAll(faceNeighbours[facei], k)
        {
            faceNeighbours[facei][k] =
                faceNeighbour(layers, columnFaces, facei, k);
        }
    }
    requireNoFault(layers, faceNeighbours);

    return faceNeighbours;
}


// * * * * * * * * * * * * * * *  Prism Faces  * * * * * * * * * * * * * * * //

//- Appends the points of the side of layer i on an edge of a front face, seen
//  from outside of its cell. Columns on one point of the wall have a triangle
//  between them.
static void appendSide
(
    const prismLayers& layers,
    const edge& e,
    const label i,
    const bool isSecond,
    DynamicList<label>& points
)
{
    const label start = layers.pointLabel(e.first(), i - 1);
    const label end = layers.pointLabel(e.second(), i - 1);

    if (!isSecond || end == start)
    {
        points.append(start);
    }
    if (end != start)
    {
        points.append(end);
    }
    points.append(layers.pointLabel(e.second(), i));
    points.append(layers.pointLabel(e.first(), i));
    if (isSecond && end != start)
    {
        points.append(start);
    }
}


void appendFace
(
    const prismLayers& layers,
    const prismFaceKey& key,
    DynamicList<label>& points
)
{
    if (key.edge >= 0)
    {
        const face& front = layers.faces[key.front];
        appendSide
        (
            layers, front.faceEdge(key.edge), key.level, key.isSecond, points
        );
        return;
    }

    const face f
    (
        key.level == layers.nLayers
      ? outerFan(layers, key.front) : layers.faces[key.front]
    );

    const label n = f.size();
    for (label k = 0; k < n; ++k)
    {
        const label c = f[key.level ? k : (n - k) % n];
        points.append(layers.pointLabel(c, key.level));
    }
}


//- Puts edges on the second of two cyclic sides in the order of their images
static void orderCyclic
(
    const prismLayers& layers,
    const sidePair& pair,
    const UList<labelPair>& first,
    UList<labelPair>& second
)
{
    const auto edgeOf = [&](const labelPair& at)
    {
        return edge(layers.faces[at.first()].faceEdge(at.second()));
    };
    const label lone =
        orderAsImages(first, second, edgeOf, imagesOfColumns(layers, pair));
    if (lone >= 0)
    {
        FatalErrorInFunction
            << "The layers at " << layers(edgeOf(first[lone]).start(), 0)
            << " have no image on the second of two cyclic patches"
            << exit(FatalError);
    }
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
        const sidePatch& side = layers.border.sides[layers.border.edgeSides[i]];
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
    for (const sidePair& pair : pairsOf(layers.border.sides))
    {
        const auto patchOf = [&](const label side)
        {
            return names.find(layers.border.sides[side].name);
        };
        orderCyclic
        (
            layers, pair, edges[patchOf(pair.first)],
            edges[patchOf(pair.second)]
        );
    }

    return edges;
}


List<DynamicList<prismFaceKey>> boundaryFaces
(
    const prismLayers& layers,
    const UList<DynamicList<labelPair>>& open
)
{
    const label nWall = layers.patchNames.size();
    List<DynamicList<prismFaceKey>> patches(nWall + 1 + open.size());

    forAll(layers.patchIDs, facei)
    {
        patches[layers.patchIDs[facei]].append(prismFaceKey{facei, -1, 0});
    }
    forAll(layers.faces, facei)
    {
        patches[nWall].append(prismFaceKey{facei, -1, layers.nLayers});
    }
    const wordList names(sidePatchNames(layers.border));
    boolList isSecond(open.size(), false);
    for (const sidePair& pair : pairsOf(layers.border.sides))
    {
        isSecond[names.find(layers.border.sides[pair.second].name)] = true;
    }
    forAll(open, i)
    {
        for (const labelPair& e : open[i])
        {
            for (label level = 1; level <= layers.nLayers; ++level)
            {
                patches[nWall + 1 + i].append
                (
                    prismFaceKey{e.first(), e.second(), level, isSecond[i]}
                );
            }
        }
    }

    return patches;
}

} // End namespace Foam

// ************************************************************************* //
