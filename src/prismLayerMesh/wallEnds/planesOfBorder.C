/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planesOfBorder.H"
#include "boxSides.H"
#include "disjointSets.H"
#include "ranges.H"

namespace Foam
{

// * * * * * * * * * * * * * *  Planes Of Border * * * * * * * * * * * * * * //

//- A surface that ends on more planes than this is damaged
static constexpr label maxPlanes = 20;


//- The mean plane of each connected part of the border
static List<sidePatch> meanPlanes
(
    const pointField& points,
    const edgeList& border
)
{
    disjointSets parts(connectedPoints(points.size(), border));

    // Sums of lengths, of centres of edges by length, and of areas
    struct sums { scalar length = 0; vector centre = Zero, area = Zero; };
    Map<sums> sumsOf;
    for (const edge& e : border)
    {
        sums& part = sumsOf(parts.find(e.start()));
        const scalar length = e.mag(points);
        part.length += length;
        part.centre += length*e.centre(points);
        // From the part's smallest point, near to it: less is lost to rounding
        const point& origin = points[parts.find(e.start())];
        part.area += (points[e.start()] - origin) ^ (points[e.end()] - origin);
    }

    List<sidePatch> planes;
    for (const label part : sumsOf.sortedToc())
    {
        const sums& s = sumsOf[part];
        if (s.length > 0 && mag(s.area) > SMALL*sqr(s.length))
        {
            sidePatch plane;
            plane.name = "plane" + Foam::name(planes.size());
            plane.origin = s.centre/s.length;
            plane.normal = normalised(s.area);
            planes.append(plane);
        }
    }

    return planes;
}


//- Turns the plane's normal away from the surface. Whether that is on one side
//  of it, and not all in it
static bool turnFrom
(
    const pointField& points,
    const scalar tolerance,
    sidePatch& plane
)
{
    const scalarField distances(distancesTo(plane, points));
    scalar least = min(min(distances), scalar(0));
    scalar most = max(max(distances), scalar(0));

    if (most > -least)
    {
        plane.normal = -plane.normal;
        std::swap(least, most);
        least = -least;
        most = -most;
    }

    return most <= tolerance && least < -tolerance;
}


List<sidePatch> planesOfBorder
(
    const wallSurface& surface,
    const scalar relativeTolerance
)
{
    const pointField& points = surface.points;
    const edgeList border(outline(surface.faces));
    const boundBox box(points, false);
    const scalar tolerance = relativeTolerance*box.mag();

    List<sidePatch> candidates(sidesOf(box));
    candidates.append(meanPlanes(points, border));

    List<sidePatch> result;
    bitSet left(border.size(), true);

    const auto isOn = [&](const sidePatch& plane, const label i)
    {
        const edge& e = border[i];
        return plane.hasEdge(points[e.start()], points[e.end()], tolerance);
    };

    while (left.any() && result.size() < maxPlanes)
    {
        scalar most = 0;
        sidePatch best;

        for (sidePatch& plane : candidates)
        {
            scalar length = 0;
            for (const label i : left)
            {
                length += isOn(plane, i) ? border[i].mag(points) : 0;
            }
            if (length > most && turnFrom(points, tolerance, plane))
            {
                most = length;
                best = plane;
            }
        }

        if (most == 0)
        {
            break;
        }

        for (const label i : bitSet(left))
        {
            if (isOn(best, i))
            {
                left.unset(i);
            }
        }
        result.append(best);
    }

    return left.any() ? List<sidePatch>() : result;
}

} // End namespace Foam

// ************************************************************************* //
