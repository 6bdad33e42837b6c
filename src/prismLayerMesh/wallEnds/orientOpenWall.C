/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "splitAtSidePatches.H"
#include "boundBox.H"
#include "mathematicalConstants.H"
#include "triPoints.H"
#include "wallSides.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Index of the plane that is nearest to the middle of an edge
static label nearestPlane
(
    const wallSurface& surface,
    const UList<sidePatch>& planes,
    const wallSide& side
)
{
    const point middle
    (
        0.5*(surface.points[side.low] + surface.points[side.high])
    );
    label nearest = 0;

    forAll(planes, s)
    {
        if
        (
            mag(planes[s].distance(middle))
          < mag(planes[nearest].distance(middle))
        )
        {
            nearest = s;
        }
    }

    return nearest;
}


//- The point nearest to x that is on all of some planes; true if there is one
static bool moveToAll
(
    const UList<sidePatch>& planes,
    const labelUList& some,
    const scalar tolerance,
    point& x
)
{
    // Alternating projections
    scalar largest = GREAT;
    for (label pass = 0; pass < 1000 && largest > tolerance; ++pass)
    {
        largest = 0;
        for (const label s : some)
        {
            const scalar distance = planes[s].distance(x);
            x -= distance*planes[s].normal;
            largest = max(largest, mag(distance));
        }
    }

    return largest <= tolerance;
}


namespace
{

//- A component and its borders on planes
struct openComponent
{
    labelList faces;

    //- As the faces run along them
    DynamicList<edge> borders;
    DynamicList<label> planes;

    //- Whether a border changes from a plane to another
    bool turnsCorner() const
    {
        Map<label> planeOfStart;
        forAll(borders, i)
        {
            planeOfStart.insert(borders[i].start(), planes[i]);
        }

        forAll(borders, i)
        {
            if (planeOfStart.lookup(borders[i].end(), -1) != planes[i])
            {
                return true;
            }
        }

        return false;
    }
};

} // End anonymous namespace


//- The triangles of a component and of caps on its borders; none if there are
//  no such caps
static List<triPoints> cappedTriangles
(
    const wallSurface& surface,
    const UList<sidePatch>& planes,
    const openComponent& component
)
{
    const pointField& points = surface.points;
    const scalar size = boundBox(points, false).mag();
    const labelList some(labelHashSet(component.planes).sortedToc());
    const bool turns = component.turnsCorner();
    point apex(points[surface.faces[component.faces[0]][0]]);

    // Caps are triangles from an apex in their plane: from one in all planes
    // where borders go from one to another
    if (turns && !moveToAll(planes, some, 1e-6*size, apex))
    {
        return List<triPoints>();
    }

    DynamicList<triPoints> triangles;
    for (const label facei : component.faces)
    {
        const face& f = surface.faces[facei];
        for (label k = 1; k + 1 < f.size(); ++k)
        {
            triangles.append
            (
                triPoints(points[f[0]], points[f[k]], points[f[k + 1]])
            );
        }
    }

    forAll(component.borders, i)
    {
        const edge& e = component.borders[i];
        const point& top = turns ? apex : planes[component.planes[i]].origin;
        triangles.append(triPoints(points[e.end()], points[e.start()], top));
    }

    return List<triPoints>(std::move(triangles));
}


//- Volume that triangles bound, negative if their normals point inwards
static scalar volumeOf(const UList<triPoints>& triangles)
{
    scalar volume = 0;

    for (const triPoints& t : triangles)
    {
        const point& origin = triangles[0][0];
        volume +=
            ((t[0] - origin) ^ (t[1] - origin)) & (t[2] - origin);
    }

    return volume/6;
}


//- Whether a point is within triangles: the sum of their solid angles is that
//  of the sphere (van Oosterom, Strackee, IEEE TBME 30(2), 1983)
static bool isWithin(const UList<triPoints>& triangles, const point& x)
{
    scalar halves = 0;

    for (const triPoints& t : triangles)
    {
        const vector a(t[0] - x);
        const vector b(t[1] - x);
        const vector c(t[2] - x);

        halves += ::atan2
        (
            (a ^ b) & c,
            mag(a)*mag(b)*mag(c)
          + (a & b)*mag(c) + (b & c)*mag(a) + (c & a)*mag(b)
        );
    }

    return mag(halves) > constant::mathematical::pi;
}


//- The centre of the largest of some faces
static point centreOfLargest
(
    const wallSurface& surface,
    const labelList& faces
)
{
    scalarField areas(faces.size());
    forAll(areas, i)
    {
        areas[i] = surface.faces[faces[i]].mag(surface.points);
    }

    return surface.faces[faces[findMax(areas)]].centre(surface.points);
}


//- The components of a surface with their borders on planes
static List<openComponent> componentsOf
(
    const wallSurface& surface,
    const UList<sidePatch>& planes
)
{
    const wallSides edges(makeWallSides(surface.faces, surface.points.size()));
    labelList componentOfFace;
    const label n =
        findComponents(edges, surface.faces.size(), componentOfFace);
    List<openComponent> components(n);
    const labelListList faces(invertOneToMany(n, componentOfFace));

    for (label e = 0; planes.size() && e < edges.nEdges(); ++e)
    {
        const wallSide& side = edges.on(e)[0];

        if (edges.on(e).size() == 1)
        {
            openComponent& component = components[componentOfFace[side.facei]];
            component.borders.append(side.along());
            component.planes.append(nearestPlane(surface, planes, side));
        }
    }

    forAll(components, i)
    {
        components[i].faces = faces[i];
    }

    return components;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

label orientOpenWall
(
    wallSurface& surface,
    const UList<sidePatch>& planes,
    const bool fluidOutside
)
{
    const List<openComponent> components(componentsOf(surface, planes));
    const bool open = std::any_of
    (
        components.begin(), components.end(),
        [](const openComponent& c) { return c.borders.size(); }
    );

    // All closed: they are oriented already
    label nFlipped = 0;
    if (!open)
    {
        return nFlipped;
    }

    List<List<triPoints>> capped(components.size());
    List<boundBox> boxes(components.size(), boundBox::invertedBox);
    forAll(components, i)
    {
        capped[i] = cappedTriangles(surface, planes, components[i]);
        for (const triPoints& t : capped[i])
        {
            boxes[i].add(t);
        }
    }

    forAll(components, i)
    {
        const point x(centreOfLargest(surface, components[i].faces));
        label nAround = 0;
        forAll(components, j)
        {
            nAround +=
                i != j && boxes[j].contains(x) && isWithin(capped[j], x);
        }

        const bool isBody = components[i].borders.empty() && nAround == 0;
        const bool outward = isBody || fluidOutside == (nAround % 2 == 0);

        if (outward != (volumeOf(capped[i]) >= 0))
        {
            nFlipped += components[i].faces.size();
            for (const label facei : components[i].faces)
            {
                surface.faces[facei].flip();
            }
        }
    }

    return nFlipped;
}


label removeCavities(wallSurface& surface, const UList<sidePatch>& planes)
{
    bitSet kept(surface.faces.size(), true);
    label nCavities = 0;

    for (const openComponent& component : componentsOf(surface, planes))
    {
        if (volumeOf(cappedTriangles(surface, planes, component)) < 0)
        {
            kept.unset(component.faces);
            ++nCavities;
        }
    }

    inplaceSubset(kept, surface.faces);
    inplaceSubset(kept, surface.patchIDs);
    removeUnusedPoints(surface.faces, surface.points);

    return nCavities;
}

} // End namespace Foam

// ************************************************************************* //
