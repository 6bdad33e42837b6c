/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/


#include "prismPolyMesh.H"
#include "DynamicList.H"
#include "ListOps.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- What is beyond the edges of the front faces
struct frontNeighbours
{
    //- First edge of each face
    labelList starts;

    //- The face beyond each edge, or -1
    labelList faces;

    //- Edges of one face only
    label nOpen;

    label operator()(const label facei, const label k) const
    {
        return faces[starts[facei] + k];
    }

    label nInternal() const
    {
        return (faces.size() - nOpen)/2;
    }
};


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

    frontNeighbours front;
    front.starts.setSize(faces.size() + 1);
    front.starts[0] = 0;

    forAll(faces, facei)
    {
        front.starts[facei + 1] = front.starts[facei] + faces[facei].size();
    }

    const label nEdges = front.starts.last();
    front.faces.setSize(nEdges, -1);
    front.nOpen = nEdges;

    labelList lists(layers.nColumns(), -1);
    labelList next(nEdges);
    labelList faceOf(nEdges);
    edgeList edges(nEdges);

    label edgei = 0;
    forAll(faces, facei)
    {
        for (label k = 0; k < faces[facei].size(); ++k, ++edgei)
        {
            const edge e(faces[facei][k], faces[facei].nextLabel(k));
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
            else if (front.faces[other] >= 0)
            {
                badEdge(layers, facei, e, "has more than two faces");
            }
            else if (edges[other].first() == e.first())
            {
                badEdge(layers, facei, e, "has two faces that are flipped");
            }
            else
            {
                front.faces[other] = facei;
                front.faces[edgei] = faceOf[other];
                front.nOpen -= 2;
            }
        }
    }

    return front;
}


//- Faces are added one after the other
class topologyBuilder
{
    const prismLayers& layers_;
    polyMeshTopology& mesh_;
    label nFaces_ = 0;


    label cellLabel(const label facei, const label i) const
    {
        return facei*layers_.nLayers + i - 1;
    }


public:

    topologyBuilder(const prismLayers& layers, polyMeshTopology& mesh)
    :
        layers_(layers),
        mesh_(mesh)
    {}


    //- Between layer i and layer i + 1, or the outer surface
    void addUpper(const label facei, const label i)
    {
        const face& columns = layers_.faces[facei];
        face& f = mesh_.faces[nFaces_];
        f.setSize(columns.size());

        forAll(columns, k)
        {
            f[k] = layers_.pointLabel(columns[k], i);
        }

        if (i < layers_.nLayers)
        {
            mesh_.neighbour[nFaces_] = cellLabel(facei, i + 1);
        }

        mesh_.owner[nFaces_++] = cellLabel(facei, i);
    }


    //- On the wall: seen from below
    void addWall(const label facei)
    {
        const face& columns = layers_.faces[facei];
        const label n = columns.size();
        face& f = mesh_.faces[nFaces_];
        f.setSize(n);

        forAll(columns, k)
        {
            f[k] = layers_.pointLabel(columns[k ? n - k : 0], 0);
        }

        mesh_.owner[nFaces_++] = cellLabel(facei, 1);
    }


    //- The side of layer i on edge k of a front face, beyond which is another
    //  front face or -1
    void addSide
    (
        const label facei,
        const label k,
        const label i,
        const label beyond
    )
    {
        const face& columns = layers_.faces[facei];
        const label c = columns[k];
        const label d = columns.nextLabel(k);

        const label start = layers_.pointLabel(c, i - 1);
        const label end = layers_.pointLabel(d, i - 1);

        // Columns on one point of the wall have a triangle between them
        face& f = mesh_.faces[nFaces_];
        f.setSize(start == end ? 3 : 4);
        f[0] = start;
        f[1] = end;
        f[f.size() - 2] = layers_.pointLabel(d, i);
        f[f.size() - 1] = layers_.pointLabel(c, i);

        if (beyond >= 0)
        {
            mesh_.neighbour[nFaces_] = cellLabel(beyond, i);
        }

        mesh_.owner[nFaces_++] = cellLabel(facei, i);
    }


    //- Faces from start on are a patch
    void addPatch(const label start)
    {
        mesh_.patchStarts.append(start);
        mesh_.patchSizes.append(nFaces_ - start);
    }

    label nFaces() const
    {
        return nFaces_;
    }
};


//- Upper-triangular order: of the faces of a cell to cells of higher label, the
//  one to the next layer is the first, those to the stacks of higher front
//  faces follow
static void addInternalFaces
(
    const prismLayers& layers,
    const frontNeighbours& front,
    topologyBuilder& builder
)
{
    // Face beyond and edge, of the higher faces beyond
    DynamicList<labelPair> sides(16);

    forAll(layers.faces, facei)
    {
        sides.clear();

        forAll(layers.faces[facei], k)
        {
            const label beyond = front(facei, k);

            if (beyond > facei)
            {
                sides.append(labelPair(beyond, k));
            }
        }

        std::sort(sides.begin(), sides.end());

        for (label i = 1; i <= layers.nLayers; ++i)
        {
            if (i < layers.nLayers)
            {
                builder.addUpper(facei, i);
            }

            for (const labelPair& side : sides)
            {
                builder.addSide(facei, side.second(), i, side.first());
            }
        }
    }
}


//- One patch for each of the wall's
static void addWallFaces(const prismLayers& layers, topologyBuilder& builder)
{
    labelListList patchFaces
    (
        invertOneToMany(layers.patchNames.size(), layers.patchIDs)
    );

    for (const labelList& faces : patchFaces)
    {
        const label start = builder.nFaces();

        for (const label facei : faces)
        {
            builder.addWall(facei);
        }

        builder.addPatch(start);
    }
}


static void addOuterFaces(const prismLayers& layers, topologyBuilder& builder)
{
    const label start = builder.nFaces();

    forAll(layers.faces, facei)
    {
        builder.addUpper(facei, layers.nLayers);
    }

    builder.addPatch(start);
}


static void addOpenSides
(
    const prismLayers& layers,
    const frontNeighbours& front,
    topologyBuilder& builder
)
{
    const label start = builder.nFaces();

    forAll(layers.faces, facei)
    {
        forAll(layers.faces[facei], k)
        {
            if (front(facei, k) < 0)
            {
                for (label i = 1; i <= layers.nLayers; ++i)
                {
                    builder.addSide(facei, k, i, -1);
                }
            }
        }
    }

    builder.addPatch(start);
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::polyMeshTopology Foam::makePrismTopology(const prismLayers& layers)
{
    const frontNeighbours front(makeFrontNeighbours(layers));
    const label n = layers.nLayers;
    const label nFront = layers.faces.size();
    const label nInternal = nFront*(n - 1) + front.nInternal()*n;
    const label nFaces =
        nInternal + nFront + layers.nWallFaces() + front.nOpen*n;

    polyMeshTopology mesh;
    mesh.faces.setSize(nFaces);
    mesh.owner.setSize(nFaces);
    mesh.neighbour.setSize(nInternal);

    topologyBuilder builder(layers, mesh);
    addInternalFaces(layers, front, builder);
    addWallFaces(layers, builder);
    addOuterFaces(layers, builder);

    if (front.nOpen)
    {
        addOpenSides(layers, front, builder);
    }

    return mesh;
}


// ************************************************************************* //
