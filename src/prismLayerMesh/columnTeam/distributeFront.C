/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "distributeFront.H"
#include "EdgeMap.H"
#include "frontPart.H"
#include "HashSet.H"
#include "ListOps.H"
#include "ranges.H"
#include "sideShape.H"

namespace Foam
{

namespace
{

//- What all processes know of a front
struct frontOutline
{
    label nWallPoints = 0;
    label nColumns = 0;
    label nFaces = 0;
    bool isBare = true;
    pointOwners owners;

    //- Names of the patches, and sides: a wall without points and faces
    wallSurface like;
};

} // End anonymous namespace


//- Calls wire(item) for a side patch, whose shape is made again
template<class Wire, class Side>
static void visit(Wire& wire, Side& side, bool& isCurved)
{
    wire(side.origin, side.normal, side.name, side.type);
    wire(side.points, side.faces, isCurved);
}


static void addOutline
(
    message& m,
    const layerFront& whole,
    const pointOwners& owners
)
{
    const wallSurface& surface = whole.surface;
    m
    (
        label(whole.wallPoints.size() - whole.extraColumnPoints().size()),
        whole.wallPoints.size(), surface.faces.size(), whole.isBare(),
        owners.starts(), owners.processes(),
        surface.patchNames, surface.patchTypes, surface.border.sides.size()
    );
    for (const sidePatch& side : surface.border.sides)
    {
        bool isCurved = side.isCurved();
        visit(m, side, isCurved);
    }
}


static frontOutline takeOutline(messageReader& reader)
{
    frontOutline outline;
    labelList starts, processes;
    label nSides;
    reader
    (
        outline.nWallPoints, outline.nColumns, outline.nFaces, outline.isBare,
        starts, processes,
        outline.like.patchNames, outline.like.patchTypes, nSides
    );
    outline.owners = pointOwners(starts, processes);
    outline.like.border.sides.setSize(nSides);
    for (sidePatch& side : outline.like.border.sides)
    {
        bool isCurved;
        visit(reader, side, isCurved);
        if (isCurved)
        {
            side.shape.reset(new sideShape(side.points, side.faces));
        }
    }

    return outline;
}


//- By process, the faces around its points
static List<DynamicList<label>> facesByProcess
(
    const layerFront& whole,
    const pointOwners& owners,
    const label nProcesses
)
{
    List<DynamicList<label>> faces(nProcesses);
    forAll(whole.surface.faces, facei)
    {
        for (const label c : whole.surface.faces[facei])
        {
            DynamicList<label>& ofOwner = faces[owners(whole.wallPoints[c])];
            if (ofOwner.empty() || ofOwner.last() != facei)
            {
                ofOwner.append(facei);
            }
        }
    }

    return faces;
}


//- From the master, for each process: the outline, and the faces around its
//  points
static List<message> frontMessages
(
    const layerFront& whole,
    const pointOwners& owners,
    const label nProcesses
)
{
    const List<DynamicList<label>> faces
    (
        facesByProcess(whole, owners, nProcesses)
    );
    const labelList columnLabels(identity(whole.wallPoints.size()));
    const labelList faceLabels(identity(whole.surface.faces.size()));

    List<message> messages(nProcesses);
    forAll(messages, p)
    {
        addOutline(messages[p], whole, owners);
        frontCollector::addFaces
        (
            messages[p], whole, columnLabels, faceLabels, faces[p]
        );
    }

    return messages;
}


namespace
{

//- A process that collects its region of a front: the faces around its own
//  points, and around the rings of points around them
struct regionCollector
{
    const processTeam& processes;
    const frontOutline& outline;
    frontCollector collector{};

    //- Points of the whole wall that were asked for
    labelHashSet asked{};


    //- By process, the points without all of their faces
    List<message> questions()
    {
        List<DynamicList<label>> points(processes.size());
        for (const label p : collector.wallPoints())
        {
            const label owner = outline.owners(p);
            if (owner != processes.rank() && asked.insert(p))
            {
                points[owner].append(p);
            }
        }

        List<message> messages(processes.size());
        forAll(messages, p)
        {
            messages[p](points[p]);
        }

        return messages;
    }


    //- The faces around own points that others ask for
    static List<message> answers
    (
        const frontPart& part,
        const List<message>& questions
    )
    {
        List<message> messages(questions.size());
        forAll(messages, p)
        {
            messageReader reader(questions[p]);
            const labelHashSet points(reader.list<label>());
            DynamicList<label> faces;
            forAll(part.faces, facei)
            {
                for (const label c : part.front.surface.faces[facei])
                {
                    if (points.found(part.columns[part.front.wallPoints[c]]))
                    {
                        faces.append(facei);
                        break;
                    }
                }
            }
            frontCollector::addFaces
            (
                messages[p], part.front, part.columns, part.faces, faces
            );
        }

        return messages;
    }


