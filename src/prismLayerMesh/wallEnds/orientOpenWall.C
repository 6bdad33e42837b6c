/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "orientOpenWall.H"
#include "boundBox.H"
#include "HashSet.H"
#include "ListOps.H"
#include "Map.H"
#include "mathematicalConstants.H"
#include "ranges.H"
#include "surfacePart.H"
#include "wallSides.H"

namespace Foam
{

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


List<borderCorner> openComponent::corners() const
{
    Map<label> planeOfStart;
    forAll(borders, i)
    {
        planeOfStart.insert(borders[i].start(), planes[i]);
    }

    DynamicList<borderCorner> found;
    forAll(borders, i)
    {
        const label p = borders[i].end();
        const label next = planeOfStart.lookup(p, planes[i]);
        if (next != planes[i])
        {
            found.append(borderCorner{p, planes[i], next});
        }
    }

    return List<borderCorner>(std::move(found));
}


//- Returns a point in each plane; nothing if there are no caps. Where a border
//  of a component goes from one plane to another, it is one point in all planes
//  of the component, or two, each in all planes but one.
static pointField capPoints
(
    const UList<sidePatch>& planes,
    const openComponent& component,
    const UList<borderCorner>& corners,
    const scalar tolerance,
    const point& near
)
{
    if (corners.empty())
    {
        pointField origins(planes.size());
        forAll(planes, s)
        {
            origins[s] = planes[s].origin;
        }
        return origins;
    }

    const labelList all(labelHashSet(component.planes).sortedToc());
    point x(near);
    if (moveToAll(planes, all, tolerance, x))
    {
        return pointField(planes.size(), x);
    }

    const auto moveToAllBut = [&](const label one, point& x)
    {
        const labelList others
        (
            subsetList(all, [&](const label s) { return s != one; })
        );
        x = near;

        return moveToAll(planes, others, tolerance, x);
    };

    for (const label a : all)
    {
        for (const label b : all)
        {
            const bool isApart = !anyOf(corners, [&](const borderCorner& c)
            {
                return (c.from == a && c.to == b) || (c.from == b && c.to == a);
            });
            point onB;
            if (a < b && isApart && moveToAllBut(b, x) && moveToAllBut(a, onB))
            {
                pointField points(planes.size(), x);
                points[b] = onB;
                return points;
            }
        }
    }

    return pointField();
}


List<openComponent> openComponents
(
    const wallSurface& surface,
    const UList<sidePatch>& planes
)
{
    const wallSides edges(makeWallSides(surface));
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


bool isOnOrBeyond
(
    const pointField& points,
    const edgeList& border,
    const UList<sidePatch>& planes,
    const scalar near
)
{
    return allOf(border, [&](const edge& e)
    {
        return anyOf(planes, [&](const sidePatch& plane)
        {
            return
                plane.distance(points[e.start()]) > -near
             && plane.distance(points[e.end()]) > -near;
        });
    });
}


List<triPoints> cappedTriangles
(
    const wallSurface& surface,
    const UList<sidePatch>& planes,
    const openComponent& component
)
{
    const pointField& points = surface.points;
    const scalar size = boundBox(points, false).mag();
    const List<borderCorner> corners(component.corners());

    // Caps are triangles from a point in their plane
    const pointField tops
    (
        capPoints
        (
            planes, component, corners, 1e-6*size,
            points[surface.faces[component.faces[0]][0]]
        )
    );
    if (corners.size() && tops.empty())
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
        const point& top = tops[component.planes[i]];
        triangles.append(triPoints(points[e.end()], points[e.start()], top));
    }

    // Between two points in caps, in the plane that has both
    for (const borderCorner& corner : corners)
    {
        triangles.append
        (
            triPoints
            (
                points[corner.point], tops[corner.from], tops[corner.to]
            )
        );
    }

    return List<triPoints>(std::move(triangles));
}


scalar volumeOf(const UList<triPoints>& triangles)
{
    scalar volume = 0;

    for (const triPoints& t : triangles)
    {
        const point& origin = triangles[0][0];
        volume += ((t[0] - origin) ^ (t[1] - origin)) & (t[2] - origin);
    }

    return volume/6;
}


//- Half of the sum of the solid angles of triangles [sr], positive for those
//  that turn their backs
static scalar halfSolidAngle(const UList<triPoints>& triangles, const point& x)
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

