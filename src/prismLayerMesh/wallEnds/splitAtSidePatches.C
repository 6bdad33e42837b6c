/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "splitAtSidePatches.H"
#include "boundBox.H"
#include "checkInFront.H"
#include "orientOpenWall.H"
#include "ranges.H"
#include "surfacePart.H"
#include "sideBorders.H"
#include "sideParts.H"
#include "sideShape.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A curved side patch has the shape of its faces
static void setShape(sidePatch& side)
{
    if (side.isCurved())
    {
        side.shape = std::make_shared<const sideShape>
        (
            side.points, side.faces
        );
    }
}


namespace
{

struct wallSplitter
{
    wallSurface surface;
    const wallSurfaceControls& controls;
    const layerControls& layers;

    const scalar tolerance =
        sideTolerance*boundBox(surface.points, false).mag();

    //- Side patch of each face, -1 of the wall
    labelList sideOfFace{};

    List<sidePatch> sides{};

    //- How many of them are parts of planes; planes without faces follow
    label nParts = 0;

    sideBorders borders{};

    wallSurface wall{};


    bitSet pointsOn(const label s) const
    {
        bitSet on(borders.pointSides.size());
        forAll(borders.pointSides, p)
        {
            on.set(p, borders.pointSides[p].found(s));
        }

        return on;
    }

    void checkSides() const;

    void putOnPlanes(wallReading& reading);

    void takeWall();

    wallSurface split(wallReading& reading);
};


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
        if (borders.pointSides[e.start()].size() > 2)
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
    forAll(borders.pointSides, p)
    {
        const point x = surface.points[p];

        if (borders.pointSides[p].size())
        {
            surface.points[p] = onAll(sides, borders.pointSides[p], x);

            const scalar distance = mag(surface.points[p] - x);
            reading.pointsPutOnSides += distance > 0;
            reading.largestMove = max(reading.largestMove, distance);
        }
    }
}


void wallSplitter::takeWall()
{
    forAll(sides, s)
    {
        const wallSurface part
        (
            makeSurfacePart(surface, findIndices(sideOfFace, s)).surface
        );
        sides[s].points = part.points;
        sides[s].faces = part.faces;
        setShape(sides[s]);
    }

    const surfacePart rest
    (
        makeSurfacePart(surface, findIndices(sideOfFace, -1))
    );
    wallBorder border(wall.border);
    const labelList local(invert(surface.points.size(), rest.points));
    for (edge& e : border.edges)
    {
        inplaceRenumber(local, e);
    }
    wall = rest.surface;
    wall.border = border;
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
    sideOfFace = parts.sideOfFace;
    sides = parts.sides;
    nParts = sides.size();
    sides.append(controls.sidePlanes);

    borders = findSideBorders(surface, parts, controls.sidePlanes, tolerance);
    wall.border.edges = borders.edges;
    wall.border.edgeSides = borders.edgeSides;
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


static bool matchesAny(const patchLayers& entry, const wordList& names)
{
    return anyOf(names, [&](const word& name)
    {
        return entry.patches.match(name);
    });
}


static void refuse(const patchLayers& entry, const wordList& names)
{
    FatalErrorInFunction
        << "The entry " << entry.patches << " of layers.patches"
        << " matches no patch of the surface" << nl
        << "Its patches: " << flatOutput(names) << exit(FatalError);
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

        if (entry.isSide && !matchesAny(entry, surface.patchNames))
        {
            refuse(entry, surface.patchNames);
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
