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
    and postProcessing/harmonicPrismMesh/report. The wall is closed, or ends on
    side patches; constant/triSurface/sides.obj has what layers leave of them.

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

      - \par -prepareSurface
        Repair the surface as surface.repair says, give it new triangles as
        surface.remesh says, and write it to
        constant/triSurface/<name>.prepared.obj, but no mesh

      - \par -parallel
        Write the mesh in pieces, one for each process, as
        system/decomposeParDict says, never divided through a stack of cells

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
#include "readWall.H"
#include "stageLog.H"
#include "surfaceAdvice.H"
#include "wallPointsError.H"
#include "prismCase.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

static void addOptions()
{
    argList::noCheckProcessorDirectories();
    argList::addNote
    (
        "Make n layers of prisms on all of a wall surface: the boundary-layer"
        " region of a mesh, or with a far field all of it.\n"
        "Reads system/harmonicPrismMeshDict and the surface that it names;"
        " writes\n"
        "  constant/polyMesh\n"
        "  constant/triSurface/layerOuter.obj, and sides.obj where the wall"
        " ends\n"
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
        "prepareSurface",
        "Repair and remesh the surface, write it, <name>.prepared.obj, and no"
        " mesh"
    );
    argList::addBoolOption
    (
        "writeFields",
        "Write VTK files of what the stages made, and heights of level sets"
    );
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
    const bool fluidOutside,
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

    if
    (
        !fluidOutside && controls.boundary.type.size()
     && wall.border.sides.empty()
    )
    {
        FatalErrorInFunction
            << "The fluid is inside of the wall: there is no far boundary"
            << exit(FatalError);
    }

    domain.bounds = makeSizeBounds(controls, time);

    if (controls.type == "mesh")
    {
        log.begin("readMesh");
        domain.core = files.readCore(controls.region);
        log.end(name(domain.core.nCells) + " cells");

        return domain;
    }

    log.begin("farBoundary");
    domain.boundary = makeFarBoundary
    (
        controls.boundary,
        [&](const fileName& file) { return files.surfaceFile(file); }
    );

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
    const bool keepStages,
    stageLog& log
)
{
    try
    {
        return makePrismLayerMesh
        (
            wall, controls, local, log.observer(), keepStages
        );
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


//- Make and write the mesh on a wall, and its repaired surface
static void meshWall
(
    const argList& args,
    const prismCase& files,
    const preparedWall& given,
    const fileName& preparedFile,
    const prismLayerControls& controls,
    const Time& time,
    stageLog& log
)
{
    const wallSurface& wall = given.wall;
    const localHeights local(readLocal(files, wall, controls, time, log));
    farFieldDomain domain
    (
        readFarField
        (
            files, wall, controls.surface.fluidOutside, controls.farField,
            time, log
        )
    );
    const bool pictures = args.found("writeFields");
    prismLayerMesh result
    (
        makeMesh(files, wall, controls, local, pictures, log)
    );

    if (controls.farField.isWanted())
    {
        addFarField
        (
            controls.farField, std::move(domain), log.observer(), result
        );
    }

    if (pictures)
    {
        files.writeFields(wall, result);
    }

    files.write(wall, result, log, preparedFile, given.prepared);
}


int main(int argc, char *argv[])
{
    addOptions();

    #include "setRootCase.H"
    #include "createTime.H"

    const prismCase files(args, runTime);

    if (!files.team().isMaster())
    {
        return files.writePiece() ? 0 : 1;
    }

    const bool checkOnly = args.found("checkSurface");
    const bool prepareOnly = args.found("prepareSurface");
    if (files.team().isParallel() && (checkOnly || prepareOnly))
    {
        FatalErrorInFunction
            << "-checkSurface and -prepareSurface are for one process, without"
            << " -parallel" << exit(FatalError);
    }

    prismLayerControls controls(readPrismLayerControls(files.dict()));
    stageLog log;
    const fileNameList surfaceFiles(files.surfaceFiles(controls.surface));
    const preparedWall given
    (
        readWall(surfaceFiles, checkOnly, controls, log)
    );

    if (checkOnly)
    {
        endCheck("", adviceOnAngles(given.wall, controls.surface.remesh));
    }

    const fileName preparedFile(files.preparedFile(surfaceFiles));

    if (prepareOnly)
    {
        files.writePrepared(preparedFile, given.prepared.surface);
        Info<< "End" << nl << endl;

        return 0;
    }

    files.checkOverwrite(surfaceFiles, controls.farField);
    meshWall(args, files, given, preparedFile, controls, runTime, log);

    Info<< "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
