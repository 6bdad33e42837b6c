/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "randomSurface.H"
#include "testSurfaces.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wallSurface Foam::randomSurfaces::starPrism(Random& random)
{
    using constant::mathematical::twoPi;

    const label nPoints = 2*random.position<label>(2, 7);
    const scalar jitter = random.position<scalar>(0, 0.8);
    const scalar inner = logUniform(random, 0.02, 0.9);
    List<vector2D> polygon(nPoints);

    forAll(polygon, i)
    {
        const scalar shift = jitter*random.position<scalar>(-0.5, 0.5);
        const scalar phi = twoPi*(i + shift)/nPoints;
        const scalar r =
            (i % 2 ? inner : 1)*random.position<scalar>(0.6, 1);

        polygon[i] = r*vector2D(Foam::cos(phi), Foam::sin(phi));
    }

    const scalar height = logUniform(random, 0.02, 2);
    const scalar edgeLength = logUniform(random, 0.1, 2);

    return testSurfaces::extruded(polygon, height, edgeLength);
}


// ************************************************************************* //
