/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planeDomain.H"
#include "boundBox.H"
#include "coneVolume.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The part of a convex polygon that is behind a plane
static pointField clipped(const pointField& polygon, const sidePlane& plane)
{
    DynamicList<point> kept;

    forAll(polygon, i)
    {
        const point& a = polygon[i];
        const point& b = polygon[polygon.fcIndex(i)];
        const scalar da = plane.distance(a);
        const scalar db = plane.distance(b);

        if (da <= 0)
        {
            kept.append(a);
        }
        if ((da < 0 && db > 0) || (da > 0 && db < 0))
        {
            kept.append(a + (da/(da - db))*(b - a));
        }
    }

    return pointField(std::move(kept));
}


//- A square in a plane that is wider than what all planes bound
static pointField squareIn(const UList<sidePlane>& planes, const label i)
{
    boundBox box(boundBox::invertedBox);
    for (const sidePlane& plane : planes)
    {
        box.add(plane.origin);
    }

    const vector& n = planes[i].normal;
    const vector axis(mag(n.x()) < 0.6 ? vector(1, 0, 0) : vector(0, 1, 0));
    const vector a(10*box.mag()*normalised(axis ^ n));
    const vector b(n ^ a);
    const point& x = planes[i].origin;

    return pointField({x + a + b, x - a + b, x - a - b, x + a - b});
}


static scalar areaOf(const UList<sidePlane>& planes, const label i)
{
    pointField polygon(squareIn(planes, i));
    forAll(planes, j)
    {
        if (j != i)
        {
            polygon = clipped(polygon, planes[j]);
        }
    }

    vector area(Zero);
    for (label k = 2; k < polygon.size(); ++k)
    {
        area +=
            0.5*((polygon[k - 1] - polygon[0]) ^ (polygon[k] - polygon[0]));
    }

    return mag(area);
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::scalarField Foam::areasOf(const UList<sidePlane>& planes)
{
    scalarField areas(planes.size());
    forAll(areas, i)
    {
        areas[i] = areaOf(planes, i);
    }

    return areas;
}


Foam::scalar Foam::volumeOf(const UList<sidePlane>& planes)
{
    const scalarField areas(areasOf(planes));
    scalar volume = 0;
    forAll(areas, i)
    {
        volume -= areas[i]*planes[i].distance(planes[0].origin)/3;
    }

    return volume;
}


Foam::point Foam::pointOn(const UList<sidePlane>& planes, point x)
{
    // One after the other, as long as it takes
    for (label pass = 0; pass < 1000; ++pass)
    {
        const point before(x);
        for (const sidePlane& plane : planes)
        {
            x -= plane.distance(x)*plane.normal;
        }
        if (x == before)
        {
            break;
        }
    }

    return x;
}


Foam::scalar Foam::capArea
(
    const endedSurface& surface,
    const sidePlane& plane,
    const label planei,
    const point& x
)
{
    scalar area = 0;
    forAll(surface.edges, i)
    {
        if (surface.edgePlanes[i] == planei)
        {
            // The cap runs along it the other way
            const vector a(surface.points[surface.edges[i].start()] - x);
            const vector b(surface.points[surface.edges[i].end()] - x);
            area += 0.5*((b ^ a) & plane.normal);
        }
    }

    return area;
}


Foam::scalar Foam::volumeOf
(
    const endedSurface& surface,
    const UList<sidePlane>& planes
)
{
    const point origin
    (
        pointOn(planes, boundBox(surface.points, false).centre())
    );
    scalar volume = coneVolume(surface.faces, surface.points, origin)/6;

    forAll(planes, i)
    {
        const scalar height = -planes[i].distance(origin);
        const point x(origin + height*planes[i].normal);
        volume += height*capArea(surface, planes[i], i, x)/3;
    }

    return volume;
}


bool Foam::boundsFluid(const wallSurface& wall)
{
    const List<sidePatch>& sides = wall.border.sides;
    if (sides.size() && sides[0].isPart())
    {
        return enclosedVolume(wall) < 0;
    }

    const endedSurface surface
    {
        wall.points, wall.faces, wall.border.edges, wall.border.edgeSides
    };
    const List<sidePlane> planes(sides.begin(), sides.end());

    return volumeOf(surface, planes) < 0;
}


// ************************************************************************* //
