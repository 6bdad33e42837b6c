/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "orientOpenWall.H"
#include "boundBox.H"
#include "openComponents.H"
#include "ranges.H"
#include "surfacePart.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


//- Number of the other components that a point of a component is within
static label nAround
(
    const List<List<triPoints>>& capped,
    const UList<boundBox>& boxes,
    const label i,
    const point& x
)
{
    label n = 0;
    forAll(capped, j)
    {
        n += i != j && boxes[j].contains(x) && isWithin(capped[j], x);
    }

    return n;
}


static void flip(const labelUList& faces, wallSurface& surface)
{
    for (const label facei : faces)
    {
        surface.faces[facei].flip();
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
        const label n = nAround(capped, boxes, i, x);
        const bool isBody = components[i].borders.empty() && n == 0;
        const bool outward = isBody || fluidOutside == (n % 2 == 0);

        if (outward != (volumeOf(capped[i]) >= 0))
        {
            nFlipped += components[i].faces.size();
            flip(components[i].faces, surface);
        }
    }

    return nFlipped;
}


label removeCavities(wallSurface& surface, const UList<sidePatch>& planes)
{
    bitSet kept(surface.faces.size(), true);
    label nCavities = 0;

    for (const openComponent& component : openComponents(surface, planes))
    {
        if (volumeOf(cappedTriangles(surface, planes, component)) < 0)
        {
            kept.unset(component.faces);
            ++nCavities;
        }
    }

    keepFaces(kept, surface);

    return nCavities;
}

} // End namespace Foam

// ************************************************************************* //
