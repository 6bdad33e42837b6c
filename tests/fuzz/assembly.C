/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "randomSurface.H"
#include "boolList.H"
#include "mathematicalConstants.H"
#include "testSurfaces.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace randomSurfaces
{

//- Cylinder about the z axis of radius 0.5, from -0.5 to 0.5. It has points on
//  the x and y axes.
static wallSurface cylinder(Random& random)
{
    using constant::mathematical::twoPi;

    const label n = 4*random.position<label>(1, 4);
    List<vector2D> circle(n);
    forAll(circle, i)
    {
        const scalar phi = twoPi*i/n;
        circle[i] = 0.5*vector2D(Foam::cos(phi), Foam::sin(phi));
    }
    // Where it touches others, exactly
    circle[0] = vector2D(0.5, 0);
    circle[n/4] = vector2D(0, 0.5);
    circle[n/2] = vector2D(-0.5, 0);
    circle[3*n/4] = vector2D(0, -0.5);

    wallSurface wall(testSurfaces::extruded(circle, 1, 0.5));
    for (point& p : wall.points)
    {
        p.z() -= 0.5;
    }

    return wall;
}


//- A solid that fits into the unit cube about the origin and touches its sides
static wallSurface solid(Random& random)
{
    switch (random.position<label>(0, 2))
    {
        case 0:
        {
            wallSurface wall(testSurfaces::cube(random.position<label>(1, 3)));
            for (point& p : wall.points)
            {
                p -= 0.5*vector::one;
            }
            return wall;
        }
        case 1:
            return testSurfaces::sphere(2*random.position<label>(1, 3), 0.5);

        default:
        {
            wallSurface wall(cylinder(random));
            for (label k = random.position<label>(0, 2); k > 0; --k)
            {
                for (point& p : wall.points)
                {
                    p = point(p.y(), p.z(), p.x());
                }
            }
            return wall;
        }
    }
}

} // End namespace randomSurfaces
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wallSurface Foam::randomSurfaces::assembly(Random& random)
{
    const label side = 3;
    const label nSolids = random.position<label>(2, 6);
    boolList isFilled(side*side*side, false);
    wallSurface wall;

    for (label n = 0; n < nSolids;)
    {
        const label i = random.position<label>(0, isFilled.size() - 1);
        if (isFilled[i])
        {
            continue;
        }
        isFilled[i] = true;
        ++n;

        // Some are larger than their cell, and overlap
        const scalar size =
            chance(random, 0.3) ? random.position<scalar>(0.7, 1.6) : 1;
        wallSurface next(solid(random));
        for (point& p : next.points)
        {
            p = size*p + point(i/9, i/3 % 3, i % 3);
        }
        wall = n == 1 ? next : testSurfaces::merge(wall, next);
    }

    setPatch(wall);

    return wall;
}


// ************************************************************************* //
