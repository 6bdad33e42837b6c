/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "randomSurface.H"
#include "boundBox.H"
#include "readWallSurface.H"
#include "testSurfaces.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace randomSurfaces
{

//- A patch of type cyclic on a side of the box
static farPatch cyclicPatch(const direction d, const bool isSecond)
{
    static const char* names[] = {"x", "y", "z"};
    farPatch patch;
    patch.name = word(names[d]) + (isSecond ? "Second" : "First");
    patch.type = "cyclic";
    patch.sides = wordRes
    (
        1, wordRe(word(names[d]) + (isSecond ? "Max" : "Min"))
    );
    if (!isSecond)
    {
        patch.cyclic.partner = word(names[d]) + "Second";
    }

    return patch;
}


//- Moves a body to where its lower end is at a random depth below 0, or not,
//  and adds its image where it goes through 0 or the period. Returns the
//  period.
static scalar repeat(wallSurface& body, const direction d, Random& random)
{
    const boundBox bounds(body.points, false);
    const scalar width = bounds.span()[d];
    const scalar period = width*random.position<scalar>(1.05, 3);
    const scalar depth = width*random.position<scalar>(-0.5, 0.95);
    vector move(Zero);
    move[d] = -bounds.min()[d] - depth;
    body = testSurfaces::translated(body, move);
    const bool isAbove = width - depth > period;
    if (depth > 0 || isAbove)
    {
        move[d] = isAbove ? -period : period;
        body = testSurfaces::merge(body, testSurfaces::translated(body, move));
    }

    return period;
}

} // End namespace randomSurfaces
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wallSurface Foam::randomSurfaces::periodicBody
(
    const kind k,
    Random& random,
    prismLayerControls& controls
)
{
    static const label mostFaces = 300;
    prismLayerControls none;
    wallSurface body;
    do
    {
        body = makeRandomSurface(k, random, none);
    } while (body.faces.size() > mostFaces);
    const scalar size = boundBox(body.points, false).mag();
    for (point& x : body.points)
    {
        x /= size;
    }
    orientWallSurface(body, true);

    farFieldControls& far = controls.farField;
    boundBox box;
    const direction first = random.position<label>(0, 2);
    const label nPairs = random.position<label>(1, 2);
    for (direction i = 0; i < 3; ++i)
    {
        const direction d = (first + i) % 3;
        if (i < nPairs)
        {
            box.min()[d] = 0;
            box.max()[d] = repeat(body, d, random);
            far.boundary.patches.append(cyclicPatch(d, false));
            far.boundary.patches.append(cyclicPatch(d, true));
        }
        else
        {
            const boundBox bounds(body.points, false);
            box.min()[d] = bounds.min()[d] - logUniform(random, 0.3, 3);
            box.max()[d] = bounds.max()[d] + logUniform(random, 0.3, 3);
        }
    }
    controls.surface.fluidOutside = true;
    controls.surface.repair.repair = surfaceRepairControls::method::stitch;
    const scalar which = random.sample01<scalar>();
    far.type =
        which < 0.2 ? farFieldType::none
      : which < 0.4 ? farFieldType::tet
      : which < 0.6 ? farFieldType::mesh : farFieldType::hexCore;
    far.growthRate = random.position<scalar>(1.1, 1.5);
    far.maxCellSize = logUniform(random, 0.1, 1);
    far.boundary.type = farBoundaryType::box;
    far.boundary.box = box;

    return body;
}


// ************************************************************************* //
