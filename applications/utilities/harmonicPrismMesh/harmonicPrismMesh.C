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
    that it names. Writes constant/polyMesh, constant/triSurface/layerOuter.obj,
    postProcessing/harmonicPrismMesh/report, and, if the wall ends on side
    patches, constant/triSurface/sides.obj.

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
        Repair and remesh the surface, as surface.repair and surface.remesh say,
        and write it to constant/triSurface/<name>.prepared.obj, but no mesh

      - \par -parallel
        Write the mesh in pieces, one for each process, as
        system/decomposeParDict says, never divided through a stack of cells

      - \par -version
        Print the version, and do nothing else

      - \par -writeFields
        Write VTK files of wall, layers, columns, envelope and background mesh,
        and how even the level sets of the field are

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "caseWriter.H"
#include "farFieldReport.H"
#include "layerStages.H"
#include "layerSurfaces.H"
#include "OSspecific.H"
#include "pluginVersion.H"
#include "readDomain.H"
#include "readLocalHeights.H"
#include "readPrismLayerControls.H"
#include "readWall.H"
#include "replacedFiles.H"
#include "returnMemory.H"
#include "surfaceAdvice.H"
#include "teamwork.H"
#include "Time.H"
#include "waitPassively.H"
#include "writeStageFields.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

static void addOptions()
{
    argList::noCheckProcessorDirectories();
    argList::addNote
    (
        "Make n layers of prisms on all of a wall surface, and on request the"
        " rest of the mesh.\n"
        "Reads system/harmonicPrismMeshDict and its surface. Writes\n"
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
    argList::addBoolOption("version", "Print the version, do nothing else");
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


//- Writes mesh, outer surface and report. The mesh of layers is consumed.
static void writeCase
(
    const prismCase& files,
    const caseWriter& writer,
    const preparedWall& given,
    prismLayerMesh&& made,
    stageLog& log,
    replacedFiles& replaced
)
{
    log.begin("prismPolyMesh");
    const bool hasFarField = !made.farField.empty();
    writer.writeOuter(made.made.layers, hasFarField, replaced);
    layerReport report(makeLayerReport(given.wall, made));
    const farFieldReport far
    (
        hasFarField
      ? makeFarFieldReport(made.made.layers, made.farField, made.bounds)
      : farFieldReport()
    );

    prismLayers layers(std::move(made.made.layers));
    farFieldMesh farField(std::move(made.farField));
    made = prismLayerMesh();
    returnMemory();

    const label nCells = report.nCells + far.nCells;
    const label nFaces = writer.writeMesh(layers, farField, replaced);
    log.end
    (
        name(nCells) + " cells, "
      + string(nFaces ? name(nFaces) + " faces" : "in parts for all processes")
    );
    report.stages = log.costs();

    dictionary entries(toDictionary(report));
    entries.add("surface", given.prepared.changes);
    Foam::write(Info, report);

    if (hasFarField)
    {
        entries.add("farField", toDictionary(far));
        Foam::write(Info, far);
    }

    IOstream::defaultPrecision(6);
    const fileName& file = files.reportFile();
    writeReport(replaced.scratch(file, file.name())/file.name(), entries);
}


//- Make and write the mesh on a wall, and its repaired surface. The surface is
//  dropped if it is as it was read.
static void meshWall
(
    const prismCase& files,
    const parallelRun& parallel,
    const caseWriter& writer,
    preparedWall& given,
    const fileName& preparedFile,
    const prismLayerControls& controls,
    const bool pictures,
    const Time& time,
    stageLog& log
)
{
    const wallSurface& wall = given.wall;
    const bool isChanged = given.prepared.isChanged();
    given.prepared.dropUnchanged();
    const localHeights local(readLocal(files, wall, controls, time, log));
    farFieldDomain domain
    (
        readFarField
        (
            files, wall, controls.surface.fluidOutside, controls.farField,
            time, log
        )
    );
    prismLayerMesh made
    (
        makeLayers(files, parallel, wall, controls, local, pictures, log)
    );
    if (controls.farField.isWanted())
    {
        made.farField = makeFarField
        (
            made.made.layers, made.front.addressing, std::move(domain),
            controls.farField, log.observer()
        );
    }
    if (pictures)
    {
        Info<< "Writing VTK files to " << files.reportFolder() << endl;
        writeStageFields(files.reportFolder(), wall, made);
    }

    replaceFiles([&](replacedFiles& replaced)
    {
        if (isChanged)
        {
            writer.writeSurface(preparedFile, given.prepared.surface, replaced);
        }
        writeCase(files, writer, given, std::move(made), log, replaced);
    });
    rm(files.failedPointsFile());

    Info<< nl << "Mesh:   " << files.polyMeshFolder() << nl
        << "Outer:  " << files.outerFile() << nl
        << "Report: " << files.reportFile() << nl
        << (isChanged ? "Surface: " + preparedFile + '\n' : "").c_str()
        << endl;
}


//- Say whether the surface can be meshed, and end the run: with 1 if not
static void endCheck
(
    const preparedWall& given,
    const surfaceRemeshControls& controls
)
{
    const bool isGood = given.defects.empty();
    const string advice
    (
        isGood ? adviceOnAngles(given.wall, controls) : given.advice
    );

    Info<< nl << (isGood ? "Surface OK." : given.defects.c_str()) << nl
        << advice.c_str() << nl << nl << "End" << nl << endl;

    // What main returns is lost: the destructor of args exits with 0
    UPstream::exit(isGood ? 0 : 1);
}


//- Errors: FatalError if several processes are to do what one does
static void requireOneProcess(const parallelRun& parallel, const bool isForOne)
{
    if (parallel.isParallel() && isForOne)
    {
        FatalErrorInFunction
            << "-checkSurface and -prepareSurface run without -parallel"
            << exit(FatalError);
    }
}


//- Errors: FatalError if the surface has defects
static void requireNoDefects
(
    const preparedWall& given,
    const wallSurfaceControls& controls
)
{
    if (given.defects.size())
    {
        FatalErrorInFunction
            << "The surface " << flatOutput(controls.files)
            << " cannot be meshed." << nl << given.defects.c_str()
            << exit(FatalError);
    }
}


int main(int argc, char *argv[])
{
    waitPassively(argv);
    if (versionIsAsked(argc, argv))
    {
        return 0;
    }
    addOptions();

    #include "setRootCase.H"
    #include "createTime.H"

    Info<< "harmonicPrismMesh " << pluginVersion << nl << endl;
    const prismCase files(args, runTime);
    const parallelRun parallel(runTime);
    const caseWriter writer(files, parallel, runTime);

    if (!parallel.isMaster())
    {
        return helpMaster(parallel) && writer.writeReceived() ? 0 : 1;
    }

    const bool checkOnly = args.found("checkSurface");
    const bool prepareOnly = args.found("prepareSurface");
    requireOneProcess(parallel, checkOnly || prepareOnly);
    const prismLayerControls controls(readPrismLayerControls(files.dict()));
    const fileNameList surfaces(files.surfaceFiles(controls.surface));
    const fileName preparedFile(files.preparedFile(surfaces));
    stageLog log;
    preparedWall given(readWall(surfaces, controls, checkOnly, runTime, log));

    if (checkOnly)
    {
        endCheck(given, controls.surface.remesh);
    }
    requireNoDefects(given, controls.surface);

    if (prepareOnly)
    {
        writePrepared(writer, preparedFile, given.prepared.surface);
    }
    else
    {
        const label nProcesses = parallel.isParallel() ? parallel.size() : 0;
        files.checkOverwrite(surfaces, controls.farField, nProcesses);
        meshWall
        (
            files, parallel, writer, given, preparedFile, controls,
            args.found("writeFields"), runTime, log
        );
    }

    Info<< "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
