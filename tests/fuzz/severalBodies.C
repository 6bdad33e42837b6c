/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "randomSurface.H"
#include "testSurfaces.H"
#include "boundBox.H"
#include "wallDefects.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace randomSurfaces
{

//- A small one of the other kinds, centred on the origin
static wallSurface oneBody(Random& random)
{
    static const label mostFaces = 300;
    wallSurface wall;

    do
    {
        switch (random.position<label>(0, 3))
        {
            case 0: wall = perturbedSphere(random); break;
            case 1: wall = boxUnion(random); break;
            case 2: wall = spikyPolyhedron(random); break;
            default: wall = starPrism(random); break;
        }
    } while (wall.faces.size() > mostFaces);

    const tensor R(rotation(random));
    const scalar size = logUniform(random, 0.3, 1);
    const boundBox bounds(wall.points, false);

    for (point& p : wall.points)
    {
        p = size/bounds.mag()*(R & (p - bounds.centre()));
    }

    return wall;
}


//- Both, the second moved to the first along direction until they would touch,
//  and back by gap
static wallSurface joined
(
    const wallSurface& a,
    const wallSurface& b,
    const vector& direction,
    const scalar gap
)
{
    // Apart, and together
    scalar far = 2*boundBox(a.points, false).mag() + 1;
    scalar near = 0;

    while (far - near > 0.1*gap)
    {
        const scalar x = 0.5*(near + far);
        const wallSurface both
        (
            testSurfaces::merge(a, testSurfaces::translated(b, x*direction))
        );
        (findWallDefects(both).empty() ? far : near) = x;
    }

    return testSurfaces::merge
    (
        a, testSurfaces::translated(b, (far + gap)*direction)
    );
}

} // End namespace randomSurfaces
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wallSurface Foam::randomSurfaces::severalBodies(Random& random)
{
    wallSurface wall(oneBody(random));
    const label nOthers = random.position<label>(1, 2);

    for (label i = 0; i < nOthers; ++i)
    {
        const wallSurface body(oneBody(random));
        const vector direction(unitVector(random));
        const scalar gap = logUniform(random, 1e-4, 0.3);
        wall = joined(wall, body, direction, gap);
    }

    return wall;
}


// ************************************************************************* //
