/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "testSurfaces.H"
#include "mathematicalConstants.H"
#include "labelVector.H"
#include "unitConversion.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace testSurfaces
{

//- One patch for all faces
static void setPatch(wallSurface& wall)
{
    wall.patchIDs.setSize(wall.faces.size());
    wall.patchIDs = 0;
    wall.patchNames = wordList(1, word("wall"));
}


//- The surface of the lattice [0, n]^3, points with integer coordinates
static wallSurface lattice(const label n)
{
    const label m = n + 1;
    labelList pointOf(m*m*m, -1);
    DynamicList<point> points(6*n*n + 2);
    wallSurface wall;
    wall.faces.setSize(6*n*n);

    auto pointLabel = [&](const labelVector& v)
    {
        label& p = pointOf[(v.z()*m + v.y())*m + v.x()];

        if (p < 0)
        {
            p = points.size();
            points.append(point(v.x(), v.y(), v.z()));
        }

        return p;
    };

    label facei = 0;
    for (direction d = 0; d < 3; ++d)
    {
        for (label side = 0; side < 2; ++side)
        {
            for (label i = 0; i < n; ++i)
            {
                for (label j = 0; j < n; ++j)
                {
                    labelVector a(0, 0, 0), du(0, 0, 0), dv(0, 0, 0);
                    a[d] = side*n;
                    a[(d + 1) % 3] = i;
                    a[(d + 2) % 3] = j;
                    du[(d + 2 - side) % 3] = 1;
                    dv[(d + 1 + side) % 3] = 1;

                    face& f = wall.faces[facei++];
                    f.setSize(4);
                    f[0] = pointLabel(a);
                    f[1] = pointLabel(a + du);
                    f[2] = pointLabel(a + du + dv);
                    f[3] = pointLabel(a + dv);
                }
            }
        }
    }

    wall.points.transfer(points);
    setPatch(wall);

    return wall;
}

} // End namespace testSurfaces
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wallSurface Foam::testSurfaces::quadCube(const label n, const scalar size)
{
    wallSurface wall(lattice(n));

    for (point& p : wall.points)
    {
        p *= size/n;
    }

    return wall;
}


Foam::wallSurface Foam::testSurfaces::cube(const label n, const scalar size)
{
    return triangulated(quadCube(n, size));
}


Foam::wallSurface Foam::testSurfaces::quadSphere
(
    const label n,
    const scalar radius
)
{
    using constant::mathematical::pi;

    wallSurface wall(lattice(n));

    for (point& p : wall.points)
    {
        // Equal angles on each side of the cube make squares of like size
        for (scalar& x : p)
        {
            x = Foam::tan(0.25*pi*(2*x/n - 1));
        }

        p *= radius/mag(p);
    }

    return wall;
}


Foam::wallSurface Foam::testSurfaces::sphere(const label n, const scalar radius)
{
    return triangulated(quadSphere(n, radius));
}


Foam::wallSurface Foam::testSurfaces::torus
(
    const label nMajor,
    const label nMinor,
    const scalar R,
    const scalar r
)
{
    using constant::mathematical::twoPi;

    wallSurface wall;
    wall.points.setSize(nMajor*nMinor);
    wall.faces.setSize(nMajor*nMinor);

    for (label i = 0; i < nMajor; ++i)
    {
        for (label j = 0; j < nMinor; ++j)
        {
            const scalar phi = twoPi*i/nMajor;
            const scalar theta = twoPi*j/nMinor;
            const scalar rho = R + r*Foam::cos(theta);
            const label i1 = (i + 1) % nMajor;
            const label j1 = (j + 1) % nMinor;

            wall.points[i*nMinor + j] =
                point
                (
                    rho*Foam::cos(phi),
                    rho*Foam::sin(phi),
                    r*Foam::sin(theta)
                );

            face& f = wall.faces[i*nMinor + j];
            f.setSize(4);
            f[0] = i*nMinor + j;
            f[1] = i1*nMinor + j;
            f[2] = i1*nMinor + j1;
            f[3] = i*nMinor + j1;
        }
    }

    setPatch(wall);

    return triangulated(wall);
}


Foam::wallSurface Foam::testSurfaces::lBlock(const label n)
{
    List<vector2D> polygon(6);
    polygon[0] = vector2D(0, 0);
    polygon[1] = vector2D(2, 0);
    polygon[2] = vector2D(2, 1);
    polygon[3] = vector2D(1, 1);
    polygon[4] = vector2D(1, 2);
    polygon[5] = vector2D(0, 2);

    return extruded(polygon, 1, 1.0/n);
}


