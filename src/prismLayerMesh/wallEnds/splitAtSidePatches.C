/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "splitAtSidePatches.H"
#include "boundBox.H"
#include "checkInFront.H"
#include "orientOpenWall.H"
#include "removeUnused.H"
#include "sideParts.H"
#include "sideShape.H"
#include "wallSides.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

struct wallSplitter
{
    wallSurface surface;
    const wallSurfaceControls& controls;
    const layerControls& layers;

    const scalar tolerance =
        sideTolerance*boundBox(surface.points, false).mag();
    wallSides edges{};

    //- Side patch of each face, -1 of the wall
    labelList sideOfFace{};

    List<sidePatch> sides{};

    //- How many of them are parts of planes; planes without faces follow
    label nParts = 0;

    //- Side patches of each point of the surface
    List<DynamicList<label>> pointSides{};

    wallSurface wall{};


    //- The plane that is nearest to both ends of an edge, -1 if none is near
    label planeOf(const wallSide& edge) const
    {
        label nearest = -1;
        scalar least = tolerance;

        for (label s = nParts; s < sides.size(); ++s)
        {
            const scalar distance = max
            (
                mag(sides[s].distance(surface.points[edge.low])),
                mag(sides[s].distance(surface.points[edge.high]))
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
        bitSet on(pointSides.size());
        forAll(pointSides, p)
        {
            on.set(p, pointSides[p].found(s));
        }

        return on;
    }

    void addPointSide(const label p, const label s)
    {
        if (!pointSides[p].found(s))
        {
            pointSides[p].append(s);
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

    wallSurface split(wallReading& reading);
};


void wallSplitter::addBorder(const wallSide& edge, const label side)
{
    addPointSide(edge.low, side);
    addPointSide(edge.high, side);

    if (sideOfFace[edge.facei] < 0)
    {
        wall.border.edges.append(edge.along());
        wall.border.edgeSides.append(side);
    }
}


void wallSplitter::findBorders()
{
    DynamicList<point> lost;

    for (label e = 0; e < edges.nEdges(); ++e)
    {
        const SubList<wallSide> both(edges.on(e));
        const wallSide& first = both[0];
        const label side = sideOfFace[first.facei];

        if (both.size() == 1)
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
                   *(surface.points[first.low] + surface.points[first.high])
                );
            }
            continue;
        }

        const wallSide& second = both[1];
        const label other = sideOfFace[second.facei];

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
    bound << tolerance;
    refuseAt
    (
        lost,
        "The surface is open and its border is further than " + bound.str()
      + " m from all side planes"
    );

    addPointsOfSides();
}


void wallSplitter::addPointsOfSides()
{
    forAll(sideOfFace, facei)
    {
        for (const label p : surface.faces[facei])
        {
            if (sideOfFace[facei] >= 0)
            {
                addPointSide(p, sideOfFace[facei]);
            }
        }
    }
}


void wallSplitter::checkSides() const
{
    for (label s = nParts; s < sides.size(); ++s)
    {
        if (!wall.border.edgeSides.found(s))
        {
            FatalErrorInFunction
                << "No border of the wall is on the side plane "
                << sides[s].name << " at " << sides[s].origin
                << exit(FatalError);
        }

        checkInFront(surface, sides[s], pointsOn(s), tolerance);
    }

    for (const edge& e : wall.border.edges)
    {
        if (pointSides[e.start()].size() > 2)
        {
            FatalErrorInFunction
                << "More than two side patches meet at the point "
                << surface.points[e.start()] << " of the wall"
                << exit(FatalError);
        }
    }
}


void wallSplitter::putOnPlanes(wallReading& reading)
{
    forAll(pointSides, p)
    {
        const point x = surface.points[p];

        if (pointSides[p].size())
        {
            surface.points[p] = onAll(sides, pointSides[p], x);

            const scalar distance = mag(surface.points[p] - x);
            reading.pointsPutOnSides += distance > 0;
            reading.largestMove = max(reading.largestMove, distance);
        }
    }
}


void wallSplitter::takeWall()
{
    List<DynamicList<face>> facesOfSides(sides.size());
    DynamicList<face> faces;
    DynamicList<label> patchIDs;

    forAll(surface.faces, facei)
    {
        const label s = sideOfFace[facei];

        if (s < 0)
        {
            faces.append(surface.faces[facei]);
            patchIDs.append(surface.patchIDs[facei]);
        }
        else
        {
            facesOfSides[s].append(surface.faces[facei]);
        }
    }

    forAll(sides, s)
    {
        sides[s].faces.transfer(facesOfSides[s]);
        sides[s].points = surface.points;
        removeUnusedPoints(sides[s].faces, sides[s].points);

        if (sides[s].isCurved())
        {
            sides[s].shape = std::make_shared<const sideShape>
            (
                sides[s].points, sides[s].faces
            );
        }
    }

    wall.faces.transfer(faces);
    wall.patchIDs.transfer(patchIDs);
    wall.points = surface.points;
    const labelList numbers(removeUnusedPoints(wall.faces, wall.points));

    for (edge& e : wall.border.edges)
    {
        e = edge(numbers[e.start()], numbers[e.end()]);
    }

    wall.patchNames = surface.patchNames;
    wall.border.sides = sides;
    mergePatches(wall);
}


wallSurface wallSplitter::split(wallReading& reading)
{
    reading.flippedFaces += orientOpenWall
    (
        surface, controls.sidePlanes, controls.fluidOutside
    );

    const sideParts parts(findSideParts(surface, layers, tolerance));
    edges = makeWallSides(surface.faces, surface.points.size());
    pointSides.setSize(surface.points.size());
    sideOfFace = parts.sideOfFace;
    sides = parts.sides;
    nParts = sides.size();
    sides.append(controls.sidePlanes);

    findBorders();
    checkSides();
    putOnPlanes(reading);
    takeWall();

    return std::move(wall);
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

wallSurface splitAtSidePatches
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
      ? wallSplitter{surface, controls, layers}.split(reading) : surface
    );
    wall.patchTypes = patchTypes(wall.patchNames, layers);
    checkSides(wall.border.sides, wall.patchNames);

    return wall;
}

} // End namespace Foam

// ************************************************************************* //
