/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "frontShare.H"
#include "DynamicList.H"
#include "HashSet.H"
#include "labelRange.H"
#include "ListOps.H"
#include "Map.H"
#include "surfacePart.H"

#include <algorithm>

namespace Foam
{

//- A range that begins elsewhere has to be better by this share of the hard
//  points: the copies of columns at its further border take time, too
static const scalar leastGain = 0.02;


//- Where a range of some length has to begin to have a share of the hard
//  points. Beyond the end of the points the range goes on at their beginning.
static label startOfRange
(
    const labelUList& points,
    const UList<bool>& isHard,
    const label length,
    const scalar share
)
{
    const label n = points.size();
    label nHard = 0, inRange = 0;
    for (label i = 0; i < n; ++i)
    {
        nHard += isHard[points[i]];
        inRange += i < length && isHard[points[i]];
    }

    const scalar wanted = share*nHard;
    label best = 0;
    scalar least = mag(inRange - wanted) - leastGain*wanted;
    for (label start = 1; start < n; ++start)
    {
        inRange += isHard[points[(start + length - 1) % n]];
        inRange -= isHard[points[start - 1]];
        if (mag(inRange - wanted) < least)
        {
            least = mag(inRange - wanted);
            best = start;
        }
    }

    return best;
}


//- Divides points between processes
static void divide
(
    const labelUList& points,
    const UList<bool>& isHard,
    const labelRange& processes,
    labelList& processOfPoint
)
{
    if (processes.size() == 1)
    {
        for (const label p : points)
        {
            processOfPoint[p] = processes.start();
        }
        return;
    }

    const label nFirst = processes.size()/2;
    const scalar share = scalar(nFirst)/processes.size();
    const label n = points.size();

    // Rounded up: if there are points, the master has some
    const label length =
        (std::int64_t(n)*nFirst + processes.size() - 1)/processes.size();
    const label start = startOfRange(points, isHard, length, share);
    const label end = start + length;

    DynamicList<label> first(length), second(n - length);
    forAll(points, i)
    {
        const bool isIn =
            (i >= start && i < end) || (i + n >= start && i + n < end);
        (isIn ? first : second).append(points[i]);
    }
    divide
    (
        first, isHard, labelRange(processes.start(), nFirst), processOfPoint
    );
    divide
    (
        second, isHard,
        labelRange(processes.start() + nFirst, processes.size() - nFirst),
        processOfPoint
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

pointOwners::pointOwners(const labelUList& processOfPoint)
{
    DynamicList<label> starts, processes;
    forAll(processOfPoint, p)
    {
        if (processes.empty() || processes.last() != processOfPoint[p])
        {
            starts.append(p);
            processes.append(processOfPoint[p]);
        }
    }
    starts_ = std::move(starts);
    processes_ = std::move(processes);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label pointOwners::operator()(const label pointi) const
{
    return processes_
    [
        std::upper_bound(starts_.begin(), starts_.end(), pointi)
      - starts_.begin() - 1
    ];
}


labelList ownersByRange(const label nPoints, const label nProcesses)
{
    labelList owners(nPoints);
    forAll(owners, p)
    {
        owners[p] = std::int64_t(p)*nProcesses/nPoints;
    }

    return owners;
}


pointOwners balancedOwners(const UList<bool>& isHard, const label nProcesses)
{
    labelList processOfPoint(isHard.size(), 0);
    divide
    (
        identity(isHard.size()), isHard, labelRange(0, nProcesses),
        processOfPoint
    );

    return pointOwners(processOfPoint);
}


// * * * * * * * * * * * * * * *  Front Share  * * * * * * * * * * * * * * * //

//- Of points that the share does not have
static const label notInShare = labelMax;


//- Set the ring of the points of faces that have a point of the ring below
static void addRing(const layerFront& front, const label ring, labelList& rings)
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


labelList columnsInShare
(
    const layerFront& whole,
    const labelUList& owners,
    const label process
)
{
    const labelList rings(ringsOf(whole, owners, process));

    return subsetList
    (
        identity(rings.size()),
        [&](const label c) { return rings[c] != notInShare; }
    );
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
        share.columns.whole = std::move(columns);
        share.columns.nWhole = rings.size();
        share.faces.whole = std::move(chosen);
        share.faces.nWhole = faces.size();
    }


    void addSurface()
    {
        const wallSurface& from = whole.surface;
        wallSurface& surface = share.front.surface;
        surface = partOf(from, share.columns.whole, share.faces.whole);

        DynamicList<edge> edges;
        DynamicList<label> sides;
        forAll(from.border.edges, i)
        {
            const edge& e = from.border.edges[i];
            if (min(rings[e.start()], rings[e.end()]) < 2)
            {
                edges.append(edge(newColumns[e.start()], newColumns[e.end()]));
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
                edges.append(edge(newColumns[e.start()], newColumns[e.end()]));
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
        const label from = share.columns.whole[c];
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
        addressing.pointFaces.setSize(share.columns.whole.size());
        addressing.pointPoints.setSize(share.columns.whole.size());
        forAll(share.columns.whole, c)
        {
            addAround(c);
        }
        if (around.pointSides.size())
        {
            addressing.pointSides =
                some(around.pointSides, share.columns.whole);
        }
        addEdges();
    }


    void addVisibility(const wallVisibility& from)
    {
        wallVisibility& visibility = share.front.visibility;
        const labelList& columns = share.columns.whole;
        visibility.cornerNormals = some(from.cornerNormals, columns);
        visibility.meanNormals = some(from.meanNormals, columns);
        visibility.polygonNormals = some(from.polygonNormals, columns);
        visibility.cones = some(from.cones, columns);
        if (from.sideLines.size())
        {
            visibility.sideLines = some(from.sideLines, columns);
        }
    }


    void addWallPoints()
    {
        layerFront& front = share.front;
        front.wallPoints = some(whole.wallPoints, share.columns.whole);
        inplaceRenumber(newColumns, front.wallPoints);
        if (whole.constraints.size())
        {
            front.constraints = some(whole.constraints, share.columns.whole);
        }
        for (const label facei : share.faces.whole)
        {
            front.nWallFaces += facei < whole.nWallFaces;
        }
    }


    void setOwn()
    {
        const labelList& columns = share.columns.whole;
        boolList& isOwn = share.columns.isOwn;
        isOwn.setSize(columns.size());
        forAll(columns, c)
        {
            isOwn[c] = rings[columns[c]] == 0;
        }

        const label nPoints =
            columns.size() - share.front.extraColumnPoints().size();
        share.points.whole = SubList<label>(columns, nPoints);
        share.points.isOwn = SubList<bool>(isOwn, nPoints);

        const faceList& faces = share.front.surface.faces;
        share.faces.isOwn.setSize(faces.size());
        forAll(faces, facei)
        {
            share.faces.isOwn[facei] = isOwn[min(faces[facei])];
        }
    }
};

} // End anonymous namespace


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
    share.points.nWhole = owners.size();
    share.owners = pointOwners(owners);

    shareBuilder builder{whole, addressing, rings, share};
    builder.choose();
    builder.addSurface();
    builder.addAddressing();
    builder.addVisibility(visibility);
    builder.addWallPoints();
    builder.setOwn();

    share.setCopies(some(owners, share.points.whole), nProcesses, process);

    return share;
}


// * * * * * * * * * * * * * * *  Share Copies * * * * * * * * * * * * * * * //

//- By point of the wall in the share, the processes other than this one that
//  own a point with which it shares a face
static Map<labelHashSet> othersBeside
(
    const layerFront& front,
    const labelUList& owners,
    const label process
)
{
    Map<labelHashSet> others;
    for (const face& f : front.surface.faces)
    {
        const labelList points(front.pointsUnder(f));
        for (const label p : points)
        {
            if (owners[p] != process)
            {
                for (const label q : points)
                {
                    others(q).insert(owners[p]);
                }
            }
        }
    }

    return others;
}


//- The labels of lists that are below a bound
static labelListList below(const label bound, labelListList lists)
{
    for (labelList& labels : lists)
    {
        inplaceSubsetList(labels, [=](const label c) { return c < bound; });
    }

    return lists;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void frontShare::setCopies
(
    const labelUList& owners,
    const label nProcesses,
    const label process
)
{
    const Map<labelHashSet> beside(othersBeside(front, owners, process));
    Map<labelHashSet> near;

    for (const face& f : front.surface.faces)
    {
        const labelList points(front.pointsUnder(f));
        for (const label p : points)
        {
            if (beside.found(p))
            {
                for (const label q : points)
                {
                    near(q) |= beside[p];
                }
            }
        }
    }

    List<DynamicList<label>> toOthers(nProcesses);
    List<DynamicList<label>> fromOthers(nProcesses);
    forAll(front.wallPoints, c)
    {
        const label p = front.wallPoints[c];
        if (!columns.isOwn[c])
        {
            fromOthers[owners[p]].append(c);
        }
        else if (near.found(p))
        {
            for (const label other : near[p])
            {
                toOthers[other].append(c);
            }
        }
    }

    columns.sent.setSize(nProcesses);
    columns.received.setSize(nProcesses);
    forAll(columns.sent, p)
    {
        columns.sent[p] = std::move(toOthers[p]);
        columns.received[p] = std::move(fromOthers[p]);
    }

    // The label of a point is the label of its first column
    points.sent = below(points.whole.size(), columns.sent);
    points.received = below(points.whole.size(), columns.received);
}

} // End namespace Foam

// ************************************************************************* //
