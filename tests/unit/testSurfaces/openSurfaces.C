/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "openSurfaces.H"
#include "cyclicSides.H"
#include "mathematicalConstants.H"
#include "surfacePart.H"
#include "splitAtSidePatches.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

wallSurface testSurfaces::beyond
(
    const wallSurface& surface,
    const direction d,
    const scalar value
)
{
    wallSurface part;
    part.points = surface.points;
    part.patchNames = surface.patchNames;

    forAll(surface.faces, facei)
    {
        const face& f = surface.faces[facei];

        if (f.centre(surface.points)[d] > value)
        {
            part.faces.append(f);
            part.patchIDs.append(surface.patchIDs[facei]);
        }
    }

    removeUnusedPoints(part.faces, part.points);

    return part;
}


wallSurface testSurfaces::halfCube(const label n)
{
    return beyond(translated(quadCube(n), vector(0, 0, -0.5)), vector::Z, 0);
}


wallSurface testSurfaces::quarterCube(const label n)
{
    return beyond(translated(halfCube(n), vector(0, -0.5, 0)), vector::Y, 0);
}


wallSurface testSurfaces::halfSphere(const label n)
{
    return beyond(sphere(n), vector::Z, 0);
}


wallSurface testSurfaces::duct(const label n)
{
    wallSurface surface(reversed(quadCube(n)));
    surface.patchNames = wordList({"walls", "inlet", "outlet"});

    forAll(surface.faces, facei)
    {
        const scalar x = surface.faces[facei].centre(surface.points).x();
        surface.patchIDs[facei] = x < SMALL ? 1 : x > 1 - SMALL ? 2 : 0;
    }

    return surface;
}


wallSurface testSurfaces::halfOf(const wallSurface& duct)
{
    wallSurfaceControls controls;
    controls.fluidOutside = false;
    controls.sidePlanes = List<sidePatch>
    (
        1, symmetryPlane("middle", point(0, 0.5, 0), vector(0, -1, 0))
    );
    wallReading reading;

    return splitAtSidePatches
    (
        beyond(duct, vector::Y, 0.5), controls,
        withoutLayers({"inlet", "outlet"}), reading
    );
}


wallSurface testSurfaces::bulgedDuct(const label n)
{
    wallSurface surface(duct(n));

    for (point& x : surface.points)
    {
        x.x() += (1 - x.x())*bulgeAt(x);
    }

    labelList triangleFace;
    surface.faces = faceList(wallTriangles(surface, triangleFace));
    surface.patchIDs =
        labelList(UIndirectList<label>(surface.patchIDs, triangleFace)());

    return surface;
}


scalar testSurfaces::bulgeAt(const point& x)
{
    return 0.4*(sqr(x.y() - 0.5) + sqr(x.z() - 0.5)) - 0.2;
}


wallSurface testSurfaces::vessel()
{
    List<vector2D> polygon(96);
    forAll(polygon, i)
    {
        const scalar angle = constant::mathematical::twoPi*i/polygon.size();
        polygon[i] = vector2D(::cos(angle), ::sin(angle));
    }

    wallSurface surface(reversed(extruded(polygon, 1, 0.2)));
    surface.patchNames = wordList({"bottom", "around", "top"});
    forAll(surface.faces, facei)
    {
        const vector n(surface.faces[facei].unitNormal(surface.points));
        surface.patchIDs[facei] = 1 - label(::round(n.z()));
    }

    // No edge around is upright
    for (point& x : surface.points)
    {
        const scalar turn = 0.1*x.z();
        x = point
        (
            ::cos(turn)*x.x() - ::sin(turn)*x.y(),
            ::sin(turn)*x.x() + ::cos(turn)*x.y(),
            x.z()
        );
    }

    return surface;
}


wallSurface testSurfaces::sheet(const label n, const scalar height)
{
    wallSurface top(beyond(quadCube(n), vector::Z, 1 - 0.1/n));

    for (point& x : top.points)
    {
        x.z() = height;
    }

    return top;
}


wallSurface testSurfaces::waves(const label n)
{
    using constant::mathematical::twoPi;

    wallSurface wall(triangulated(sheet(n, 0)));
    for (point& x : wall.points)
    {
        x.z() = 0.1*::sin(twoPi*x.x() + 0.7)*::cos(twoPi*x.y() + 0.3);
    }

    return wall;
}


List<sidePatch> testSurfaces::cyclicPlanes()
{
    List<sidePatch> planes(4);
    const char* names[] = {"left", "right", "front", "back"};
    forAll(planes, i)
    {
        planes[i].name = names[i];
        planes[i].type = "cyclic";
        planes[i].normal[i/2] = i % 2 ? 1 : -1;
        planes[i].origin[i/2] = i % 2;
    }
    planes[0].cyclic.partner = "right";
    planes[2].cyclic.partner = "back";

    return planes;
}


wallSurface testSurfaces::periodicWaves(const label n)
{
    wallSurface wall(endedOn(waves(n), cyclicPlanes()));
    alignCyclicSides(wall, 1e-6);

    return wall;
}


wallSurface testSurfaces::unequalTriangles()
{
    wallSurface wall;
    wall.points = pointField
    ({{0, 0, 0}, {1, 0, 0}, {0.5, 0.1, 0}, {6, -0.1, 0}});
    wall.faces = {face({0, 1, 2}), face({0, 3, 1})};
    wall.patchIDs = labelList(2, Zero);
    wall.patchNames = {"wall"};

    return wall;
}


sidePatch testSurfaces::symmetryPlane
(
    const word& name,
    const point& origin,
    const vector& n
)
{
    sidePatch plane;
    plane.name = name;
    plane.type = "symmetryPlane";
    plane.origin = origin;
    plane.normal = n;

    return plane;
}


List<sidePatch> testSurfaces::halfPlanes()
{
    return List<sidePatch>(1, symmetryPlane("bottom", Zero, vector(0, 0, -1)));
}


List<sidePatch> testSurfaces::quarterPlanes()
{
    List<sidePatch> planes(halfPlanes());
    planes.append(symmetryPlane("side", Zero, vector(0, -1, 0)));

    return planes;
}


layerControls testSurfaces::withoutLayers(const wordList& patches)
{
    layerControls layers;

    for (const word& name : patches)
    {
        patchLayers entry;
        entry.patches = name;
        entry.isSide = true;
        layers.patches.append(entry);
    }

    return layers;
}


wallSurface testSurfaces::endedOn
(
    const wallSurface& surface,
    const List<sidePatch>& planes,
    const bool fluidOutside
)
{
    wallSurfaceControls controls;
    controls.sidePlanes = planes;
    controls.fluidOutside = fluidOutside;
    wallReading reading;

    return splitAtSidePatches(surface, controls, layerControls(), reading);
}


wallSurface testSurfaces::endedOn
(
    const wallSurface& surface,
    const wordList& patches
)
{
    wallReading reading;

    return splitAtSidePatches
    (
        surface, wallSurfaceControls(), withoutLayers(patches), reading
    );
}


label testSurfaces::nEdgesOn(const wallBorder& border, const label side)
{
    label n = 0;

    for (const label s : border.edgeSides)
    {
        n += s == side;
    }

    return n;
}


scalar testSurfaces::volumeTo
(
    const wallSurface& wall,
    const point& onAllPlanes
)
{
    // Seen from there the planes bound nothing
    return testSurfaces::enclosedVolume(translated(wall, -onAllPlanes));
}

} // End namespace Foam

// ************************************************************************* //