    frontPart collect(messageReader& fromMaster)
    {
        collector.take(fromMaster);
        const frontPart ownFaces(collector.part(outline.like));

        for (label ring = 1; ring <= 2; ++ring)
        {
            const List<message> received
            (
                processes.exchange
                (
                    answers(ownFaces, processes.exchange(questions()))
                )
            );
            for (const message& m : received)
            {
                messageReader reader(m);
                collector.take(reader);
            }
        }

        return collector.part(outline.like);
    }
};

} // End anonymous namespace


//- Gives the columns of a region the normals that they must be in front of
//  beside the corners of their faces, as they are on the master. Collective
static void distributePlanes
(
    const layerFront& whole,
    const processTeam& processes,
    const labelUList& columns,
    wallVisibility& visibility
)
{
    List<message> questions(processes.size());
    forAll(questions, p)
    {
        questions[p](p == 0 ? columns : labelUList::null());
    }
    questions = processes.exchange(questions);

    List<message> answers(processes.size());
    forAll(answers, p)
    {
        messageReader reader(questions[p]);
        for (const label c : reader.list<label>())
        {
            answers[p](whole.visibility.polygonNormals[c]);
        }
    }
    answers = processes.exchange(answers);

    messageReader reader(answers[0]);
    forAll(columns, c)
    {
        visibility.polygonNormals[c] = reader.list<vector>();
        if (visibility.cornerNormals[c].size())
        {
            visibility.setCone(c);
        }
    }
}


//- The connectivity of a region. Points at its rim are on no side. On a wall
//  that ends all regions have the sides of points, as the wall has.
static wallAddressing addressingOf(const wallSurface& region)
{
    wallAddressing addressing(makeWallAddressing(region));
    if (region.border.sides.size())
    {
        addressing.pointSides.setSize(region.points.size(), labelPair(-1, -1));
    }
    for (labelPair& sides : addressing.pointSides)
    {
        if (min(sides.first(), sides.second()) < 0)
        {
            sides = labelPair(-1, -1);
        }
    }

    return addressing;
}


//- The share in a region, with labels of the whole front
static frontShare shareOfRegion
(
    const frontPart& region,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const frontOutline& outline,
    const processTeam& processes
)
{
    const label n = processes.size();
    DynamicList<label> owners(region.columns.size());
    forAll(region.columns, c)
    {
        if (region.front.wallPoints[c] == c)
        {
            owners.append(outline.owners(region.columns[c]));
        }
    }

    frontShare share
    (
        makeFrontShare
        (
            region.front, addressing, visibility, owners, n, processes.rank()
        )
    );
    inplaceRenumber(region.columns, share.columns.whole);
    inplaceRenumber(region.columns, share.points.whole);
    inplaceRenumber(region.faces, share.faces.whole);
    share.columns.nWhole = outline.nColumns;
    share.points.nWhole = outline.nWallPoints;
    share.faces.nWhole = outline.nFaces;
    share.owners = outline.owners;
    layerFront& front = share.front;
    front.setConstraints(front.addressing, front.visibility.sideLines);

    return share;
}


//- The processes of points. Columns near edges take more time than others.
static pointOwners ownersOf(const UList<pointKind>& kinds, const label n)
{
    boolList isOnEdge(kinds.size());
    forAll(kinds, p)
    {
        isOnEdge[p] = kinds[p] != pointKind::flat;
    }

    return balancedOwners(isOnEdge, n);
}


//- Puts the border of a front in the order of the border of the wall. Edges
//  between columns on one point follow, in the order of the points.
static void orderBorder
(
    const wallBorder& ofWall,
    const labelUList& wallPoints,
    wallBorder& border
)
{
    EdgeMap<label> places;
    forAll(ofWall.edges, i)
    {
        places.insert(ofWall.edges[i], i);
    }

    labelList keys(border.edges.size());
    forAll(keys, i)
    {
        const label p = wallPoints[border.edges[i].start()];
        const label q = wallPoints[border.edges[i].end()];
        keys[i] = p == q ? places.size() + p : places[edge(p, q)];
    }
    const labelList order(sortedOrder(keys));
    border.edges = UIndirectList<edge>(border.edges, order)();
    border.edgeSides = UIndirectList<label>(border.edgeSides, order)();
}


frontShare distributeFront
(
    const layerFront& whole,
    const pointOwners& owners,
    const processTeam& processes
)
{
    const label n = processes.size();
    const List<message> received
    (
        processes.exchange
        (
            processes.isMaster()
          ? frontMessages(whole, owners, n) : List<message>(n)
        )
    );
    messageReader reader(received[0]);
    const frontOutline outline(takeOutline(reader));
    const frontPart region
    (
        regionCollector{processes, outline}.collect(reader)
    );

    const wallSurface& surface = region.front.surface;
    const wallAddressing addressing(addressingOf(surface));
    wallVisibility visibility(makeWallVisibility(surface, addressing));
    if (!outline.isBare)
    {
        distributePlanes(whole, processes, region.columns, visibility);
    }

    return shareOfRegion(region, addressing, visibility, outline, processes);
}


frontShare shareOf
(
    layerFront&& whole,
    const UList<pointKind>& kinds,
    const processTeam& processes
)
{
    layerFront front(std::move(whole));
    if (processes.size() == 1)
    {
        frontShare share;
        share.front = std::move(front);

        return share;
    }

    return distributeFront(front, ownersOf(kinds, processes.size()), processes);
}


layerFront gatherFront
(
    const frontShare& share,
    const wallSurface& wall,
    const processTeam& processes
)
{
    List<message> sent(processes.size());
    frontCollector::addFaces
    (
        sent[0], share.front, share.columns.whole, share.faces.whole,
        findIndices(share.faces.isOwn, true)
    );
    const List<message> received(processes.exchange(sent));
    if (!processes.isMaster())
    {
        return layerFront();
    }

    frontCollector collector;
    for (const message& m : received)
    {
        messageReader reader(m);
        collector.take(reader);
    }
    layerFront front(collector.part(wall).front);
    orderBorder(wall.border, front.wallPoints, front.surface.border);

    return front;
}


// * * * * * * * * * * * * *  Wall Parts In Boxes  * * * * * * * * * * * * * //

//- Counted faces of a wall that overlap one of some boxes
static labelList facesInBoxes
(
    const wallSurface& wall,
    const UList<bool>& counted,
    const UList<boundBox>& boxes
)
{
    DynamicList<label> inside;
    forAll(wall.faces, facei)
    {
        if (!counted[facei])
        {
            continue;
        }
        const boundBox own(wall.points, wall.faces[facei], false);
        if (anyOf(boxes, [&](const boundBox& b) { return own.overlaps(b); }))
        {
            inside.append(facei);
        }
    }

    return labelList(std::move(inside));
}


//- A wall as a front with a column on each point
static layerFront frontOnWall(wallSurface&& wall)
{
    layerFront front;
    front.surface = std::move(wall);
    front.wallPoints = identity(front.surface.points.size());
    front.nWallFaces = front.surface.faces.size();

    return front;
}


wallSurface wallOfFront(const layerFront& front)
{
    const label nPoints =
        front.wallPoints.size() - front.extraColumnPoints().size();
    wallSurface wall;
    wall.points = SubList<point>(front.surface.points, nPoints);
    wall.faces = SubList<face>(front.surface.faces, front.nWallFaces);
    for (face& f : wall.faces)
    {
        inplaceRenumber(front.wallPoints, f);
    }
    wall.patchIDs = SubList<label>(front.surface.patchIDs, front.nWallFaces);
    wall.patchNames = front.surface.patchNames;
    wall.patchTypes = front.surface.patchTypes;
    wall.border.sides = front.surface.border.sides;

    return wall;
}


boolList countedWallFaces(const layerFront& front, const columnTeam& team)
{
    boolList counted(front.nWallFaces);
    forAll(counted, facei)
    {
        counted[facei] = team.countsFace(facei);
    }

    return counted;
}


List<surfacePart> wallPartsInBoxes
(
    const layerFront& front,
    const columnTeam& team,
    const UList<partRequest>& requests
)
{
    const layerFront onWall(frontOnWall(wallOfFront(front)));
    const wallSurface& wall = onWall.surface;
    const boolList counted(countedWallFaces(front, team));
    labelList points(wall.points.size()), faces(wall.faces.size());
    forAll(points, p)
    {
        points[p] = team.wholeColumn(p);
    }
    forAll(faces, facei)
    {
        faces[facei] = team.wholeFace(facei);
    }

    List<message> sent(team.size());
    for (const partRequest& request : requests)
    {
        frontCollector::addFaces
        (
            sent[request.process], onWall, points, faces,
            facesInBoxes(wall, counted, request.boxes)
        );
    }

    const label nOwn = countOf
    (
        requests,
        [&](const partRequest& r) { return r.process == team.rank(); }
    );
    List<frontCollector> collectors(nOwn);
    for (const message& m : team.exchange(sent))
    {
        messageReader reader(m);
        for (frontCollector& collector : collectors)
        {
            collector.take(reader);
        }
    }

    List<surfacePart> parts(nOwn);
    forAll(parts, i)
    {
        frontPart part(collectors[i].part(wall));
        parts[i].points = std::move(part.columns);
        parts[i].faces = std::move(part.faces);
        parts[i].surface = std::move(part.front.surface);
        collectors[i] = frontCollector();
    }

    return parts;
}


surfacePart wallPartInBoxes
(
    const layerFront& front,
    const columnTeam& team,
    const UList<boundBox>& boxes
)
{
    const labelList nBoxes(team.gather(labelList(1, boxes.size())));
    const List<boundBox> all(team.gather(boxes));

    List<partRequest> requests(team.size());
    label next = 0;
    forAll(requests, p)
    {
        requests[p].process = p;
        requests[p].boxes = SubList<boundBox>(all, nBoxes[p], next);
        next += nBoxes[p];
    }

    return std::move(wallPartsInBoxes(front, team, requests)[0]);
}

} // End namespace Foam

// ************************************************************************* //
