/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prepareWall.H"
#include "boundBox.H"
#include "boxSides.H"
#include "OStringStream.H"
#include "planesOfBorder.H"
#include "throwingErrors.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- More faces with small angles than this share are worth remeshing
static constexpr scalar fewSmallAngles = 1e-3;

//- Digits of coordinates in the advice: more than sideTolerance needs, wherever
//  the surface is
static constexpr int digits = 12;


//- Whether a surface has no defects once it is prepared as the controls say.
//  It is not remeshed.
static bool isMended
(
    const wallSurface& surface,
    prismLayerControls controls,
    preparedWall& prepared
)
{
    controls.surface.remesh.active = false;
    const throwingErrors throwing;
    try
    {
        prepared = prepareWall(surface, controls);

        return prepared.defects.empty();
    }
    catch (const Foam::error&)
    {
        return false;
    }
}


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
//  none if it has some already.
//  like: has the border for which there are to be planes
static List<sidePatch> planesThatMend
(
    const wallSurface& surface,
    prismLayerControls controls,
    const wallSurface& like
)
{
    List<sidePatch>& planes = controls.surface.sidePlanes;
    planes = withBoxSides(surface, planes, controls.farField.boundary);
    if (planes.size() || like.faces.empty())
    {
        return List<sidePatch>();
    }

    planes = planesOfBorder(like);
    preparedWall prepared;

    return planes.size() && isMended(surface, controls, prepared)
      ? planes : List<sidePatch>();
}


//- Borders that are further than this share of the diagonal from planes have no
//  advice of planes
static constexpr scalar roughPlanes = 1e-2;


//- Planes near to which all of the border is, moved into the surface so far that
//  the border is beyond them: a repair cuts it off.
//  deviation: is set to the longest of the moves [m]
static List<sidePatch> planesInside
(
    const wallSurface& surface,
    scalar& deviation
)
{
    const scalar near = roughPlanes*boundBox(surface.points, false).mag();
    const edgeList border(outline(surface.faces));
    List<sidePatch> planes(planesOfBorder(surface, roughPlanes));
    for (sidePatch& plane : planes)
    {
        scalar least = 0;
        scalar most = 0;
        for (const edge& e : border)
        {
            const point& x = surface.points[e.start()];
            const point& y = surface.points[e.end()];
            if (plane.hasEdge(x, y, near))
            {
                least = min(least, plane.distance(x));
                most = max(most, plane.distance(x));
            }
        }

        // A little more, so that no point is in the plane
        plane.origin += (least - 0.1*(most - least))*plane.normal;
        deviation = max(deviation, most - least);
    }

    return planes;
}


//- Advice to cut off a border that is near to planes; nothing if that does not
//  mend the surface
static string adviceToCut
(
    const wallSurface& surface,
    prismLayerControls controls
)
{
    scalar deviation = 0;
    List<sidePatch>& planes = controls.surface.sidePlanes;
    if (planes.size())
    {
        return "";
    }
    planes = planesInside(surface, deviation);
    preparedWall prepared;
    if (planes.empty() || !isMended(surface, controls, prepared))
    {
        return "";
    }

    OStringStream os;
    os  << "The border of the surface deviates from planes by up to "
        << deviation << " m. surface.repair stitch cuts it off at these"
        << " planes:" << nl << entriesOf(planes).c_str();

    return os.str();
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

string adviceOnDefects
(
    const wallSurface& surface,
    const prismLayerControls& controls
)
{
    typedef surfaceRepairControls::method method;
    if (controls.surface.repair.repair == method::wrap)
    {
        return "";
    }

    prismLayerControls stitching(controls);
    stitching.surface.repair.repair = method::stitch;
    preparedWall stitched;
    if (isMended(surface, stitching, stitched))
    {
        const surfaceChange& change = stitched.repair;
        OStringStream os;
        os  << "surface.repair stitch mends this surface. It moves faces by at"
            << " most "
            << max(change.distance.largest, change.distanceOfGiven.largest)
            << " m.";

        return os.str();
    }

    const List<sidePatch> planes(planesThatMend(surface, controls, surface));
    if (planes.size())
    {
        return "The border of the surface is on planes. With these entries the"
            " surface has no defects:\n" + entriesOf(planes);
    }

    const List<sidePatch> more
    (
        planesThatMend(surface, stitching, stitched.surface)
    );
    if (more.size())
    {
        return "surface.repair stitch mends this surface, with these side"
            " planes for its border:\n" + entriesOf(more);
    }

    const string cut(adviceToCut(surface, stitching));
    if (cut.size())
    {
        return cut;
    }

    prismLayerControls wrapping(controls);
    wrapping.surface.repair.repair = method::wrap;
    preparedWall wrapped;

    return isMended(surface, wrapping, wrapped)
      ? "surface.repair stitch does not mend this surface. surface.repair wrap"
        " does: it makes a closed surface around all faces."
      : "Neither surface.repair stitch nor surface.repair wrap mends this"
        " surface, as the dictionary has them.";
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
