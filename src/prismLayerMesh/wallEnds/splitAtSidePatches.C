/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "splitAtSidePatches.H"
#include "boundBox.H"
#include "orientOpenWall.H"
#include "ranges.H"
#include "sideParts.H"
#include "sideShape.H"
#include "StringStream.H"
#include "surfacePart.H"
#include "wallSides.H"

namespace Foam
{

label planeOfEdge
(
    const UList<sidePatch>& planes,
    const point& a,
    const point& b,
    const scalar tolerance
)
{
    label nearest = -1;
    scalar least = tolerance;
    forAll(planes, i)
    {
        const scalar distance =
            max(mag(planes[i].distance(a)), mag(planes[i].distance(b)));

        if (distance <= least)
        {
            least = distance;
            nearest = i;
        }
    }

    return nearest;
}


void refuseAt
(
    const UList<point>& places,
    const string& what,
    const string& advice
)
{
    if (places.empty())
    {
        return;
    }

    FatalErrorInFunction
        << what.c_str() << " at " << places.size() << " places:";

    for (label i = 0; i < min(places.size(), label(10)); ++i)
    {
        FatalError << nl << "    " << places[i];
    }
    if (advice.size())
    {
        FatalError << nl << advice.c_str();
    }

    FatalError << exit(FatalError);
}


void checkInFront
(
    const wallSurface& surface,
    const sidePatch& plane,
    const bitSet& onPlane,
    const scalar tolerance
)
{
    DynamicList<point> beyond, touching;

    forAll(surface.points, p)
    {
        const scalar distance = plane.distance(surface.points[p]);

        if (distance > tolerance)
        {
            beyond.append(surface.points[p]);
        }
        else if (distance > -touchShare*tolerance && !onPlane.test(p))
        {
            touching.append(surface.points[p]);
        }
    }

    for (const face& f : surface.faces)
    {
        const bool isOn =
            allOf(f, [&](const label p) { return onPlane.test(p); });

        if (isOn)
        {
            touching.append(f.centre(surface.points));
        }
    }

    refuseAt
    (
        beyond,
        "The surface is beyond the side plane " + plane.name
      + ", whose normal must point out of the fluid,",
        "Move the plane out, turn its normal, or let surface.repair stitch cut"
        " the surface there"
    );
    refuseAt
    (
        touching, "The wall touches the side plane " + plane.name,
        "Move the side out. Or move it in: surface.repair stitch cuts the wall"
        " there"
    );
}


// * * * * * * * * * * * * * * *  Side Borders * * * * * * * * * * * * * * * //

namespace
{

struct borderFinder
{
    const wallSurface& surface;
    const sideParts& parts;
    const UList<sidePatch>& planes;
    const scalar tolerance;

    sideBorders borders{};


    //- The side patch of the plane of an edge, -1 if there is none
    label planeOf(const wallSide& edge) const
    {
        const point& a = surface.points[edge.low];
        const point& b = surface.points[edge.high];
        const label i = planeOfEdge(planes, a, b, tolerance);

        return i < 0 ? -1 : parts.sides.size() + i;
    }

    void addPointSide(const label p, const label s)
    {
        if (!borders.pointSides[p].found(s))
        {
            borders.pointSides[p].append(s);
        }
    }

    //- An edge of a face is on a side patch: a border if the face is the wall's
    void addBorder(const wallSide& edge, const label side)
    {
        addPointSide(edge.low, side);
        addPointSide(edge.high, side);

        if (parts.sideOfFace[edge.facei] < 0)
        {
            borders.edges.append(edge.along());
            borders.edgeSides.append(side);
        }
    }

    //- Adds the border on an edge, if there is one. Returns false if the edge
    //  has one face and is near no plane.
    bool addBorders(const UList<wallSide>& onEdge)
    {
        const wallSide& first = onEdge[0];

        if (onEdge.size() == 1)
        {
            const label plane = planeOf(first);
            if (plane >= 0)
            {
                addBorder(first, plane);
            }
            return plane >= 0;
        }

        const wallSide& second = onEdge[1];
        const label side = parts.sideOfFace[first.facei];
        const label other = parts.sideOfFace[second.facei];

        if (side < 0 && other >= 0)
        {
            addBorder(first, other);
        }
        else if (side >= 0 && other < 0)
        {
            addBorder(second, side);
        }

        return true;
    }

