/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "addNeedles.H"
#include "randomSurface.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace randomSurfaces
{

//- The face on the other side of edge k of a face, -1 if there is none
static label otherFace
(
    const wallSurface& wall,
    const label facei,
    const label k
)
{
    const face& f = wall.faces[facei];

    forAll(wall.faces, i)
    {
        if (i != facei && wall.faces[i].edgeDirection(f.faceEdge(k)))
        {
            return i;
        }
    }

    return -1;
}


//- Whether a face is a triangle and not thin
static bool isWide(const wallSurface& wall, const face& f)
{
    const pointField& x = wall.points;
    const scalar longest = f.faceEdge(f.longestEdge(x)).mag(x);

    return f.size() == 3 && f.mag(x) > 1e-3*sqr(longest);
}


//- A random triangle and its edge to another one, none of which is thin; mostly
//  a sharp edge
static bool chooseEdge
(
    const wallSurface& wall,
    Random& random,
    label& facei,
    label& k,
    label& other
)
{
    for (label tries = 0; tries < 50; ++tries)
    {
        facei = random.position<label>(0, wall.faces.size() - 1);
        k = random.position<label>(0, 2);
        other = otherFace(wall, facei, k);

        if
        (
            other >= 0
         && isWide(wall, wall.faces[facei]) && isWide(wall, wall.faces[other])
        )
        {
            const vector a(wall.faces[facei].unitNormal(wall.points));
            const vector b(wall.faces[other].unitNormal(wall.points));

            if ((a & b) < 0.9 || chance(random, 0.2))
            {
                return true;
            }
        }
    }

    return false;
}


static void addNeedleFace(wallSurface& wall, const face& f, const label patchi)
{
    wall.faces.append(f);
    wall.patchIDs.append(patchi);
}


//- Divide a triangle at a point between its corners a and b
static void divide
(
    wallSurface& wall,
    const label facei,
    const label a,
    const label b,
    const label middle
)
{
    const face f(wall.faces[facei]);
    face first(f), second(f);
    first[f.find(b)] = middle;
    second[f.find(a)] = middle;
    wall.faces[facei] = first;
    const label patchi = wall.patchIDs[facei];
    addNeedleFace(wall, second, patchi);
}

} // End namespace randomSurfaces
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::randomSurfaces::addNeedles(wallSurface& wall, Random& random)
{
    label facei, k, other;

    for (label n = random.position<label>(1, 8); n > 0; --n)
    {
        if (!chooseEdge(wall, random, facei, k, other))
        {
            return;
        }

        const face f(wall.faces[facei]);
        const label a = f[k];
        const label b = f.nextLabel(k);
        const label c = f.prevLabel(k);
        const vector along(wall.points[b] - wall.points[a]);
        const vector inward(wall.points[c] - wall.points[a]);
        const scalar width = logUniform(random, 1e-7, 1e-3);
        const point off
        (
            wall.points[a] + 0.3*width*mag(along)*unitVector(random)
        );
        const label middle = wall.points.size();

        if (chance(random, 0.5))
        {
            const scalar share = random.position<scalar>(0.1, 0.9);
            wall.points.append(off + share*along + width*inward);
            wall.faces[facei] = face({a, b, middle});
            const label patchi = wall.patchIDs[facei];
            addNeedleFace(wall, face({b, c, middle}), patchi);
            addNeedleFace(wall, face({c, a, middle}), patchi);
        }
        else
        {
            wall.points.append(off + width*along);
            divide(wall, facei, a, b, middle);
            divide(wall, other, a, b, middle);
        }
    }
}


// ************************************************************************* //
