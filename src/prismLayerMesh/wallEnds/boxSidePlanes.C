/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boxSidePlanes.H"
#include "ranges.H"
#include "splitAtSidePatches.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The side planes of a far boundary that is a box, with the names and types of
//  their patches
static List<sidePatch> sidesOf(const farBoundaryControls& boundary)
{
    List<sidePatch> planes(sidesOf(boundary.box));

    for (sidePatch& plane : planes)
    {
        const word side(plane.name);
        for (const farPatch& patch : boundary.patches)
        {
            if (patch.sides.match(side))
            {
                plane.name = patch.name;
                plane.type = patch.type;
            }
        }
    }

    return planes;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

List<sidePatch> sidesOf(const boundBox& box)
{
    static const char* names[] =
        {"xMin", "xMax", "yMin", "yMax", "zMin", "zMax"};

    List<sidePatch> planes(6);
    forAll(planes, side)
    {
        planes[side].name = names[side];
        planes[side].origin = side % 2 ? box.max() : box.min();
        planes[side].normal[side/2] = side % 2 ? 1 : -1;
    }

    return planes;
}


List<sidePatch> withBoxSides
(
    const wallSurface& surface,
    const List<sidePatch>& planes,
    const farBoundaryControls& boundary
)
{
    List<sidePatch> all(planes);
    if (boundary.type != farBoundaryType::box)
    {
        return all;
    }

    const edgeList border(outline(surface.faces));
    const scalar tolerance =
        sideTolerance*boundBox(surface.points, false).mag();

    for (const sidePatch& plane : sidesOf(boundary))
    {
        const auto isOn = [&](const point& x)
        {
            return mag((x - plane.origin) & plane.normal) <= tolerance;
        };

        const bool isGiven = anyOf(planes, [&](const sidePatch& given)
        {
            return isOn(given.origin)
                && mag(given.normal - plane.normal) < sideTolerance;
        });
        const bool hasBorder = anyOf(border, [&](const edge& e)
        {
            return isOn(surface.points[e.start()])
                && isOn(surface.points[e.end()]);
        });

        if (hasBorder && !isGiven)
        {
            all.append(plane);
        }
    }

    return all;
}

} // End namespace Foam

// ************************************************************************* //