Foam::wallSurface Foam::testSurfaces::wedgeBlock
(
    const label n,
    const scalar angleInDegrees
)
{
    const scalar half = Foam::tan(0.5*degToRad(angleInDegrees));

    List<vector2D> polygon(7);
    polygon[0] = vector2D(0, 0);
    polygon[1] = vector2D(2, 0);
    polygon[2] = vector2D(2, 2);
    polygon[3] = vector2D(1 + half, 2);
    polygon[4] = vector2D(1, 1);
    polygon[5] = vector2D(1 - half, 2);
    polygon[6] = vector2D(0, 2);

    return extruded(polygon, 1, 1.0/n);
}


Foam::wallSurface Foam::testSurfaces::slitBlock
(
    const label n,
    const scalar width
)
{
    List<vector2D> polygon(8);
    polygon[0] = vector2D(0, 0);
    polygon[1] = vector2D(2, 0);
    polygon[2] = vector2D(2, 2);
    polygon[3] = vector2D(1 + 0.5*width, 2);
    polygon[4] = vector2D(1 + 0.5*width, 1);
    polygon[5] = vector2D(1 - 0.5*width, 1);
    polygon[6] = vector2D(1 - 0.5*width, 2);
    polygon[7] = vector2D(0, 2);

    return extruded(polygon, 1, 1.0/n);
}


Foam::wallSurface Foam::testSurfaces::merge
(
    const wallSurface& a,
    const wallSurface& b
)
{
    wallSurface wall(a);
    wall.points.append(b.points);
    wall.faces.append(b.faces);
    wall.patchIDs.append(b.patchIDs);

    for (label i = a.faces.size(); i < wall.faces.size(); ++i)
    {
        for (label& p : wall.faces[i])
        {
            p += a.points.size();
        }

        const word& name = b.patchNames[wall.patchIDs[i]];
        label patchi = wall.patchNames.find(name);

        if (patchi < 0)
        {
            patchi = wall.patchNames.size();
            wall.patchNames.append(name);
        }

        wall.patchIDs[i] = patchi;
    }

    return wall;
}


Foam::wallSurface Foam::testSurfaces::translated
(
    const wallSurface& wall,
    const vector& by
)
{
    wallSurface moved(wall);
    moved.points += by;

    return moved;
}


Foam::wallSurface Foam::testSurfaces::reversed(const wallSurface& wall)
{
    wallSurface turned(wall);

    for (face& f : turned.faces)
    {
        f.flip();
    }

    return turned;
}


Foam::wallSurface Foam::testSurfaces::triangulated(const wallSurface& quads)
{
    const pointField& p = quads.points;
    wallSurface wall;
    wall.points = p;
    wall.faces.setSize(2*quads.faces.size());

    forAll(quads.faces, i)
    {
        const face& f = quads.faces[i];
        const label k = mag(p[f[3]] - p[f[1]]) < mag(p[f[2]] - p[f[0]]);

        for (label j = 0; j < 2; ++j)
        {
            face& t = wall.faces[2*i + j];
            t.setSize(3);
            t[0] = f[(k + 2*j) % 4];
            t[1] = f[(k + 2*j + 1) % 4];
            t[2] = f[(k + 2*j + 2) % 4];
        }
    }

    setPatch(wall);

    return wall;
}


Foam::scalar Foam::testSurfaces::enclosedVolume(const wallSurface& wall)
{
    const pointField& p = wall.points;
    scalar volume = 0;

    for (const face& f : wall.faces)
    {
        for (label i = 1; i < f.size() - 1; ++i)
        {
            volume += (p[f[0]] ^ p[f[i]]) & p[f[i + 1]];
        }
    }

    return volume/6;
}


bool Foam::testSurfaces::isClosed(const wallSurface& wall)
{
    DynamicList<labelPair> forward, backward;

    for (const face& f : wall.faces)
    {
        forAll(f, i)
        {
            forward.append(labelPair(f[i], f[f.fcIndex(i)]));
            backward.append(labelPair(f[f.fcIndex(i)], f[i]));
        }
    }

    std::sort(forward.begin(), forward.end());
    std::sort(backward.begin(), backward.end());

    return
        forward == backward
     && std::adjacent_find(forward.begin(), forward.end()) == forward.end();
}


Foam::label Foam::testSurfaces::eulerCharacteristic(const wallSurface& wall)
{
    label nSides = 0;

    for (const face& f : wall.faces)
    {
        nSides += f.size();
    }

    return wall.points.size() - nSides/2 + wall.faces.size();
}


// ************************************************************************* //
