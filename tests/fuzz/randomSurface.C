/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "randomSurface.H"
#include "testSurfaces.H"
#include "EdgeMap.H"
#include "mathematicalConstants.H"
#include "tensor.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace randomSurfaces
{

static const char* const names[nKinds] =
{
    "perturbedSphere", "boxUnion", "spikyPolyhedron", "starPrism",
    "severalBodies", "cutBody", "curvedEnds"
};


static wallSurface makeKind
(
    const kind k,
    Random& random,
    prismLayerControls& controls
)
{
    switch (k)
    {
        case kind::perturbedSphere: return perturbedSphere(random);
        case kind::boxUnion: return boxUnion(random);
        case kind::spikyPolyhedron: return spikyPolyhedron(random);
        case kind::starPrism: return starPrism(random);
        case kind::severalBodies: return severalBodies(random);
        case kind::cutBody: return cutBody(random, controls);
        case kind::curvedEnds: return curvedEnds(random, controls);
    }

    return wallSurface();
}

} // End namespace randomSurfaces
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

const char* Foam::randomSurfaces::name(const kind k)
{
    return names[int(k)];
}


Foam::randomSurfaces::kind Foam::randomSurfaces::kindOf(const std::string& name)
{
    for (label i = 0; i < nKinds; ++i)
    {
        if (name == names[i])
        {
            return kind(i);
        }
    }

    FatalErrorInFunction
        << "No kind of surface is named " << name << "; the kinds are";

    for (const char* valid : names)
    {
        FatalError << ' ' << valid;
    }

    FatalError << exit(FatalError);

    return kind::perturbedSphere;
}


Foam::wallSurface Foam::randomSurfaces::makeRandomSurface
(
    const kind k,
    Random& random,
    prismLayerControls& controls
)
{
    wallSurface wall(makeKind(k, random, controls));

    if (hasSides(k))
    {
        return wall;
    }

    if (chance(random, 0.5))
    {
        const tensor R(rotation(random));

        for (point& p : wall.points)
        {
            p = R & p;
        }
    }

    if (chance(random, 0.3))
    {
        const scalar unit = logUniform(random, 1e-4, 1e4);
        const scalar distance = logUniform(random, 0.1, 100);
        const vector place(distance*unitVector(random));

        for (point& p : wall.points)
        {
            p = unit*(p + place);
        }
    }

    return chance(random, 0.2) ? testSurfaces::reversed(wall) : wall;
}


Foam::scalar Foam::randomSurfaces::logUniform
(
    Random& random,
    const scalar low,
    const scalar high
)
{
    return low*Foam::pow(high/low, random.sample01<scalar>());
}


bool Foam::randomSurfaces::chance(Random& random, const scalar share)
{
    return random.sample01<scalar>() < share;
}


Foam::vector Foam::randomSurfaces::unitVector(Random& random)
{
    using constant::mathematical::twoPi;

    const scalar z = 2*random.sample01<scalar>() - 1;
    const scalar phi = twoPi*random.sample01<scalar>();
    const scalar r = Foam::sqrt(max(scalar(0), 1 - z*z));

    return vector(r*Foam::cos(phi), r*Foam::sin(phi), z);
}


Foam::tensor Foam::randomSurfaces::rotation(Random& random)
{
    const vector x(unitVector(random));
    vector y(Zero);

    while (mag(y) < 0.1)
    {
        const vector other(unitVector(random));
        y = x ^ other;
    }

    y.normalise();

    return tensor(x, y, x ^ y);
}


void Foam::randomSurfaces::setPatch(wallSurface& wall)
{
    wall.patchIDs.setSize(wall.faces.size());
    wall.patchIDs = 0;
    wall.patchNames = wordList(1, word("wall"));
}


Foam::wallSurface Foam::randomSurfaces::surfaceOf
(
    DynamicList<point>& points,
    DynamicList<face>& faces
)
{
    wallSurface surface;
    surface.points.transfer(points);
    surface.faces.transfer(faces);
    setPatch(surface);

    return surface;
}


Foam::wallSurface Foam::randomSurfaces::refined(const wallSurface& wall)
{
    DynamicList<point> points(wall.points);
    DynamicList<face> faces(4*wall.faces.size());
    EdgeMap<label> middles(2*wall.points.size());

    for (const face& f : wall.faces)
    {
        const label n = f.size();
        face inner(n);

        for (label i = 0; i < n; ++i)
        {
            const edge e(f[i], f.nextLabel(i));

            if (middles.insert(e, points.size()))
            {
                points.append(e.centre(wall.points));
            }

            inner[i] = middles[e];
        }

        if (n == 4)
        {
            point middle(Zero);
            for (const label p : f)
            {
                middle += 0.25*wall.points[p];
            }
            points.append(middle);
        }

        for (label i = 0; i < n; ++i)
        {
            face corner(n);
            corner[0] = f[i];
            corner[1] = inner[i];
            corner[n - 1] = inner[inner.rcIndex(i)];

            if (n == 4)
            {
                corner[2] = points.size() - 1;
            }

            faces.append(corner);
        }

        if (n == 3)
        {
            faces.append(inner);
        }
    }

    return surfaceOf(points, faces);
}


Foam::wallSurface Foam::randomSurfaces::randomlyCut
(
    const wallSurface& quads,
    Random& random
)
{
    wallSurface wall(quads);
    wall.faces.clear();

    for (const face& f : quads.faces)
    {
        const label k = random.bit();

        for (label j = 0; j < 2; ++j)
        {
            face t(3);
            t[0] = f[(k + 2*j) % 4];
            t[1] = f[(k + 2*j + 1) % 4];
            t[2] = f[(k + 2*j + 2) % 4];
            wall.faces.append(t);
        }
    }

    setPatch(wall);

    return wall;
}


void Foam::randomSurfaces::stretch
(
    wallSurface& wall,
    const scalar low,
    Random& random
)
{
    vector factors(1, 1, 1);
    factors.x() = logUniform(random, low, 1);
    factors.y() = logUniform(random, low, 1);

    for (point& p : wall.points)
    {
        p = cmptMultiply(p, factors);
    }
}


// ************************************************************************* //
