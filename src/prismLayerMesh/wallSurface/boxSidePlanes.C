/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boxSidePlanes.H"
#include "endWall.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Side 0 to 5 of the box: xMin, xMax, yMin, ...
static sidePatch planeOf(const farBoundaryControls& boundary, const label side)
{
    static const char* names[] =
        {"xMin", "xMax", "yMin", "yMax", "zMin", "zMax"};

    sidePatch plane;
    plane.name = names[side];
    plane.origin = side % 2 ? boundary.box.max() : boundary.box.min();
    plane.normal[side/2] = side % 2 ? 1 : -1;

    for (const farPatch& patch : boundary.patches)
    {
        if (patch.sides.match(names[side]))
        {
            plane.name = patch.name;
            plane.type = patch.type;
        }
    }

    return plane;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

List<sidePatch> withBoxSides
(
    const wallSurface& surface,
    const List<sidePatch>& planes,
    const farBoundaryControls& boundary
)
{
    List<sidePatch> all(planes);
    if (boundary.type != "box")
    {
        return all;
    }

    const edgeList border(outline(surface.faces));
    const scalar tolerance =
        sideTolerance*boundBox(surface.points, false).mag();

    for (label side = 0; side < 6; ++side)
    {
        const sidePatch plane(planeOf(boundary, side));
        const auto isOn = [&](const point& x)
        {
            return mag((x - plane.origin) & plane.normal) <= tolerance;
        };

        const bool isGiven = std::any_of
        (
            planes.begin(), planes.end(), [&](const sidePatch& given)
            {
                return isOn(given.origin)
                    && mag(given.normal - plane.normal) < sideTolerance;
            }
        );
        const bool hasBorder = std::any_of
        (
            border.begin(), border.end(), [&](const edge& e)
            {
                return isOn(surface.points[e.start()])
                    && isOn(surface.points[e.end()]);
            }
        );

        if (hasBorder && !isGiven)
        {
            all.append(plane);
        }
    }

    return all;
}

} // End namespace Foam

// ************************************************************************* //
