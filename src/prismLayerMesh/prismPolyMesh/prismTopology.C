/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/


#include "prismPolyMesh.H"
#include "CompactListList.H"
#include "ListOps.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

namespace
{

//- What is beyond the edges of the front faces
struct frontNeighbours
{
    //- The face beyond each edge of each face, or -1
    CompactListList<label> beyond;

    //- Number of edges of one face only
    label nOpen;

    label operator()(const label facei, const label k) const
    {
        return beyond(facei, k);
    }
};

} // End anonymous namespace


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


//- Edges meet in short lists, one for the smaller column of each
static frontNeighbours makeFrontNeighbours(const prismLayers& layers)
{
    const faceList& faces = layers.faces;
    labelList sizes(faces.size());
    forAll(faces, facei)
    {
        sizes[facei] = faces[facei].size();
    }

    frontNeighbours front{CompactListList<label>(sizes, -1), sum(sizes)};
    labelList& beyond = front.beyond.m();
    labelList lists(layers.nColumns(), -1);
    labelList next(beyond.size());
    labelList faceOf(beyond.size());
    edgeList edges(beyond.size());

    label edgei = 0;
    forAll(faces, facei)
    {
        for (const edge& e : faces[facei].edges())
        {
            edges[edgei] = e;
            faceOf[edgei] = facei;

            label& list = lists[min(e.first(), e.second())];
            label other = list;
            while (other >= 0 && edge::compare(edges[other], e) == 0)
            {
                other = next[other];
            }

            if (other < 0)
            {
                next[edgei] = list;
                list = edgei;
            }
            else if (beyond[other] >= 0)
            {
                badEdge(layers, facei, e, "has more than two faces");
            }
            else if (edges[other].first() == e.first())
            {
                badEdge(layers, facei, e, "has two faces that are flipped");
            }
            else
            {
                beyond[other] = facei;
                beyond[edgei] = faceOf[other];
                front.nOpen -= 2;
            }

            ++edgei;
        }
    }

    return front;
}


static label cellLabel
(
    const prismLayers& layers,
    const label facei,
    const label i
)
{
    return facei*layers.nLayers + i - 1;
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
    const frontNeighbours& front,
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
            if (front(facei, k) > facei)
            {
                sides.append(labelPair(front(facei, k), k));
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
    const frontNeighbours& front,
    polyMeshTopology& mesh
)
{
    mesh.startPatch();

    forAll(layers.faces, facei)
    {
        forAll(layers.faces[facei], k)
        {
            for (label i = 1; front(facei, k) < 0 && i <= layers.nLayers; ++i)
            {
                mesh.append
                (
                    sideFace(layers, facei, k, i), cellLabel(layers, facei, i)
                );
            }
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::polyMeshTopology::reserve
(
    const label nFaces,
    const label nInternal
)
{
    faces.reserve(nFaces);
    owner.reserve(nFaces);
    neighbour.reserve(nInternal);
}


void Foam::polyMeshTopology::append
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


void Foam::polyMeshTopology::startPatch()
{
    patchStarts.append(faces.size());
    patchSizes.append(0);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::polyMeshTopology Foam::makePrismTopology(const prismLayers& layers)
{
    const frontNeighbours front(makeFrontNeighbours(layers));
    const label n = layers.nLayers;
    const label nFront = layers.faces.size();
    const label nEdges = (front.beyond.m().size() - front.nOpen)/2;
    const label nInternal = nFront*(n - 1) + nEdges*n;

    polyMeshTopology mesh;
    mesh.reserve
    (
        nInternal + nFront + layers.nWallFaces() + front.nOpen*n, nInternal
    );
    addInternalFaces(layers, front, mesh);
    addWallFaces(layers, mesh);
    addOuterFaces(layers, mesh);

    if (front.nOpen)
    {
        addOpenSides(layers, front, mesh);
    }

    return mesh;
}


// ************************************************************************* //
