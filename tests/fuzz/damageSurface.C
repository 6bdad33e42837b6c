/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "damageSurface.H"
#include "boundBox.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace randomSurfaces
{

static label randomFace(const wallSurface& surface, Random& random)
{
    return random.position<label>(0, surface.faces.size() - 1);
}


static label newPoint(wallSurface& surface, const point& x)
{
    surface.points.append(x);

    return surface.points.size() - 1;
}


static void addFace(wallSurface& surface, const face& f, const label patch)
{
    surface.faces.append(f);
    surface.patchIDs.append(patch);
}


static void removeFace(wallSurface& surface, Random& random)
{
    const label last = surface.faces.size() - 1;
    const label i = randomFace(surface, random);

    if (last > 0)
    {
        surface.faces[i] = surface.faces[last];
        surface.patchIDs[i] = surface.patchIDs[last];
        surface.faces.setSize(last);
        surface.patchIDs.setSize(last);
    }
}


static void copyFace(wallSurface& surface, Random& random)
{
    const label i = randomFace(surface, random);
    face copy(surface.faces[i]);
    if (chance(random, 0.5))
    {
        copy.flip();
    }
    addFace(surface, copy, surface.patchIDs[i]);
}


//- Gives a face points of its own
static void separateFace
(
    const scalar distance,
    wallSurface& surface,
    Random& random
)
{
    face& f = surface.faces[randomFace(surface, random)];
    for (label& p : f)
    {
        const point x(surface.points[p]);
        p = newPoint(surface, x + distance*unitVector(random));
    }
}


//- Cuts a triangle in two at a point of an edge
static void cutFace(wallSurface& surface, Random& random)
{
    const label i = randomFace(surface, random);
    const face f(surface.faces[i]);
    const label middle = newPoint
    (
        surface,
        surface.points[f[0]]
      + random.sample01<scalar>()*(surface.points[f[1]] - surface.points[f[0]])
    );
    face rest(f);
    rest[0] = middle;
    surface.faces[i] = rest;
    addFace(surface, face({f[0], middle, f.last()}), surface.patchIDs[i]);
}


static void addShiftedCopy
(
    const scalar distance,
    wallSurface& surface,
    Random& random
)
{
    const label nFaces = surface.faces.size();
    const label nPoints = surface.points.size();
    const vector shift(distance*unitVector(random));

    for (label p = 0; p < nPoints; ++p)
    {
        surface.points.append(point(surface.points[p] + shift));
    }
    for (label i = 0; i < nFaces; ++i)
    {
        face f(surface.faces[i]);
        for (label& p : f)
        {
            p += nPoints;
        }
        addFace(surface, f, surface.patchIDs[i]);
    }
}

} // End namespace randomSurfaces
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::randomSurfaces::damage(wallSurface& surface, Random& random)
{
    const scalar size = boundBox(surface.points, false).mag();
    const auto times = [&](const scalar share)
    {
        return chance(random, share) ? random.position<label>(1, 5) : label(0);
    };

    if (chance(random, 0.2))
    {
        addShiftedCopy(logUniform(random, 0.01, 0.7)*size, surface, random);
    }
    for (label n = times(0.4); n > 0; --n)
    {
        removeFace(surface, random);
    }
    for (label n = times(0.4); n > 0; --n)
    {
        copyFace(surface, random);
    }
    for (label n = times(0.4); n > 0; --n)
    {
        surface.faces[randomFace(surface, random)].flip();
    }
    for (label n = times(0.4); n > 0; --n)
    {
        separateFace(logUniform(random, 1e-12, 1e-3)*size, surface, random);
    }
    for (label n = times(0.4); n > 0; --n)
    {
        cutFace(surface, random);
    }
    for (label n = times(0.2); n > 0; --n)
    {
        const label p = random.position<label>(0, surface.points.size() - 1);
        surface.points[p] +=
            logUniform(random, 1e-3, 0.5)*size*unitVector(random);
    }
}


// ************************************************************************* //
