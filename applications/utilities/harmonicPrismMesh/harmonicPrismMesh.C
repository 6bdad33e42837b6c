/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    harmonicPrismMesh

Group
    grpMeshGenerationUtilities

Description
    Makes the boundary-layer region of a mesh: n layers of prisms on all of a
    wall surface, certified; with a far field all of the mesh.

    Reads system/harmonicPrismMeshDict and the surface in constant/triSurface
    that it names; writes constant/polyMesh, constant/triSurface/layerOuter.obj
    and postProcessing/harmonicPrismMesh/report.

Usage
    \b harmonicPrismMesh [OPTIONS]

    Options:
      - \par -dict \<file\>
        Dictionary instead of system/harmonicPrismMeshDict

      - \par -region \<name\>
        Write the mesh of that region: constant/\<name\>/polyMesh

      - \par -overwrite
        Replace a mesh that is there already

      - \par -checkSurface
        Say what is wrong with the surface, write nothing

      - \par -writeFields
        Write VTK files of the envelope, the background mesh with its fields,
        the columns, the layers, and the wall with what was reached on it; how
        even the level sets of the field are

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "readPrismLayerControls.H"
#include "makeSizeBounds.H"
#include "Time.H"
#include "polyMesh.H"
#include "prismLayerMesh.H"
#include "prismPolyMesh.H"
#include "readLocalHeights.H"
#include "readWallSurface.H"
#include "stageLog.H"
#include "wallDefects.H"
#include "wallPointsError.H"
#include "prismCase.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

static void addOptions()
{
    argList::noParallel();
    argList::addNote
    (
        "Make n layers of prisms on all of a wall surface: the boundary-layer"
        " region of a mesh, or with a far field all of it.\n"
        "Reads system/harmonicPrismMeshDict and the surface that it names;"
        " writes\n"
        "  constant/polyMesh\n"
        "  constant/triSurface/layerOuter.obj\n"
        "  postProcessing/harmonicPrismMesh/report\n"
        "Every key is described in"
        " etc/caseDicts/annotated/harmonicPrismMeshDict."
    );
    argList::addOption
    (
        "dict", "file", "Alternative to system/harmonicPrismMeshDict"
    );
    argList::addOption("region", "name", "Write the mesh of that region");
    argList::addBoolOption("overwrite", "Replace a mesh that is there already");
    argList::addBoolOption
    (
        "checkSurface", "Say what is wrong with the surface, write nothing"
    );
    argList::addBoolOption
    (
        "writeFields",
        "Write VTK files of what the stages made, and heights of level sets"
    );
}


//- The wall, read and reported
static wallSurface readWall
(
    const prismCase& files,
    const wallSurfaceControls& controls,
    wallReading& reading,
    stageLog& log
)
{
    const fileName file(files.surfaceFile(controls.file));

    log.begin("wallSurface");
    wallSurface wall(readWallSurface(file, controls, reading));
    log.end
    (
        name(wall.faces.size()) + " faces, "
      + name(wall.points.size()) + " points, "
      + name(wall.patchNames.size()) + " patches"
    );

    Info<< "    " << file << nl
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
    const wallReading& reading,
    stageLog& log
)
{
    log.begin("wallDefects");
    const List<wallDefect> found(findWallDefects(wall));
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


//- The requests for parts of the wall, looked up and reported
static localHeights readLocal
(
    const prismCase& files,
    const wallSurface& wall,
    const prismLayerControls& controls,
    const Time& time,
    stageLog& log
)
{
    log.begin("localHeights");
    string found;
    const localHeights local
    (
        readLocalHeights
        (
            wall, controls,
            [&](const fileName& file) { return files.surfaceFile(file); },
            time, found
        )
    );
    log.end(found);

    return local;
}


//- The domain of the far field, empty if no far field is wanted
static farFieldDomain readFarField
(
    const prismCase& files,
    const wallSurface& wall,
    const farFieldControls& controls,
    const Time& time,
    stageLog& log
)
{
    farFieldDomain domain;

    if (!controls.isWanted())
    {
        return domain;
    }

    log.begin("farBoundary");
    domain.boundary = makeFarBoundary
    (
        controls.boundary,
        [&](const fileName& file) { return files.surfaceFile(file); }
    );
    domain.bounds = makeSizeBounds(controls, time);

    const wordList wallPatches(prismPatchNames(wall.patchNames));
    string names;

    for (const word& patch : domain.boundary.surface.patchNames)
    {
        names += ' ' + patch;

        if (wallPatches.found(patch))
        {
            FatalErrorInFunction
                << "The far boundary has a patch " << patch << ", as the wall"
                << " has; name one of them otherwise" << exit(FatalError);
        }
    }

    log.end(controls.boundary.type + names);

    return domain;
}


//- The mesh. Errors: FatalError with the file of the points at which no layers
//  are possible
static prismLayerMesh makeMesh
(
    const prismCase& files,
    const wallSurface& wall,
    const prismLayerControls& controls,
    const localHeights& local,
    stageLog& log
)
{
    try
    {
        return makePrismLayerMesh(wall, controls, local, log.observer());
    }
    catch (const wallPointsError& failure)
    {
        const fileName file(files.writeFailedPoints(failure));

        FatalErrorInFunction
            << failure.message().c_str() << nl
            << "Their places are in " << file << exit(FatalError);
    }

    return prismLayerMesh();
}


int main(int argc, char *argv[])
{
    addOptions();

    #include "setRootCase.H"
    #include "createTime.H"

    const prismCase files(args, runTime);
    const prismLayerControls controls(readPrismLayerControls(files.dict()));

    stageLog log;
    wallReading reading;
    const wallSurface wall(readWall(files, controls.surface, reading, log));

    const string defects(checkWall(wall, reading, log));

    if (args.found("checkSurface"))
    {
        Info<< nl << (defects.empty() ? "Surface OK." : defects.c_str()) << nl
            << nl << "End" << nl << endl;

        // What main returns is lost: the destructor of args exits with 0
        UPstream::exit(defects.empty() ? 0 : 1);
    }

    if (defects.size())
    {
        FatalErrorInFunction
            << "The surface " << controls.surface.file
            << " cannot be meshed." << nl << defects.c_str()
            << exit(FatalError);
    }

    files.checkOverwrite(controls.surface.file);

    const localHeights local(readLocal(files, wall, controls, runTime, log));
    const farFieldDomain domain
    (
        readFarField(files, wall, controls.farField, runTime, log)
    );
    prismLayerMesh result(makeMesh(files, wall, controls, local, log));

    if (controls.farField.isWanted())
    {
        addFarField(controls.farField, domain, log.observer(), result);
    }

    if (args.found("writeFields"))
    {
        files.writeFields(wall, result);
    }

    files.write(wall, result, log);

    Info<< "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
