/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prepareSurface.H"
#include "boundBox.H"
#include "cutSurface.H"
#include "remeshSurface.H"
#include "replacedFiles.H"
#include "repairSurface.H"
#include "splitAtSidePatches.H"
#include "surfaceMeasures.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static void log(const char* which, const surfaceMeasures& measures)
{
    Info<< "    " << which << ": area " << measures.area << " m2";
    if (measures.volume > 0)
    {
        Info<< ", volume " << measures.volume << " m3";
    }
    Info<< ", smallest angle " << measures.smallestAngle
        << ", faces with angles below " << surfaceMeasures::smallAngle << ": "
        << 100*measures.shareWithSmallAngles << " %" << nl;
}


static void log(const char* which, const surfaceDistance& distance)
{
    Info<< "    distance from the " << which << " surface: "
        << distance.largest << " m at most, at " << distance.place << ", mean "
        << distance.mean << " m" << nl;
}


static dictionary toDictionary(const surfaceDistance& distance)
{
    dictionary dict;
    dict.add("max", distance.largest);
    dict.add("mean", distance.mean);
    dict.add("place", distance.place);

    return dict;
}


//- Logs the measures of a surface. Returns its entries in the report.
static dictionary measure(const char* which, const wallSurface& surface)
{
    const surfaceMeasures measures(measuresOf(surface));
    log(which, measures);

    dictionary dict;
    dict.add("faces", surface.faces.size());
    dict.add("area", measures.area);
    if (measures.volume > 0)
    {
        dict.add("volume", measures.volume);
    }
    dict.add
    (
        "smallestAngle", toDictionary(makePercentiles(smallestAngles(surface)))
    );
    dict.add("below15DegreesPercent", 100*measures.shareWithSmallAngles);

    return dict;
}


//- Logs how far the surface, repaired or remeshed, is from the one given, and
//  what both are like. Returns that as entries of the report.
template<class Changed>
static dictionary compare(const wallSurface& given, const Changed& changed)
{
    log("new surface to the given", changed.distance);
    log("given surface to the new", changed.distanceOfGiven);

    dictionary dict;
    dict.add("distanceFromGiven", toDictionary(changed.distance));
    dict.add("distanceOfGiven", toDictionary(changed.distanceOfGiven));
    dict.add("before", measure("before", given));
    dict.add("now", measure("now", changed.surface));
    Info<< flush;

    return dict;
}


//- Logs what is poor away from features. Returns its entries in the report.
static dictionary measure(const remeshedSurface& remeshed)
{
    const remeshQuality& quality = remeshed.quality;
    const scalar percent =
        100.0*quality.nSmallAngles/remeshed.surface.faces.size();
    Info<< "    away from features: faces with angles below "
        << surfaceMeasures::smallAngle << ": " << percent << " %, edges beyond "
        << remeshQuality::nonOrtho << " degrees of non-orthogonality: "
        << quality.nNonOrtho << nl << flush;

    dictionary dict;
    dict.add("below15DegreesPercent", percent);
    dict.add("edgesBeyond70Degrees", quality.nNonOrtho);

    return dict;
}


//- Logs what was done. Returns the entries of the report for it: step0, ...
static dictionary logSteps(const repairSteps& steps)
{
    dictionary dict;

    for (const repairStep& step : steps)
    {
        Info<< "    " << step.what.c_str() << ' ' << step.count;
        dictionary entry;
        entry.add("what", step.what);
        entry.add("count", step.count);
        if (step.places.size())
        {
            Info<< ", at " << step.places[0];
            entry.add("firstPlace", step.places[0]);
        }
        Info<< nl;
        dict.add(word("step" + Foam::name(dict.size())), entry);
    }

    return dict;
}


static void logPatches(const wallSurface& surface)
{
    const List<patchMeasures> patches(measuresOfPatches(surface));

    Info<< nl << "Patches:" << nl;
    forAll(patches, patchi)
    {
        const patchMeasures& patch = patches[patchi];
        Info<< "    " << surface.patchNames[patchi] << ": faces "
            << patch.nFaces << ", area " << patch.area << " m2, centre "
            << patch.centre;
        if (patch.normal != vector(Zero))
        {
            Info<< ", plane, normal " << patch.normal;
        }
        Info<< nl;
    }
    Info<< flush;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

string sizesOf(const wallSurface& surface)
{
    return name(surface.faces.size()) + " faces, "
      + name(surface.points.size()) + " points, "
      + name(surface.patchNames.size()) + " patches";
}


void writePrepared
(
    const caseWriter& writer,
    const fileName& file,
    const wallSurface& surface
)
{
    replaceFiles([&](replacedFiles& replaced)
    {
        writer.writeSurface(file, surface, replaced);
    });
    logPatches(surface);
    Info<< nl << "Surface: " << file << nl << endl;
}


void repair
(
    const wallSurfaceControls& controls,
    const layerControls& layers,
    preparedSurface& prepared,
    stageLog& log
)
{
    if (controls.repair.repair == surfaceRepairControls::method::none)
    {
        return;
    }

    log.begin("surfaceRepair");
    const repairedSurface repaired
    (
        repairSurface(prepared.surface, controls, layers)
    );
    if (repaired.steps.empty())
    {
        log.end("nothing to repair");
        return;
    }
    log.end(sizesOf(repaired.surface));

    const dictionary steps(logSteps(repaired.steps));
    dictionary changes(compare(prepared.surface, repaired));
    changes.add("steps", steps);
    prepared.changes.add("repair", changes);
    prepared.surface = repaired.surface;
}


void remesh
(
    const wallSurfaceControls& controls,
    preparedSurface& prepared,
    const Time& time,
    stageLog& log
)
{
    if (!controls.remesh.active)
    {
        return;
    }

    log.begin("surfaceRemesh");
    PtrList<regionSearch> regions;
    for (const edgeRegion& region : controls.remesh.regions)
    {
        regions.append(new regionSearch(region, time));
    }
    remeshedSurface remeshed
    (
        remeshSurface(prepared.surface, controls.remesh, regions)
    );
    const scalar size = boundBox(remeshed.surface.points, false).mag();
    for (const sidePatch& plane : controls.sidePlanes)
    {
        // Two edges of the border may have become those of one triangle
        removeFacesOn(remeshed.surface, plane, touchShare*sideTolerance*size);
    }
    log.end(sizesOf(remeshed.surface));

    dictionary changes(compare(prepared.surface, remeshed));
    changes.add("awayFromFeatures", measure(remeshed));
    prepared.changes.add("remesh", changes);
    prepared.surface = remeshed.surface;
}

} // End namespace Foam

// ************************************************************************* //
