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


namespace
{

//- Tries to prepare a surface in several ways, without remeshing it
struct trials
{
    const wallSurface& surface;
    const stageObserver& observer;

    //- Whether the surface has no defects once it is prepared as the controls
    //  say
    bool succeed
    (
        const char* what,
        prismLayerControls controls,
        preparedWall& prepared
    ) const
    {
        observer.begin(word("trial"));
        controls.surface.remesh.active = false;
        const throwingErrors throwing;
        bool isMended = false;
        try
        {
            prepared = prepareWall(surface, controls);
            isMended = prepared.defects.empty();
        }
        catch (const Foam::error&)
        {}
        observer.end(string(what) + (isMended ? " mends" : " does not mend"));

        return isMended;
    }
};

} // End anonymous namespace


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


//- Side planes without which a surface has defects and with which it has none.
//  Returns none if it has some already.
//  like: has the border for which there are to be planes
static List<sidePatch> planesThatMend
(
    const trials& trial,
    const char* what,
    prismLayerControls controls,
    const wallSurface& like
)
{
    List<sidePatch>& planes = controls.surface.sidePlanes;
    planes = withBoxSides(trial.surface, planes, controls.farField.boundary);
    if (planes.size() || like.faces.empty())
    {
        return List<sidePatch>();
    }

    planes = planesOfBorder(like);
    preparedWall prepared;

    return planes.size() && trial.succeed(what, controls, prepared)
      ? planes : List<sidePatch>();
}


//- Borders that are further than this share of the diagonal from planes have no
//  advice of planes
static constexpr scalar roughPlanes = 1e-2;


//- Planes near to which all of the border is, moved into the surface so far
//  that the border is beyond them: a repair cuts it off.
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
static string adviceToCut(const trials& trial, prismLayerControls controls)
{
    scalar deviation = 0;
    List<sidePatch>& planes = controls.surface.sidePlanes;
    if (planes.size())
    {
        return "";
    }
    planes = planesInside(trial.surface, deviation);
    preparedWall prepared;
    if
    (
        planes.empty()
     || !trial.succeed("a cut at planes", controls, prepared)
    )
    {
        return "";
    }

    OStringStream os;
    os  << "The border of the surface deviates from planes by up to "
        << deviation << " m. surface.repair stitch cuts it off at these"
        << " planes:" << nl << entriesOf(planes).c_str();

    return os.str();
}


//- By how far a repair has moved faces [m]
static scalar moveOf(const preparedWall& prepared)
{
    const surfaceChange& change = prepared.repair;

    return max(change.distance.largest, change.distanceOfGiven.largest);
}


//- What a repair would change
static string textOfChange(const preparedWall& prepared)
{
    OStringStream os;
    os  << "It moves faces by at most " << moveOf(prepared) << " m:";
    for (const repairStep& step : prepared.steps)
    {
        os  << nl << "    " << step.what.c_str() << ' ' << step.count;
        if (step.places.size())
        {
            os  << ", at " << step.places[0];
        }
    }

    return os.str();
}


//- Gaps that are tried, as shares of the diagonal; the default is 1e-4. Curves
//  that were sampled twice have gaps of the height of their arcs over chords.
static constexpr scalar widerGaps[] = {3e-4, 1e-3, 3e-3};


//- Wider gaps are advised if they move faces by less than this share
static constexpr scalar bentShare = 0.5;


//- The gap that stitch closes [m]
static scalar gapOf
(
    const wallSurface& surface,
    const prismLayerControls& controls
)
{
    const scalar gap = controls.surface.repair.gap;

    return gap > 0 ? gap : 1e-4*boundBox(surface.points, false).mag();
}


//- Advice to stitch wider gaps; nothing if that does not mend the surface, or
//  moves faces by a length [m] or more
static string adviceToStitchWider
(
    const trials& trial,
    prismLayerControls controls,
    const scalar length
)
{
    const scalar diagonal = boundBox(trial.surface.points, false).mag();
    scalar& gap = controls.surface.repair.gap;
    const scalar given = gap;
    for (const scalar share : widerGaps)
    {
        OStringStream entry;
        entry.precision(2);
        entry<< share*diagonal;
        gap = ::atof(entry.str().c_str());
        preparedWall prepared;
        const string what("surface.repair stitch, gap " + entry.str());
        if
        (
            gap > given && trial.succeed(what.c_str(), controls, prepared)
         && moveOf(prepared) < length
        )
        {
            return
                "surface.repair stitch mends this surface if it closes wider"
                " gaps:\n    surface { repair stitch; stitchCoeffs { gap "
              + entry.str() + "; } }\n" + textOfChange(prepared);
        }
    }

    return "";
}


//- Advice to stitch a surface that stitch mends, with a wider gap if the
//  surface is then bent less
static string adviceToStitch
(
    const trials& trial,
    const prismLayerControls& controls,
    const preparedWall& stitched
)
{
    const scalar move = moveOf(stitched);
    string wider;
    if (move > gapOf(trial.surface, controls))
    {
        wider = adviceToStitchWider(trial, controls, bentShare*move);
    }

    return
        wider.size() ? wider
      : string
        (
            "surface.repair stitch mends this surface. "
          + textOfChange(stitched)
        );
}


static string adviceToWrap(const trials& trial, prismLayerControls controls)
{
    controls.surface.repair.repair = surfaceRepairControls::method::wrap;
    preparedWall wrapped;

    return trial.succeed("surface.repair wrap", controls, wrapped)
      ? "surface.repair stitch does not mend this surface. surface.repair wrap"
        " does: it makes a closed surface around all faces."
      : "Neither surface.repair stitch nor surface.repair wrap mends this"
        " surface, as the dictionary has them.";
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

string adviceOnDefects
(
    const wallSurface& surface,
    const prismLayerControls& controls,
    const stageObserver& observer
)
{
    typedef surfaceRepairControls::method method;
    if (controls.surface.repair.repair == method::wrap)
    {
        return "";
    }

    const trials trial{surface, observer};
    prismLayerControls stitching(controls);
    stitching.surface.repair.repair = method::stitch;
    preparedWall stitched;
    if (trial.succeed("surface.repair stitch", stitching, stitched))
    {
        return adviceToStitch(trial, stitching, stitched);
    }

    const List<sidePatch> planes
    (
        planesThatMend(trial, "surface.sidePlanes", controls, surface)
    );
    if (planes.size())
    {
        return "The border of the surface is on planes. With these entries the"
            " surface has no defects:\n" + entriesOf(planes);
    }

    const List<sidePatch> more
    (
        planesThatMend
        (
            trial, "surface.sidePlanes with stitch", stitching,
            stitched.surface
        )
    );
    if (more.size())
    {
        return "surface.repair stitch mends this surface, with these side"
            " planes for its border:\n" + entriesOf(more);
    }

    const string cut(adviceToCut(trial, stitching));
    const string wider
    (
        cut.empty()
      ? adviceToStitchWider(trial, stitching, GREAT) : string()
    );

    return
        cut.size() ? cut : wider.size() ? wider : adviceToWrap(trial, controls);
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
