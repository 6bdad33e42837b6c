/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "randomSurface.H"
#include "testSurfaces.H"
#include "convexHull.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace randomSurfaces
{

//- The icosahedron, refined and blown up
static wallSurface icosphere(const label nRefinements)
{
    const scalar golden = 0.5*(1 + Foam::sqrt(scalar(5)));
    pointField corners(12);

    for (label i = 0; i < 12; ++i)
    {
        // From one of the three golden rectangles to the next
        const direction d = i % 3;
        corners[i] = Zero;
        corners[i][d] = i/3 % 2 ? 1 : -1;
        corners[i][(d + 1) % 3] = i/6 ? golden : -golden;
    }

    wallSurface wall;
    wall.points = corners;
    wall.faces = convexHull(corners);
    setPatch(wall);

    for (label i = 0; i < nRefinements; ++i)
    {
        wall = refined(wall);
    }

    for (point& p : wall.points)
    {
        p /= mag(p);
    }

    return wall;
}


static wallSurface sphere(Random& random)
{
    if (chance(random, 0.4))
    {
        return icosphere(random.position<label>(0, 3));
    }

    const label n = label(logUniform(random, 1, 12));

    if (chance(random, 0.4))
    {
        return testSurfaces::quadSphere(n);
    }

    return randomlyCut(testSurfaces::quadSphere(n), random);
}


//- Noise in [-1, 1]: waves of about one wave number, or nothing but points
static scalarField noise(const pointField& points, Random& random)
{
    using constant::mathematical::twoPi;

    scalarField values(points.size(), Zero);

    if (chance(random, 0.3))
    {
        for (scalar& x : values)
        {
            x = random.position<scalar>(-1, 1);
        }

        return values;
    }

    const label nWaves = random.position<label>(1, 6);
    const scalar number = logUniform(random, 1, 12);

    for (label i = 0; i < nWaves; ++i)
    {
        const vector direction(unitVector(random));
        const scalar k = number*random.position<scalar>(0.7, 1.3);
        const scalar phase = twoPi*random.sample01<scalar>();

        forAll(points, p)
        {
            values[p] +=
                Foam::sin(k*(direction & points[p]) + phase)/nWaves;
        }
    }

    return values;
}

} // End namespace randomSurfaces
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wallSurface Foam::randomSurfaces::perturbedSphere(Random& random)
{
    wallSurface wall(sphere(random));
    const scalar amplitude = logUniform(random, 0.01, 0.6);
    const scalarField radii(1 + amplitude*noise(wall.points, random));

    wall.points *= radii;

    if (chance(random, 0.5))
    {
        stretch(wall, 0.03, random);
    }

    return wall;
}


// ************************************************************************* //
