/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "randomSurface.H"
#include "boundBox.H"
#include "mathematicalConstants.H"
#include "readWallSurface.H"
#include "testSurfaces.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace randomSurfaces
{

//- A body with few faces, of at most unit size, in x, y, z >= 0. Its least
//  coordinates are 0 exactly.
static wallSurface bodyAtOrigin
(
    const kind k,
    const label mostFaces,
    Random& random
)
{
    prismLayerControls none;
    wallSurface body;
    do
    {
        body = makeRandomSurface(k, random, none);
    } while (body.faces.size() > mostFaces);

    const boundBox bounds(body.points, false);
    const scalar scale = logUniform(random, 0.3, 1)/cmptMax(bounds.span());
    for (point& x : body.points)
    {
        x = scale*(x - bounds.min());
    }

    return body;
}


//- How deep a side cuts into something of a height: through it or past it, a
//  little, not at all, exactly on it, or less than 0 if there is a gap
static scalar randomDepth(const scalar height, Random& random)
{
    switch (random.position<label>(0, 5))
    {
        case 0: return 0;
        case 1: return height*logUniform(random, 1e-11, 0.02);
        case 2: return -height*logUniform(random, 1e-11, 0.01);
        case 3: return -height*logUniform(random, 1e-3, 1);
        default: return height*random.position<scalar>(0.02, 1.05);
    }
}


//- n bodies side by side along an axis, each at a depth of its own in the plane
//  where the other coordinate is 0
static wallSurface row
(
    const label n,
    const kind first,
    const direction along,
    const direction across,
    Random& random
)
{
    wallSurface bodies;
    scalar end = 0;
    for (label i = 0; i < n; ++i)
    {
        const kind other = kind(random.position<label>(0, 3));
        const wallSurface body(bodyAtOrigin(i ? other : first, 300/n, random));
        const vector span(boundBox(body.points, false).span());
        vector move(Zero);
        move[along] = end;
        move[across] = -randomDepth(span[across], random);
        const wallSurface moved(testSurfaces::translated(body, move));
        bodies = i ? testSurfaces::merge(bodies, moved) : moved;
        end += span[along] + logUniform(random, 0.02, 0.5);
    }

    return bodies;
}


//- A prism on a regular polygon of 3 to 16 corners, stretched to a leg, a plate
//  or a fin. It stands on its foot, upright along an axis.
static wallSurface leg
(
    const point& foot,
    const scalar height,
    const direction across,
    Random& random
)
{
    const label n = random.position<label>(3, 16);
    const scalar radius = logUniform(random, 0.01, 0.15);
    const scalar stretch = logUniform(random, 0.2, 5);
    List<vector2D> polygon(n);
    forAll(polygon, i)
    {
        const scalar phi = constant::mathematical::twoPi*i/n;
        polygon[i] =
            radius*vector2D(stretch*Foam::cos(phi), Foam::sin(phi));
    }

    wallSurface upright(testSurfaces::extruded(polygon, height, 2*radius));
    for (point& x : upright.points)
    {
        const point given(x);
        x[across] = given.z() + foot[across];
        for (direction d = 1; d < 3; ++d)
        {
            const direction other = (across + d) % 3;
            x[other] = given[d - 1] + foot[other];
        }
    }

    return upright;
}


//- Bodies, raised, and one to four legs, plates or fins from within their box
//  to the plane where a coordinate is 0, to near to it, or through it
static wallSurface onLegs
(
    wallSurface bodies,
    const direction across,
    Random& random
)
{
    for (point& x : bodies.points)
    {
        x[across] += 0.3;
    }
    const boundBox bounds(bodies.points, false);
    for (label n = random.position<label>(1, 4); n > 0; --n)
    {
        point foot;
        for (direction d = 0; d < 3; ++d)
        {
            foot[d] = bounds.min()[d]
              + random.position<scalar>(0.1, 0.9)*bounds.span()[d];
        }
        const scalar top = foot[across];
        foot[across] = -randomDepth(0.3, random);
        bodies = testSurfaces::merge
        (
            bodies, leg(foot, top - foot[across], across, random)
        );
    }

    return bodies;
}


//- A box around bodies, of which a lower side is at 0, and a second side is
//  near to the bodies or cuts them, too, for some
static boundBox boxAt
(
    const wallSurface& bodies,
    const direction across,
    Random& random
)
{
    const boundBox bounds(bodies.points, false);
    boundBox box(bounds);
    box.add(point::zero);
    for (direction d = 0; d < 3; ++d)
    {
        box.min()[d] -= logUniform(random, 0.3, 3);
        box.max()[d] += logUniform(random, 0.3, 3);
    }
    box.min()[across] = 0;

    const direction second = random.position<label>(0, 2);
    const scalar high =
        bounds.max()[second] - randomDepth(bounds.span()[second], random);
    if (chance(random, 0.4) && high > box.min()[second] + 0.05)
    {
        box.max()[second] = high;
    }

    return box;
}

} // End namespace randomSurfaces
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wallSurface Foam::randomSurfaces::bodiesAtSides
(
    const kind first,
    Random& random,
    prismLayerControls& controls
)
{
    const direction across = random.position<label>(0, 2);
    const direction along = (across + 1 + random.bit()) % 3;
    const bool areSeveral = first == kind::severalBodies;
    const label n = areSeveral ? 1 : random.position<label>(1, 3);
    wallSurface bodies(row(n, first, along, across, random));
    const bool haveLegs = chance(random, 0.3);
    if (haveLegs)
    {
        bodies = onLegs(bodies, across, random);
    }
    const boundBox box(boxAt(bodies, across, random));

    // The box may be upside down, of another size, and elsewhere
    vector scale(vector::one);
    vector place(Zero);
    if (chance(random, 0.3))
    {
        scale *= logUniform(random, 1e-4, 1e4);
        place = scale[0]*logUniform(random, 0.1, 100)*unitVector(random);
    }
    scale[across] *= random.bit() ? 1 : -1;
    pointField corners({box.min(), box.max()});
    for (pointField* points : {&bodies.points, &corners})
    {
        for (point& x : *points)
        {
            x = cmptMultiply(scale, x) + place;
        }
    }
    const bool isRoom =
        n == 1 && !areSeveral && !haveLegs && chance(random, 0.2);
    controls.surface.fluidOutside = !isRoom;
    orientWallSurface(bodies, controls.surface.fluidOutside);
    if (haveLegs || chance(random, 0.7))
    {
        controls.surface.repair.repair = surfaceRepairControls::method::stitch;
    }

    static const farFieldType types[] =
        {farFieldType::none, farFieldType::tet, farFieldType::hexCore};
    farFieldControls& far = controls.farField;
    far.type = types[random.position<label>(0, 2)];
    far.growthRate = random.position<scalar>(1.1, 1.5);
    far.maxCellSize = mag(scale[0])*logUniform(random, 0.1, 1);
    far.boundary.type = farBoundaryType::box;
    far.boundary.box = boundBox(corners, false);

    return bodies;
}


// ************************************************************************* //
