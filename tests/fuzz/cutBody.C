/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "randomSurface.H"
#include "boundBox.H"
#include "cutSurface.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace randomSurfaces
{

//- Cuts off what is beyond a plane. Points nearer to it than the tolerance [m]
//  are put there.
static void cut
(
    wallSurface& surface,
    const sidePatch& plane,
    const scalar tolerance
)
{
    scalarField distances(distancesTo(plane, surface.points));

    forAll(distances, p)
    {
        if (mag(distances[p]) < tolerance)
        {
            surface.points[p] -= distances[p]*plane.normal;
            distances[p] = 0;
        }
    }

    cutOff(surface, plane, distances);
}


//- A plane through the middle half of a surface
static sidePatch randomPlane
(
    const wallSurface& surface,
    const bool alongAxis,
    Random& random
)
{
    const boundBox box(surface.points, false);
    sidePatch plane;
    plane.name = "plane";
    if (alongAxis)
    {
        plane.normal[random.position<label>(0, 2)] = random.bit() ? 1 : -1;
    }
    else
    {
        plane.normal = unitVector(random);
    }
    plane.origin =
        box.centre()
      + random.position<scalar>(-0.25, 0.25)*box.minDim()*plane.normal;

    return plane;
}

} // End namespace randomSurfaces
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wallSurface Foam::randomSurfaces::cutBody
(
    Random& random,
    prismLayerControls& controls,
    const bool alongAxes
)
{
    const kind whole = kind
    (
        random.position<label>(0, label(kind::cutBody) - 1)
    );
    wallSurface surface(makeRandomSurface(whole, random, controls));
    const bool fluidInside = chance(random, 0.5);
    const label nPlanes = chance(random, 0.3) ? 2 : 1;
    const scalar size = boundBox(surface.points, false).mag();
    controls.surface.sidePlanes.clear();

    for (label i = 0; i < nPlanes; ++i)
    {
        const scalar tolerance = size*logUniform(random, 1e-5, 1e-3);
        sidePatch plane(randomPlane(surface, alongAxes, random));
        plane.name += Foam::name(i);
        cut(surface, plane, tolerance);
        controls.surface.sidePlanes.append(plane);
    }

    controls.surface.fluidOutside = !fluidInside;

    return surface;
}


// ************************************************************************* //