    return halves;
}


bool isWithin(const UList<triPoints>& triangles, const point& x)
{
    return mag(halfSolidAngle(triangles, x)) > constant::mathematical::pi;
}


bool isBehind(const UList<triPoints>& triangles, const point& x)
{
    return halfSolidAngle(triangles, x) > 0;
}


// * * * * * * * * * * * * * *  Orient Open Wall * * * * * * * * * * * * * * //

//- The centre of the largest of some faces
static point centreOfLargest(const wallSurface& surface, const labelList& faces)
{
    scalarField areas(faces.size());
    forAll(areas, i)
    {
        areas[i] = surface.faces[faces[i]].mag(surface.points);
    }

    return surface.faces[faces[findMax(areas)]].centre(surface.points);
}


namespace
{

//- Components with plane caps on their borders
struct cappedComponents
{
    List<List<triPoints>> triangles;
    List<boundBox> boxes;

    cappedComponents
    (
        const wallSurface& surface,
        const UList<sidePatch>& planes,
        const UList<openComponent>& components
    )
    :
        triangles(components.size()),
        boxes(components.size(), boundBox::invertedBox)
    {
        forAll(components, i)
        {
            triangles[i] = cappedTriangles(surface, planes, components[i]);
            for (const triPoints& t : triangles[i])
            {
                boxes[i].add(t);
            }
        }
    }

    //- Number of the other components that a point of component i is within
    label nAround(const label i, const point& x) const
    {
        label n = 0;
        forAll(triangles, j)
        {
            n += i != j && boxes[j].contains(x) && isWithin(triangles[j], x);
        }

        return n;
    }
};

} // End anonymous namespace


static void flip(const labelUList& faces, wallSurface& surface)
{
    for (const label facei : faces)
    {
        surface.faces[facei].flip();
    }
}


label orientOpenWall
(
    wallSurface& surface,
    const UList<sidePatch>& planes,
    const bool fluidOutside
)
{
    const List<openComponent> components(openComponents(surface, planes));
    const bool open = anyOf(components, [](const openComponent& c)
    {
        return c.borders.size();
    });

    // All closed: they are oriented already
    label nFlipped = 0;
    if (!open)
    {
        return nFlipped;
    }

    const cappedComponents capped(surface, planes, components);
    forAll(components, i)
    {
        const point x(centreOfLargest(surface, components[i].faces));
        const label n = capped.nAround(i, x);
        const bool isBody = components[i].borders.empty() && n == 0;
        const bool outward = isBody || fluidOutside == (n % 2 == 0);

        if (outward != (volumeOf(capped.triangles[i]) >= 0))
        {
            nFlipped += components[i].faces.size();
            flip(components[i].faces, surface);
        }
    }

    return nFlipped;
}


DynamicList<point> removeCavities
(
    wallSurface& surface,
    const UList<sidePatch>& planes,
    scalar& volume
)
{
    const List<openComponent> components(openComponents(surface, planes));
    const cappedComponents capped(surface, planes, components);
    bitSet kept(surface.faces.size(), true);
    DynamicList<point> places;
    forAll(components, i)
    {
        const labelList& faces = components[i].faces;
        const scalar inside = volumeOf(capped.triangles[i]);
        const point x(centreOfLargest(surface, faces));
        if (inside < 0 && capped.nAround(i, x) > 0)
        {
            kept.unset(faces);
            places.append(x);
            volume -= inside;
        }
    }
    if (places.size())
    {
        keepFaces(kept, surface);
    }

    return places;
}

} // End namespace Foam

// ************************************************************************* //
