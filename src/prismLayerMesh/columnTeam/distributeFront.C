/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "distributeFront.H"
#include "frontPart.H"
#include "wallMessages.H"
#include "HashSet.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


static void addOutline
(
    message& m,
    const layerFront& whole,
    const pointOwners& owners
)
{
    wallSurface like;
    like.patchNames = whole.surface.patchNames;
    like.patchTypes = whole.surface.patchTypes;
    like.border.sides = whole.surface.border.sides;

    m.addValue
    (
        label(whole.wallPoints.size() - whole.extraColumnPoints().size())
    );
    m.addValue(whole.wallPoints.size());
    m.addValue(whole.surface.faces.size());
    m.addValue(whole.isBare());
    m.addList(owners.starts());
    m.addList(owners.processes());
    addWall(m, like);
}


static frontOutline takeOutline(messageReader& reader)
{
    frontOutline outline;
    outline.nWallPoints = reader.value<label>();
    outline.nColumns = reader.value<label>();
    outline.nFaces = reader.value<label>();
    outline.isBare = reader.value<bool>();
    const labelList starts(reader.list<label>());
    outline.owners = pointOwners(starts, reader.list<label>());
    outline.like = takeWall(reader);

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
            messages[p].addList(points[p]);
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
        questions[p].addList(p == 0 ? columns : labelUList::null());
    }
    questions = processes.exchange(questions);

    List<message> answers(processes.size());
    forAll(answers, p)
    {
        messageReader reader(questions[p]);
        for (const label c : reader.list<label>())
        {
            answers[p].addList(whole.visibility.polygonNormals[c]);
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
        addressing.pointSides.setSize
        (
            region.points.size(), labelPair(-1, -1)
        );
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
static std::shared_ptr<frontShare> shareOfRegion
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

    auto share = std::make_shared<frontShare>
    (
        makeFrontShare
        (
            region.front, addressing, visibility, owners, n, processes.rank()
        )
    );
    inplaceRenumber(region.columns, share->columns);
    inplaceRenumber(region.faces, share->faces);
    share->nWallPoints = outline.nWallPoints;
    share->owners = outline.owners;
    share->nColumns = outline.nColumns;
    share->nFaces = outline.nFaces;
    layerFront& front = share->front;
    front.setConstraints(front.addressing, front.visibility.sideLines);

    return share;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

std::shared_ptr<const frontShare> distributeFront
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

} // End namespace Foam

// ************************************************************************* //
