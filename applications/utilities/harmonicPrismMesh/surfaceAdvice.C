/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceAdvice.H"
#include "planesOfBorder.H"
#include "repairSurface.H"
#include "splitAtSidePatches.H"
#include "surfaceMeasures.H"
#include "throwingErrors.H"
#include "wallDefects.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- More faces with small angles than this share are worth remeshing
static constexpr scalar fewSmallAngles = 1e-3;


//- Whether the wall that ends on these planes has no defects
static bool isMended
(
    const wallSurface& surface,
    const List<sidePatch>& planes,
    const wallSurfaceControls& controls,
    const layerControls& layers
)
{
    if (findWallDefects(surface, planes.size()).size())
    {
        return false;
    }

    wallSurfaceControls ending(controls);
    ending.sidePlanes = planes;
    const throwingErrors throwing;
    try
    {
        wallReading reading;
        const wallSurface wall
        (
            splitAtSidePatches(surface, ending, layers, reading)
        );

        return findWallDefects(wall, planes.size()).empty();
    }
    catch (const Foam::error&)
    {
        return false;
    }
}


//- Digits of coordinates in the advice: more than sideTolerance needs, wherever
//  the surface is
static constexpr int digits = 12;


//- The entries of the dictionary that make these side planes
static string entriesOf(const List<sidePatch>& planes)
{
    OStringStream os;
    os.precision(digits);
    os  << "    sidePlanes" << nl << "    {" << nl;
    for (const sidePatch& plane : planes)
    {
        os  << "        " << plane.name << " { point " << plane.origin
            << "; normal " << plane.normal << "; }" << nl;
    }
    os  << "    }";

    return os.str();
}


//- Side planes without which a surface has defects, and with which it has none;
//  none if some are given already
static List<sidePatch> planesThatMend
(
    const wallSurface& surface,
    const wallSurfaceControls& controls,
    const layerControls& layers
)
{
    if (controls.sidePlanes.size())
    {
        return List<sidePatch>();
    }

    const List<sidePatch> planes(planesOfBorder(surface));

    return isMended(surface, planes, controls, layers)
      ? planes : List<sidePatch>();
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

string adviceOnDefects
(
    const wallSurface& surface,
    const wallSurfaceControls& controls,
    const layerControls& layers
)
{
    typedef surfaceRepairControls::method method;
    wallSurfaceControls stitching(controls);
    if (stitching.repair.repair == method::wrap)
    {
        return "";
    }

    stitching.repair.repair = method::stitch;
    const repairedSurface stitched
    (
        repairSurface(surface, stitching, layers)
    );
    if (isMended(stitched.surface, stitching.sidePlanes, controls, layers))
    {
        OStringStream os;
        os  << "surface.repair stitch mends this surface. It moves faces by at"
            << " most "
            << max(stitched.distance.largest, stitched.distanceOfGiven.largest)
            << " m.";

        return os.str();
    }

    const List<sidePatch> planes(planesThatMend(surface, controls, layers));
    if (planes.size())
    {
        return "The border of the surface is on planes. With these entries the"
            " surface has no defects:\n" + entriesOf(planes);
    }

    const List<sidePatch> more
    (
        planesThatMend(stitched.surface, controls, layers)
    );
    if (more.size())
    {
        return "surface.repair stitch mends this surface, with these side"
            " planes for its border:\n" + entriesOf(more);
    }

    return "surface.repair stitch does not mend this surface. surface.repair"
        " wrap does: it makes a closed surface around all faces.";
}


string adviceOnAngles
(
    const wallSurface& surface,
    const surfaceRemeshControls& controls
)
{
    const scalar share = measuresOf(surface).shareWithSmallAngles;
    if (controls.active || share <= fewSmallAngles)
    {
        return "";
    }

    OStringStream os;
    os  << 100*share << " % of the faces have angles below "
        << surfaceMeasures::smallAngle << " degrees. They make the layers"
        << " non-orthogonal. surface.remesh makes better triangles.";

    return os.str();
}

} // End namespace Foam

// ************************************************************************* //