    //- Refuses borders at some places: no plane is near to them
    void refuseFar(const UList<point>& places) const
    {
        OStringStream bound;
        bound << tolerance;
        refuseAt
        (
            places,
            "The surface is open and its border is further than " + bound.str()
          + " m from all side planes",
            "Put a side plane there (surface.sidePlanes), or close the surface"
            " (surface.repair stitch fills holes)"
        );
    }

    //- The points of faces on side patches are on these patches
    void addPointsOfSides()
    {
        forAll(parts.sideOfFace, facei)
        {
            const face& f = surface.faces[facei];
            const label side = parts.sideOfFace[facei];

            for (label k = 0; side >= 0 && k < f.size(); ++k)
            {
                addPointSide(f[k], side);
            }
        }
    }

    sideBorders find()
    {
        borders.pointSides.setSize(surface.points.size());
        const wallSides edges(makeWallSides(surface));
        DynamicList<point> lost;
        for (label e = 0; e < edges.nEdges(); ++e)
        {
            if (!addBorders(edges.on(e)))
            {
                const wallSide& side = edges.on(e)[0];
                lost.append
                (
                    0.5*(surface.points[side.low] + surface.points[side.high])
                );
            }
        }

        refuseFar(lost);
        addPointsOfSides();

        return borders;
    }
};

} // End anonymous namespace


sideBorders findSideBorders
(
    const wallSurface& surface,
    const sideParts& parts,
    const UList<sidePatch>& planes,
    const scalar tolerance
)
{
    return borderFinder{surface, parts, planes, tolerance}.find();
}


// * * * * * * * * * * * * *  Split At Side Patches  * * * * * * * * * * * * //

//- A curved side patch has the shape of its faces
static void setShape(sidePatch& side)
{
    if (side.isCurved())
    {
        side.shape = std::make_shared<const sideShape>(side.points, side.faces);
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

    void checkSides() const
    {
        for (label s = nParts; s < sides.size(); ++s)
        {
            if (!wall.border.edgeSides.found(s))
            {
                FatalErrorInFunction
                    << "No border of the wall is on the side plane "
                    << sides[s].name << " at " << sides[s].origin << nl
                    << "Move the plane to the border, or remove it. To cut the"
                    << " surface at the plane, write surface { repair stitch; }"
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
                    << surface.points[e.start()] << " of the wall" << nl
                    << "Move one of them away from the point, or give a patch"
                    << " among them layers: remove its nSurfaceLayers 0"
                    << exit(FatalError);
            }
        }
    }

    void putOnPlanes(wallReading& reading)
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

    void takeWall()
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

    wallSurface split(wallReading& reading)
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

        borders =
            findSideBorders(surface, parts, controls.sidePlanes, tolerance);
        wall.border.edges = borders.edges;
        wall.border.edgeSides = borders.edgeSides;
        checkSides();
        putOnPlanes(reading);
        takeWall();

        return std::move(wall);
    }
};

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


void requirePatches(const layerControls& layers, const wordList& patchNames)
{
    for (const patchLayers& entry : layers.patches)
    {
        const bool isFound = anyOf(patchNames, [&](const word& name)
        {
            return entry.patches.match(name);
        });

        if (!isFound)
        {
            FatalErrorInFunction
                << "The entry " << entry.patches << " of layers.patches"
                << " matches no patch of the surface" << nl
                << "Its patches: " << listed(patchNames).c_str()
                << exit(FatalError);
        }
    }
}


wallSurface splitAtSidePatches
(
    const wallSurface& surface,
    const wallSurfaceControls& controls,
    const layerControls& layers,
    wallReading& reading
)
{
    const bool hasSides =
        controls.sidePlanes.size()
     || anyOf(layers.patches, [](const patchLayers& p) { return p.isSide; });

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
