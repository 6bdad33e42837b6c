/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readWall.H"
#include "prismCase.H"
#include "ranges.H"
#include "readWallSurface.H"
#include "surfaceReport.H"

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
    wall.entries = changesOf(prepared, reading.cadFiles);
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


void requireNoDefects
(
    const caseWall& given,
    const wallSurfaceControls& controls
)
{
    if (given.defects.size())
    {
        FatalErrorInFunction
            << "The surface " << listed(controls.files).c_str()
            << " cannot be meshed." << nl << given.defects.c_str()
            << exit(FatalError);
    }
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
