/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "randomSurface.H"
#include "mathematicalConstants.H"
#include "readWallSurface.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Gives the caps of a prism along z patches of their own
static void setCaps(wallSurface& prism)
{
    const vectorField normals(prism.faceNormals());
    prism.patchNames = wordList({"wall", "bottom", "top"});

    forAll(normals, facei)
    {
        prism.patchIDs[facei] =
            mag(normals[facei].z()) < 0.5 ? 0 : normals[facei].z() < 0 ? 1 : 2;
    }
}


//- Moves points along z by a wave of x and y, more at one end than at the other
static void bend(pointField& points, Random& random)
{
    const vector wave
    (
        randomSurfaces::logUniform(random, 0.3, 3)
       *randomSurfaces::unitVector(random)
    );
    const scalar amplitude =
        randomSurfaces::logUniform(random, 0.01, 0.7)/mag(wave);
    const scalar phase =
        random.position<scalar>(0, constant::mathematical::twoPi);
    const scalar height = boundBox(points, false).max().z();
    const scalar atTop = random.position<scalar>(-0.2, 1);

    for (point& x : points)
    {
        const scalar share = 1 + (atTop - 1)*x.z()/height;
        x.z() +=
            share*amplitude
           *Foam::sin(wave.x()*x.x() + wave.y()*x.y() + phase);
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wallSurface Foam::randomSurfaces::curvedEnds
(
    Random& random,
    prismLayerControls& controls
)
{
    wallSurface prism(starPrism(random));
    setCaps(prism);
    bend(prism.points, random);
    orientWallSurface(prism, false);

    controls.surface.fluidOutside = false;
    controls.layers.patches.clear();
    for (const word end : {"bottom", "top"})
    {
        patchLayers entry;
        entry.patches = end;
        entry.isSide = true;
        controls.layers.patches.append(entry);
    }

    return prism;
}


// ************************************************************************* //
