/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "splitAtSidePatches.H"
#include "openSurfaces.H"
#include "thrownMessage.H"

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static std::string errorOf
(
    const wallSurface& surface,
    const List<sidePatch>& planes,
    const layerControls& layers = layerControls()
)
{
    wallSurfaceControls controls;
    controls.sidePlanes = planes;
    wallReading reading;

    return thrownMessage<error>
    (
        [&]() { splitAtSidePatches(surface, controls, layers, reading); }
    );
}


//- The label of the point at a place
static label pointAt(const wallSurface& wall, const point& x)
{
    forAll(wall.points, p)
    {
        if (mag(wall.points[p] - x) < 1e-12)
        {
            return p;
        }
    }

    return -1;
}


static scalar sizeOf(const wallSurface& wall)
{
    return boundBox(wall.points, false).mag();
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(splitAtSidePatchesErrors, bordersFarFromTheirPlaneAreRefused)
{
    for (const scalar sign : {1.0, -1.0})
    {
        wallSurface surface(halfCube(4));
        const label p = pointAt(surface, point(0.5, 0, 0));
        ASSERT_GE(p, 0);
        surface.points[p].z() += sign*1e-3*sizeOf(surface);

        expectWords
        (
            errorOf(surface, halfPlanes()),
            {"border is further than", "2 places", "(0.375 0 ", "(0.625 0 "}
        );
    }
}


TEST(splitAtSidePatchesErrors, borderOnNoPlaneIsRefused)
{
    expectWords
    (
        errorOf
        (
            halfCube(4),
            {symmetryPlane("low", point(0, 0, -0.1), vector(0, 0, -1))}
        ),
        {"surface is open", "16 places", "(0.125 0 0)"}
    );
}


TEST(splitAtSidePatchesErrors, planeWithoutBorderIsRefused)
{
    List<sidePatch> planes(halfPlanes());
    planes.append(symmetryPlane("away", point(0, -3, 0), vector(0, -1, 0)));

    expectWords
    (
        errorOf(halfCube(4), planes),
        {"No border of the wall is on the side plane away", "(0 -3 0)"}
    );
    expectWords
    (
        errorOf(quadCube(2), halfPlanes()),
        {"No border of the wall is on the side plane bottom"}
    );
}


TEST(splitAtSidePatchesErrors, wallThatTouchesThePlaneIsRefused)
{
    // A cube that stands on the plane with 9 of its points
    const wallSurface cube(translated(quadCube(2), vector(5, 0, 0)));

    expectWords
    (
        errorOf(merge(halfCube(4), cube), halfPlanes()),
        {"wall touches the side plane bottom at 9 places", "(5 0 0)"}
    );
}


TEST(splitAtSidePatchesErrors, faceInThePlaneIsRefused)
{
    wallSurface wall(halfCube(4));
    const edge open(outline(wall.faces)[0]);
    const vector outwards(4*open.centre(wall.points));
    wall.faces.append(face({open.end(), open.start(), wall.points.size()}));
    wall.points.append(outwards);
    wall.patchIDs.append(0);

    expectWords
    (
        errorOf(wall, halfPlanes()),
        {"wall touches the side plane bottom at 1 places"}
    );
}


TEST(splitAtSidePatchesErrors, normalIntoTheFluidIsRefused)
{
    expectWords
    (
        errorOf(halfCube(4), {symmetryPlane("bottom", Zero, vector(0, 0, 1))}),
        {
            "beyond the side plane bottom", "must point out of the fluid",
            // All points but those of the border
            "41 places"
        }
    );
}


TEST(splitAtSidePatchesErrors, curvedSymmetryPlaneIsRefused)
{
    for (const word type : {"symmetryPlane", "empty"})
    {
        layerControls layers(withoutLayers({"inlet", "outlet"}));
        layers.patches[0].type = type;

        expectWords
        (
            errorOf(bulgedDuct(4), {}, layers),
            {"side patch inlet of type", type.c_str(), "is curved near ("}
        );
    }
}


TEST(splitAtSidePatchesErrors, sidePatchApartFromTheWallIsRefused)
{
    wallSurface far(translated(reversed(quadCube(2)), vector(3, 0, 0)));
    far.patchNames[0] = "inlet";

    expectWords
    (
        errorOf(merge(duct(4), far), {}, withoutLayers({"inlet", "outlet"})),
        {
            "wall does not end on the side patch inlet at (",
            "remove nSurfaceLayers 0 from layers.patches"
        }
    );
}


TEST(splitAtSidePatchesErrors, patchThatDoesNotExistIsRefused)
{
    const wordList names({"walls", "inlet", "outlet"});
    requirePatches(withoutLayers({"inlet"}), names);
    expectWords
    (
        thrownMessage<Foam::error>([&]()
        {
            requirePatches(withoutLayers({"inlet", "exit"}), names);
        }),
        {"exit", "matches no patch", "walls, inlet, outlet"}
    );
}


TEST(splitAtSidePatchesErrors, moreThanTwoSidePatchesAtAPointAreRefused)
{
    // At (0 0 0) there are one half of the bottom, which is wall, and the
    // other half, x = 0 and y = 0, which are not
    wallSurface surface(reversed(cube(1)));
    surface.patchNames = wordList({"walls", "open", "sides"});
    bool isFirst = true;
    forAll(surface.faces, facei)
    {
        const point x(surface.faces[facei].centre(surface.points));
        surface.patchIDs[facei] = x.x() == 0 || x.y() == 0 ? 2 : 0;
        if (x.z() == 0)
        {
            surface.patchIDs[facei] = isFirst ? 0 : 1;
            isFirst = false;
        }
    }

    expectWords
    (
        errorOf(surface, {}, withoutLayers({"open", "sides"})),
        {"More than two side patches meet at the point (0 0 0)"}
    );
}


// ************************************************************************* //
