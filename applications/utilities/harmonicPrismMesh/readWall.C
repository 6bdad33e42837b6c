/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readWall.H"
#include "boxSidePlanes.H"
#include "cutBlindFaces.H"
#include "cutReflexFaces.H"
#include "flipCaps.H"
#include "prismPolyMesh.H"
#include "renumberWall.H"
#include "splitAtSidePatches.H"
#include "surfaceAdvice.H"
#include "wallDefects.H"

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


//- The defects of the wall, reported; empty if there are none
static string checkWall
(
    const wallSurface& wall,
    const bool mayBeOpen,
    const wallReading& reading,
    stageLog& log
)
{
    log.begin("wallDefects");
    const List<wallDefect> found(findWallDefects(wall, mayBeOpen));
    log.end(found.empty() ? "none" : name(found.size()) + " kinds");

    string defects(describe(found));

    if (found.size() && reading.nearPoints)
    {
        defects += "\n" + name(reading.nearPoints) + " points are nearer than "
          + name(wallReading::nearTolerance) + " of the diagonal to others:"
          + " surface.mergeTolerance makes such points one.";
    }

    return defects;
}


//- Changes faces above which no cells could be positive, and reports it
static void prepareFaces(wallSurface& wall)
{
    const label nFlips = flipCaps(wall);
    if (nFlips)
    {
        Info<< "    triangles of almost no height, flipped " << nFlips << endl;
    }

    // Repair may have folded some
    const label nCut = cutReflexFaces(wall) + cutBlindFaces(wall);
    if (nCut)
    {
        Info<< "    faces cut into triangles, because a point cannot see all"
            << " its faces " << nCut << endl;
    }
}


//- The wall of a surface without defects, reported if it ends on side patches
static wallSurface takeWall
(
    const wallSurface& surface,
    const wallSurfaceControls& controls,
    const layerControls& layers,
    wallReading& reading,
    stageLog& log
)
{
    const label flipped = reading.flippedFaces;
    wallSurface wall(splitAtSidePatches(surface, controls, layers, reading));

    if (wall.border.sides.size())
    {
        log.begin("sidePatches");
        log.end(sizesOf(wall) + " of the wall");

        Info<< "    ends on";
        wordHashSet curved;
        for (const sidePatch& side : wall.border.sides)
        {
            if (side.isCurved())
            {
                curved.insert(side.name);
            }
        }
        for (const word& name : sidePatchNames(wall.border))
        {
            Info<< ' ' << name << (curved.found(name) ? " (curved)" : "");
        }
        Info<< ", " << wall.border.edges.size() << " edges" << nl
            << "    points put on their planes " << reading.pointsPutOnSides
            << ", by " << reading.largestMove << " m at most"
            << ", faces turned to the fluid "
            << reading.flippedFaces - flipped << endl;

        const List<wallDefect> defects(findWallDefects(wall, true));
        if (defects.size())
        {
            FatalErrorInFunction
                << "The wall has defects after its border was put on the side"
                << " patches" << nl << describe(defects).c_str()
                << exit(FatalError);
        }
    }

    prepareFaces(wall);

    return wall;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

preparedWall readWall
(
    const fileNameList& surfaceFiles,
    const prismLayerControls& controls,
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
    wallSurfaceControls onSides(controls.surface);
    onSides.sidePlanes = withBoxSides
    (
        given, controls.surface.sidePlanes, controls.farField.boundary
    );

    preparedWall result;
    result.prepared.surface = given;
    if (reading.cadFiles.size())
    {
        result.prepared.changes.add("cad", reading.cadFiles);
    }
    repair(onSides, controls.layers, result.prepared, log);
    const wallSurface& surface = result.prepared.surface;
    const bool mayBeOpen = onSides.sidePlanes.size();
    result.defects = checkWall(surface, mayBeOpen, reading, log);

    if (result.defects.size())
    {
        if (wantsAdvice)
        {
            result.advice = adviceOnDefects(given, onSides, controls.layers);
        }

        return result;
    }

    remesh(onSides, result.prepared, time, log);
    result.wall = takeWall(surface, onSides, controls.layers, reading, log);
    renumberWall(result.wall);

    return result;
}

} // End namespace Foam

// ************************************************************************* //
