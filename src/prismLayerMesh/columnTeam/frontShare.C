/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "frontShare.H"
#include "ListOps.H"
#include "surfacePart.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Of points that the share does not have
static const label notInShare = labelMax;


//- Set the ring of the points of faces that have a point of the ring below
static void addRing
(
    const layerFront& front,
    const label ring,
    labelList& rings
)
{
    DynamicList<label> added;

    for (const face& f : front.surface.faces)
    {
        const labelList points(front.pointsUnder(f));
        if (min(labelList(UIndirectList<label>(rings, points))) < ring)
        {
            for (const label p : points)
            {
                if (rings[p] == notInShare)
                {
                    added.append(p);
                }
            }
        }
    }
    UIndirectList<label>(rings, added) = ring;
}


//- The ring of each column: 0 of own columns, 1 and 2 around them. Columns on
//  one point are in one ring.
static labelList ringsOf
(
    const layerFront& front,
    const labelUList& owners,
    const label process
)
{
    labelList rings(owners.size(), notInShare);
    forAll(rings, p)
    {
        if (owners[p] == process)
        {
            rings[p] = 0;
        }
    }
    addRing(front, 1, rings);
    addRing(front, 2, rings);

    return labelList(UIndirectList<label>(rings, front.wallPoints));
}


template<class Type>
static List<Type> some(const UList<Type>& all, const labelUList& which)
{
    return List<Type>(UIndirectList<Type>(all, which));
}


namespace
{

//- Makes the front of a share
struct shareBuilder
{
    const layerFront& whole;
    const wallAddressing& around;
    const labelList& rings;
    frontShare& share;

    //- Labels in the share, -1 of what it does not have
    labelList newColumns{};
    labelList newFaces{};


    void choose()
    {
        const faceList& faces = whole.surface.faces;
        DynamicList<label> columns, chosen;
        newColumns.setSize(rings.size(), -1);
        newFaces.setSize(faces.size(), -1);

        forAll(rings, c)
        {
            if (rings[c] != notInShare)
            {
                newColumns[c] = columns.size();
                columns.append(c);
            }
        }
        forAll(faces, facei)
        {
            if (min(labelList(UIndirectList<label>(rings, faces[facei]))) < 2)
            {
                newFaces[facei] = chosen.size();
                chosen.append(facei);
            }
        }
        share.columns = std::move(columns);
        share.faces = std::move(chosen);
        share.nColumns = rings.size();
        share.nFaces = faces.size();
    }


    void addSurface()
    {
        const wallSurface& from = whole.surface;
        wallSurface& surface = share.front.surface;
        surface = partOf(from, share.columns, share.faces);

        DynamicList<edge> edges;
        DynamicList<label> sides;
        forAll(from.border.edges, i)
        {
            const edge& e = from.border.edges[i];
            if (min(rings[e.start()], rings[e.end()]) < 2)
            {
                edges.append
                (
                    edge(newColumns[e.start()], newColumns[e.end()])
                );
                sides.append(from.border.edgeSides[i]);
            }
        }
        surface.border.edges = std::move(edges);
        surface.border.edgeSides = std::move(sides);
    }


    void addEdges()
    {
        DynamicList<edge> edges;
        DynamicList<labelPair> edgeFaces;

        forAll(around.edges, i)
        {
            const edge& e = around.edges[i];
            labelPair two(-1, -1);
            for (const label facei : around.edgeFaces[i])
            {
                if (facei >= 0 && newFaces[facei] >= 0)
                {
                    (two.first() < 0 ? two.first() : two.second()) =
                        newFaces[facei];
                }
            }
            if (two.first() >= 0)
            {
                edges.append
                (
                    edge(newColumns[e.start()], newColumns[e.end()])
                );
                edgeFaces.append(two);
            }
        }
        share.front.addressing.edges = std::move(edges);
        share.front.addressing.edgeFaces = std::move(edgeFaces);
    }


    //- The faces around a column that the share has, and the neighbours beside
    //  them
    void addAround(const label c)
    {
        wallAddressing& addressing = share.front.addressing;
        const label from = share.columns[c];
        const labelList& faces = around.pointFaces[from];
        const labelList& points = around.pointPoints[from];
        DynamicList<label> ownFaces, ownPoints;

        forAll(points, i)
        {
            const bool hasFace = i < faces.size() && newFaces[faces[i]] >= 0;
            const bool endsFace =
                i == faces.size() && newColumns[points[i]] >= 0;
            if (hasFace)
            {
                ownFaces.append(newFaces[faces[i]]);
            }
            if (hasFace || endsFace)
            {
                ownPoints.append(newColumns[points[i]]);
            }
        }
        addressing.pointFaces[c] = labelList(std::move(ownFaces));
        addressing.pointPoints[c] = labelList(std::move(ownPoints));
    }


    void addAddressing()
    {
        wallAddressing& addressing = share.front.addressing;
        addressing.pointFaces.setSize(share.columns.size());
        addressing.pointPoints.setSize(share.columns.size());
        forAll(share.columns, c)
        {
            addAround(c);
        }
        if (around.pointSides.size())
        {
            addressing.pointSides =
                some(around.pointSides, share.columns);
        }
        addEdges();
    }


    void addVisibility(const wallVisibility& from)
    {
        wallVisibility& visibility = share.front.visibility;
        visibility.cornerNormals = some(from.cornerNormals, share.columns);
        visibility.meanNormals = some(from.meanNormals, share.columns);
        visibility.polygonNormals = some(from.polygonNormals, share.columns);
        visibility.cones = some(from.cones, share.columns);
        if (from.sideLines.size())
        {
            visibility.sideLines = some(from.sideLines, share.columns);
        }
    }


    void addWallPoints()
    {
        layerFront& front = share.front;
        front.wallPoints = some(whole.wallPoints, share.columns);
        inplaceRenumber(newColumns, front.wallPoints);
        if (whole.constraints.size())
        {
            front.constraints = some(whole.constraints, share.columns);
        }
        for (const label facei : share.faces)
        {
            front.nWallFaces += facei < whole.nWallFaces;
        }
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelList frontShare::wallPoints() const
{
    const label nExtra = front.extraColumnPoints().size();

    return SubList<label>(columns, columns.size() - nExtra);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

frontShare makeFrontShare
(
    const layerFront& whole,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const labelUList& owners,
    const label nProcesses,
    const label process
)
{
    const labelList rings(ringsOf(whole, owners, process));
    frontShare share;
    share.nWallPoints = owners.size();
    share.owners = pointOwners(owners);
    shareBuilder builder{whole, addressing, rings, share};
    builder.choose();
    builder.addSurface();
    builder.addAddressing();
    builder.addVisibility(visibility);
    builder.addWallPoints();

    share.isOwn.setSize(share.columns.size());
    forAll(share.columns, c)
    {
        share.isOwn[c] = rings[share.columns[c]] == 0;
    }
    share.setCopies(some(owners, share.wallPoints()), nProcesses, process);

    return share;
}

} // End namespace Foam

// ************************************************************************* //
