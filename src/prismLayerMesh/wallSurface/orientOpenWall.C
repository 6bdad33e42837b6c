/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "endWall.H"
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


//- Volume that a component bounds with caps on its borders, negative if its
//  normals point inwards; 0 if there are no such caps
static scalar cappedVolume
(
    const wallSurface& surface,
    const UList<sidePatch>& planes,
    const openComponent& component
)
{
    const scalar size = boundBox(surface.points, false).mag();
    const labelList some(labelHashSet(component.planes).sortedToc());
    const bool turns = component.turnsCorner();
    point apex(surface.points[surface.faces[component.faces[0]][0]]);

    // Caps are triangles from an apex in their plane: from one in all planes
    // where borders go from one to another
    if (turns && !moveToAll(planes, some, 1e-6*size, apex))
    {
        return 0;
    }

    const point& origin = apex;
    scalar volume = 0;

    for (const label facei : component.faces)
    {
        const face& f = surface.faces[facei];
        volume += (f.centre(surface.points) - origin)
            & f.areaNormal(surface.points);
    }

    forAll(component.borders, i)
    {
        const edge& e = component.borders[i];
        const point& a = surface.points[e.end()];
        const point& b = surface.points[e.start()];
        const point top(turns ? apex : planes[component.planes[i]].origin);
        volume += 0.5*(((a - top) ^ (b - top)) & (top - origin));
    }

    return volume/3;
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
        const wallSide& side = edges.sides[edges.edgeStarts[e]];

        if (edges.edgeStarts[e + 1] - edges.edgeStarts[e] == 1)
        {
            openComponent& component = components[componentOfFace[side.facei]];
            component.borders.append
            (
                side.up ? edge(side.low, side.high) : edge(side.high, side.low)
            );
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
    for (label i = 0; open && i < components.size(); ++i)
    {
        const openComponent& component = components[i];
        const bool outward = cappedVolume(surface, planes, component) >= 0;

        if (outward != (component.borders.empty() || fluidOutside))
        {
            nFlipped += component.faces.size();
            for (const label facei : component.faces)
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
        if (cappedVolume(surface, planes, component) < 0)
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
