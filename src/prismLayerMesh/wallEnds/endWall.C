/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "endWall.H"
#include "boundBox.H"
#include "checkInFront.H"
#include "sideParts.H"
#include "sideShape.H"
#include "wallSides.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

class wallEnder
{
    wallSurface surface_;
    const wallSurfaceControls& controls_;
    const layerControls& layers_;
    const scalar tolerance_;
    wallSides edges_;

    //- Side patch of each face, -1 of the wall
    labelList sideOfFace_;

    List<sidePatch> sides_;

    //- How many of them are parts of planes; planes without faces follow
    label nParts_ = 0;

    //- Side patches of each point of the surface
    List<DynamicList<label>> pointSides_;

    wallSurface wall_;


    //- The plane that is nearest to both ends of an edge, -1 if none is near
    label planeOf(const wallSide& edge) const
    {
        label nearest = -1;
        scalar least = tolerance_;

        for (label s = nParts_; s < sides_.size(); ++s)
        {
            const scalar distance = max
            (
                mag(sides_[s].distance(surface_.points[edge.low])),
                mag(sides_[s].distance(surface_.points[edge.high]))
            );

            if (distance <= least)
            {
                least = distance;
                nearest = s;
            }
        }

        return nearest;
    }

    bitSet pointsOn(const label s) const
    {
        bitSet on(pointSides_.size());
        forAll(pointSides_, p)
        {
            on.set(p, pointSides_[p].found(s));
        }

        return on;
    }

    void addPointSide(const label p, const label s)
    {
        if (!pointSides_[p].found(s))
        {
            pointSides_[p].append(s);
        }
    }

    //- An edge of a face is on a side patch: a border if the face is the wall's
    void addBorder(const wallSide& edge, const label side);

    //- Set borders of the wall, and the side patches of points
    void findBorders();

    //- The points of faces on side patches are on these patches
    void addPointsOfSides();

    void checkSides() const;

    void putOnPlanes(wallReading& reading);

    void takeWall();

public:

    wallEnder
    (
        const wallSurface& surface,
        const wallSurfaceControls& controls,
        const layerControls& layers
    )
    :
        surface_(surface),
        controls_(controls),
        layers_(layers),
        tolerance_(sideTolerance*boundBox(surface.points, false).mag())
    {}

    wallSurface end(wallReading& reading);
};


void wallEnder::addBorder(const wallSide& edge, const label side)
{
    addPointSide(edge.low, side);
    addPointSide(edge.high, side);

    if (sideOfFace_[edge.facei] < 0)
    {
        wall_.border.edges.append
        (
            edge.up
          ? Foam::edge(edge.low, edge.high) : Foam::edge(edge.high, edge.low)
        );
        wall_.border.edgeSides.append(side);
    }
}


void wallEnder::findBorders()
{
    DynamicList<point> lost;

    for (label e = 0; e < edges_.nEdges(); ++e)
    {
        const label start = edges_.edgeStarts[e];
        const wallSide& first = edges_.sides[start];
        const label side = sideOfFace_[first.facei];

        if (edges_.edgeStarts[e + 1] - start == 1)
        {
            const label plane = planeOf(first);

            if (plane >= 0)
            {
                addBorder(first, plane);
            }
            else
            {
                lost.append
                (
                    0.5
                   *(surface_.points[first.low] + surface_.points[first.high])
                );
            }
            continue;
        }

        const wallSide& second = edges_.sides[start + 1];
        const label other = sideOfFace_[second.facei];

        if (side < 0 && other >= 0)
        {
            addBorder(first, other);
        }
        else if (side >= 0 && other < 0)
        {
            addBorder(second, side);
        }
    }

    OStringStream bound;
    bound << tolerance_;
    refuseAt
    (
        lost,
        "The surface is open and its border is further than " + bound.str()
      + " m from all side planes"
    );

    addPointsOfSides();
}


void wallEnder::addPointsOfSides()
{
    forAll(sideOfFace_, facei)
    {
        for (const label p : surface_.faces[facei])
        {
            if (sideOfFace_[facei] >= 0)
            {
                addPointSide(p, sideOfFace_[facei]);
            }
        }
    }
}


