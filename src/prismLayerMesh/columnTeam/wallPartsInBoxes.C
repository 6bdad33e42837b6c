/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallPartsInBoxes.H"
#include "frontPart.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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
        if
        (
            std::any_of
            (
                boxes.begin(), boxes.end(),
                [&](const boundBox& box) { return own.overlaps(box); }
            )
        )
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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
        counted[facei] = team.counts(front.surface.faces[facei]);
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

    label nOwn = 0;
    for (const partRequest& request : requests)
    {
        nOwn += request.process == team.rank();
    }
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
