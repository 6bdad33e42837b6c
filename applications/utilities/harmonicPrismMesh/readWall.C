/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readWall.H"
#include "prismCase.H"
#include "readWallSurface.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The surface, read and reported
static wallSurface readFiles
(
    const fileNameList& files,
    const wallSurfaceControls& controls,
    wallReading& reading,
    stageLog& log
)
{
    log.begin("wallSurface");
    wallSurface wall(readWallSurface(files, controls, reading));
    log.end(sizesOf(wall));

    for (const fileName& file : files)
    {
        Info<< "    " << file << nl;
    }
    for (const string& cad : reading.cadFiles)
    {
        Info<< "    " << cad.c_str() << nl;
    }
    Info
        << "    merged points " << reading.mergedPoints
        << ", nearly equal points " << reading.nearPoints
        << ", collapsed faces " << reading.collapsedFaces
        << ", faces cut into triangles " << reading.cutFaces
        << ", faces turned to the fluid " << reading.flippedFaces << endl;

    return wall;
}


static dictionary toDictionary(const surfaceDistance& distance)
{
    dictionary dict;
    dict.add("max", distance.largest);
    dict.add("mean", distance.mean);
    dict.add("place", distance.place);

    return dict;
}


static dictionary toDictionary(const surfaceMeasures& measures)
{
    dictionary dict;
    dict.add("faces", measures.angles.size());
    dict.add("area", measures.area);
    if (measures.volume > 0)
    {
        dict.add("volume", measures.volume);
    }
    dict.add("smallestAngle", toDictionary(makePercentiles(measures.angles)));
    dict.add("below15DegreesPercent", 100*measures.shareWithSmallAngles);

    return dict;
}


static dictionary toDictionary(const surfaceChange& change)
{
    dictionary dict;
    dict.add("distanceFromGiven", toDictionary(change.distance));
    dict.add("distanceOfGiven", toDictionary(change.distanceOfGiven));
    dict.add("before", toDictionary(change.before));
    dict.add("now", toDictionary(change.now));

    return dict;
}


//- Entries step0, ...
static dictionary toDictionary(const repairSteps& steps)
{
    dictionary dict;
    for (const repairStep& step : steps)
    {
        dictionary entry;
        entry.add("what", step.what);
        entry.add("count", step.count);
        if (step.places.size())
        {
            entry.add("firstPlace", step.places[0]);
        }
        dict.add(word("step" + Foam::name(dict.size())), entry);
    }

    return dict;
}


static dictionary toDictionary
(
    const wallReading& reading,
    const preparedWall& prepared
)
{
    dictionary dict;
    if (reading.cadFiles.size())
    {
        dict.add("cad", reading.cadFiles);
    }
    if (prepared.nFacesInSides)
    {
        dict.add("facesInSidesRemoved", prepared.nFacesInSides);
    }
    if (prepared.steps.size())
    {
        dictionary repair(toDictionary(prepared.repair));
        repair.add("steps", toDictionary(prepared.steps));
        dict.add("repair", repair);
    }
    if (prepared.isRemeshed)
    {
        const remeshQuality& quality = prepared.quality;
        dictionary away;
        away.add
        (
            "below15DegreesPercent",
            100.0*quality.nSmallAngles/prepared.surface.faces.size()
        );
        away.add("edgesBeyond70Degrees", quality.nNonOrtho);
        dictionary remesh(toDictionary(prepared.remesh));
        remesh.add("awayFromFeatures", away);
        dict.add("remesh", remesh);
    }

    return dict;
}


static string textOf
(
    const List<wallDefect>& defects,
    const wallReading& reading
)
{
    string text(describe(defects));
    if (defects.size() && reading.nearPoints)
    {
        text += "\n" + name(reading.nearPoints) + " points are nearer than "
          + name(wallReading::nearTolerance) + " of the diagonal to others:"
          + " surface.mergeTolerance makes such points one.";
    }

    return text;
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


static void logChanges(const preparedWall& prepared)
{
    if (prepared.sideOfSheets.size())
    {
        Info<< prepared.sideOfSheets.c_str() << flush;
    }
    if (prepared.nFlips)
    {
        Info<< "    triangles of almost no height, flipped " << prepared.nFlips
            << endl;
    }
    if (prepared.nCut)
    {
        Info<< "    faces cut into triangles, because no cell is good on"
            << " them " << prepared.nCut << endl;
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

caseWall readWall
(
    const fileNameList& surfaceFiles,
    prismLayerControls& controls,
    const bool wantsAdvice,
    const Time& time,
    stageLog& log
)
{
    wallReading reading;
    const wallSurface given
    (
        readFiles(surfaceFiles, controls.surface, reading, log)
    );

    prismLayerControls asked(controls);
    if (wantsAdvice && asked.surface.remesh.active)
    {
        asked.surface.remesh.active = false;
        Info<< "    surface.remesh is not tried" << endl;
    }

    caseWall wall;
    wall.prepared = prepareWall
    (
        given, asked, makeSearches(controls.surface.remesh.regions, time),
        log.observer()
    );
    const preparedWall& prepared = wall.prepared;
    logChanges(prepared);
    controls.farField.boundary.box = prepared.farBox;
    controls.surface.fluidOutside = prepared.fluidOutside;
    if (prepared.far.faces.size())
    {
        controls.farField.boundary.type = farBoundaryType::surface;
    }
    wall.entries = toDictionary(reading, prepared);
    wall.isChanged = wall.entries.size();
    wall.entries.add("account", toDictionary(prepared.account));
    wall.defects = textOf(prepared.defects, reading);
    if (wantsAdvice)
    {
        const string found(wall.defects.empty() ? "Surface OK." : wall.defects);
        Info<< nl << found.c_str() << nl << endl;
        wall.advice =
            wall.defects.size()
          ? adviceOnDefects(given, controls, log.observer())
          : adviceOnAngles(prepared.wall, controls.surface.remesh);
    }

    return wall;
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

} // End namespace Foam

// ************************************************************************* //