void wallEnder::checkSides() const
{
    for (label s = nParts_; s < sides_.size(); ++s)
    {
        if (!wall_.border.edgeSides.found(s))
        {
            FatalErrorInFunction
                << "No border of the wall is on the side plane "
                << sides_[s].name << " at " << sides_[s].origin
                << exit(FatalError);
        }

        checkInFront(surface_, sides_[s], pointsOn(s), tolerance_);
    }

    for (const edge& e : wall_.border.edges)
    {
        if (pointSides_[e.start()].size() > 2)
        {
            FatalErrorInFunction
                << "More than two side patches meet at the point "
                << surface_.points[e.start()] << " of the wall"
                << exit(FatalError);
        }
    }
}


void wallEnder::putOnPlanes(wallReading& reading)
{
    forAll(pointSides_, p)
    {
        const point x = surface_.points[p];

        if (pointSides_[p].size())
        {
            surface_.points[p] = onAll(sides_, pointSides_[p], x);

            const scalar distance = mag(surface_.points[p] - x);
            reading.pointsPutOnSides += distance > 0;
            reading.largestMove = max(reading.largestMove, distance);
        }
    }
}


void wallEnder::takeWall()
{
    List<DynamicList<face>> facesOfSides(sides_.size());
    DynamicList<face> faces;
    DynamicList<label> patchIDs;

    forAll(surface_.faces, facei)
    {
        const label s = sideOfFace_[facei];

        if (s < 0)
        {
            faces.append(surface_.faces[facei]);
            patchIDs.append(surface_.patchIDs[facei]);
        }
        else
        {
            facesOfSides[s].append(surface_.faces[facei]);
        }
    }

    forAll(sides_, s)
    {
        sides_[s].faces.transfer(facesOfSides[s]);
        sides_[s].points = surface_.points;
        removeUnusedPoints(sides_[s].faces, sides_[s].points);

        if (sides_[s].isCurved())
        {
            sides_[s].shape = std::make_shared<const sideShape>
            (
                sides_[s].points, sides_[s].faces
            );
        }
    }

    wall_.faces.transfer(faces);
    wall_.patchIDs.transfer(patchIDs);
    wall_.points = surface_.points;
    const labelList numbers(removeUnusedPoints(wall_.faces, wall_.points));

    for (edge& e : wall_.border.edges)
    {
        e = edge(numbers[e.start()], numbers[e.end()]);
    }

    wall_.patchNames = surface_.patchNames;
    wall_.border.sides = sides_;
    mergePatches(wall_);
}


wallSurface wallEnder::end(wallReading& reading)
{
    reading.flippedFaces += orientOpenWall
    (
        surface_, controls_.sidePlanes, controls_.fluidOutside
    );

    const sideParts parts(findSideParts(surface_, layers_, tolerance_));
    edges_ = makeWallSides(surface_.faces, surface_.points.size());
    pointSides_.setSize(surface_.points.size());
    sideOfFace_ = parts.sideOfFace;
    sides_ = parts.sides;
    nParts_ = sides_.size();
    sides_.append(controls_.sidePlanes);

    findBorders();
    checkSides();
    putOnPlanes(reading);
    takeWall();

    return std::move(wall_);
}

} // End anonymous namespace


static wordList patchTypes(const wordList& names, const layerControls& layers)
{
    wordList types(names.size(), word("wall"));

    forAll(names, patchi)
    {
        const patchLayers* entry = layers.entryOf(names[patchi]);

        if (entry && entry->type.size())
        {
            types[patchi] = entry->type;
        }
    }

    return types;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

wallSurface endWall
(
    const wallSurface& surface,
    const wallSurfaceControls& controls,
    const layerControls& layers,
    wallReading& reading
)
{
    bool hasSides = controls.sidePlanes.size();

    for (const patchLayers& entry : layers.patches)
    {
        hasSides = hasSides || entry.isSide;

        const bool matches = std::any_of
        (
            surface.patchNames.begin(), surface.patchNames.end(),
            [&](const word& name) { return entry.patches.match(name); }
        );

        if (entry.isSide && !matches)
        {
            FatalErrorInFunction
                << "The entry " << entry.patches << " of layers.patches"
                << " matches no patch of the surface" << nl
                << "Its patches: " << flatOutput(surface.patchNames)
                << exit(FatalError);
        }
    }

    wallSurface wall
    (
        hasSides
      ? wallEnder(surface, controls, layers).end(reading) : surface
    );
    wall.patchTypes = patchTypes(wall.patchNames, layers);
    checkSides(wall.border.sides, wall.patchNames);

    return wall;
}

} // End namespace Foam

// ************************************************************************* //
