/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "randomSurface.H"
#include "convexHull.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace randomSurfaces
{

//- On the unit sphere; its centre is inside of their hull
static pointField directions(const label n, Random& random)
{
    pointField points(max(n, label(6)));

    forAll(points, i)
    {
        points[i] = unitVector(random);

        if (i < 6)
        {
            // An octahedron, shaken
            vector axis(Zero);
            axis[i % 3] = i < 3 ? 1 : -1;
            points[i] = normalised(axis + 0.4*points[i]);
        }
    }

    // The first four are a tetrahedron
    Swap(points[2], points[3]);

    return points;
}


//- Pyramids on a share of the facets, inward and outward
static void capFacets(wallSurface& wall, const scalar share, Random& random)
{
    DynamicList<point> points(wall.points);
    DynamicList<face> faces;

    for (const face& f : wall.faces)
    {
        if (!chance(random, share))
        {
            faces.append(f);
            continue;
        }

        const label apex = points.size();
        const scalar factor = logUniform(random, 0.25, 2.5);
        points.append(factor*f.centre(wall.points));

        forAll(f, i)
        {
            face side(3);
            side[0] = f[i];
            side[1] = f.nextLabel(i);
            side[2] = apex;
            faces.append(side);
        }
    }

    wall.points.transfer(points);
    wall.faces.transfer(faces);
    setPatch(wall);
}

} // End namespace randomSurfaces
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wallSurface Foam::randomSurfaces::spikyPolyhedron(Random& random)
{
    const label n = label(logUniform(random, 6, 100));

    // The hull of the directions is the same, seen from the centre, with any
    // radii
    wallSurface wall;
    wall.points = directions(n, random);
    wall.faces = convexHull(wall.points);
    setPatch(wall);

    const scalar lowest = random.position<scalar>(0.3, 1);
    for (point& p : wall.points)
    {
        p *= random.position<scalar>(lowest, 1);
    }

    if (chance(random, 0.7))
    {
        const scalar share = random.sample01<scalar>();
        capFacets(wall, share, random);
    }

    if (chance(random, 0.3))
    {
        stretch(wall, 0.05, random);
    }

    return wall;
}


// ************************************************************************* //
