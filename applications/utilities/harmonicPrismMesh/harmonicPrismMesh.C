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
    postProcessing/harmonicPrismMesh/report and report.json, and, if the wall
    ends on side patches, constant/triSurface/sides.obj. A run that makes no
    mesh writes postProcessing/harmonicPrismMesh/refused.json. Its exit status
    is 1, 2 for the dictionary, 3 for the surface, 4 if there is no room for
    layers, 5 for memory or files, 6 for a fault of this program.

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

      - \par -plan
        Say how many cells, how much memory and time the mesh is expected to
        take, write nothing

      - \par -splitRegions
        Write each region of the dictionary as a mesh of its own

      - \par -parallel
        Make the layers with all processes, and write the mesh in pieces, one
        for each process, as system/decomposeParDict says. No stack of cells is
        divided.

      - \par -version
        Print the version, and do nothing else

      - \par -writeFields
        Write VTK files of wall, layers, columns, envelope and background mesh,
        and how even the level sets of the field are. Not with -parallel

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "meshRegions.H"
#include "meshWall.H"
#include "OSspecific.H"
#include "planWall.H"
#include "pluginVersion.H"
#include "polyMesh.H"
#include "ranges.H"
#include "refusal.H"
#include "readPrismLayerControls.H"
#include "returnMemory.H"
#include "throwingErrors.H"
#include "Time.H"

#include <new>

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
        "  constant/triSurface/layerOuter.obj, and sides.obj if the wall ends\n"
        "  postProcessing/harmonicPrismMesh/report, and report.json\n"
        "or refused.json there, with the exit status 1, 2 (dictionary), 3"
        " (surface),\n"
        "4 (no room for layers), 5 (memory, files) or 6 (a fault of this"
        " program).\n"
        "etc/caseDicts/annotated/harmonicPrismMeshDict describes every entry."
    );
    argList::addOption
    (
        "dict", "file", "Alternative to system/harmonicPrismMeshDict"
    );
    argList::addOption("region", "name", "Write the mesh of that region");
    argList::addBoolOption("overwrite", "Replace an existing mesh");
    argList::addBoolOption
    (
        "checkSurface", "Name the defects of the surface, write nothing"
    );
    argList::addBoolOption
    (
        "prepareSurface",
        "Repair and remesh the surface, write <name>.prepared.obj, no mesh"
    );
    argList::addBoolOption
    (
        "plan", "Say what cells, memory and time to expect, write nothing"
    );
    argList::addBoolOption
    (
        "splitRegions", "Write each region of the dictionary as a mesh of its"
        " own"
    );
    argList::addBoolOption("version", "Print the version, do nothing else");
    argList::addBoolOption
    (
        "writeFields",
        "Write VTK files of each stage, and a script that shows them in"
        " ParaView. Not with -parallel"
    );
}


//- Gives the advice on the surface, and ends the run: with 1 if it has defects
static void endCheck(const caseWall& given)
{
    Info<< nl << given.advice.c_str() << nl << nl << "End" << nl << endl;

    // What main returns is lost: the destructor of args exits with 0
    UPstream::exit(given.defects.empty() ? 0 : 1);
}


//- Errors: FatalError if several processes are to do what one does
static void requireOneProcess(const parallelRun& parallel, const bool isForOne)
{
    if (parallel.isParallel() && isForOne)
    {
        FatalErrorInFunction
            << "-checkSurface, -prepareSurface, -plan and -writeFields run"
            << " without -parallel"
            << exit(FatalError);
    }
}


//- Errors: FatalError if the run is to write a mesh where there is one that it
//  may not replace, before any work
static void requireNoMesh
(
    const argList& args,
    const prismCase& files,
    const parallelRun& parallel,
    const UList<fileName>& surfaces,
    const farFieldControls& farField
)
{
    if
    (
        !args.found("checkSurface") && !args.found("prepareSurface")
     && !args.found("plan")
    )
    {
        const label nProcesses = parallel.isParallel() ? parallel.size() : 0;
        files.checkOverwrite(surfaces, farField, nProcesses);
    }
}


//- Errors: FatalError if the surface has defects
static void requireNoDefects
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


//- On a process other than the master: makes and writes its piece of the mesh.
//  Returns whether all is well; the master says what is not.
static bool helpMaster(const parallelRun& parallel, const caseWriter& writer)
{
    try
    {
        return writer.writeOnOther(makePieceForMaster(parallel));
    }
    catch (const Foam::error&)
    {
        return false;
    }
}


//- Makes the meshes of the regions of the dictionary.
//  Errors: FatalError for options that need a single region
static void meshAllRegions
(
    const argList& args,
    const prismCase& files,
    const parallelRun& parallel,
    const caseWriter& writer,
    const Time& time,
    stageLog& log
)
{
    for
    (
        const char* option
      : {
            "checkSurface", "prepareSurface", "plan", "writeFields", "region",
            "parallel"
        }
    )
    {
        if (args.found(option))
        {
            FatalErrorInFunction
                << "-" << option << " is not possible with regions" << nl
                << "Run without it" << exit(FatalError);
        }
    }

    meshRegions
    (
        files, parallel, writer, args.found("splitRegions"), time, log
    );
}


//- Checks, prepares, or meshes the surface of the only region
static void meshOneRegion
(
    const argList& args,
    const prismCase& files,
    const parallelRun& parallel,
    const caseWriter& writer,
    const Time& time,
    stageLog& log
)
{
    const bool checkOnly = args.found("checkSurface");
    const bool prepareOnly = args.found("prepareSurface");
    const bool planOnly = args.found("plan");
    requireOneProcess
    (
        parallel,
        checkOnly || prepareOnly || planOnly || args.found("writeFields")
    );
    prismLayerControls controls(readPrismLayerControls(files.dict()));
    const fileNameList surfaces(files.surfaceFiles(controls.surface));
    const fileName preparedFile(files.preparedFile(surfaces));
    requireNoMesh(args, files, parallel, surfaces, controls.farField);
    caseWall given(readWall(surfaces, controls, checkOnly, time, log));

    if (checkOnly)
    {
        endCheck(given);
    }
    requireNoDefects(given, controls.surface);

    if (prepareOnly)
    {
        writePrepared(writer, preparedFile, given.prepared.surface);
    }
    else if (planOnly)
    {
        planWall(files, given, controls, time, log);
    }
    else
    {
        meshWall
        (
            files, parallel, writer, given, preparedFile, controls,
            args.found("writeFields"), time, log
        );
    }
}


//- Lets freed lists return to the system, and a lack of memory throw: the
//  handler of OpenFOAM would abort without a message that says so. The log and
//  messages have OpenFOAM's six digits, whatever the case writes its fields
//  with.
static void prepareRun()
{
    std::set_new_handler(nullptr);
    keepLongListsApart();

    const unsigned digits = 6;
    IOstream::defaultPrecision(digits);
    Sout.precision(digits);
    FatalError().precision(digits);
    FatalIOError.error::operator()().precision(digits);
}


//- Checks, prepares or meshes the surface. Returns whether all is well; on
//  another process than the master, who says what is not
static bool makeMesh(const argList& args, Time& time, stageLog& log)
{
    const throwingErrors throwing(true);
    const prismCase files(args, time);
    const parallelRun parallel(time);
    const caseWriter writer(files, parallel, time);

    if (!parallel.isMaster())
    {
        return helpMaster(parallel, writer);
    }
    if (files.dict().found("regions"))
    {
        meshAllRegions(args, files, parallel, writer, time, log);
    }
    else
    {
        meshOneRegion(args, files, parallel, writer, time, log);
    }

    return true;
}


//- Writes refused.json, says the error as OpenFOAM does, and ends the run with
//  the status of the refusal
static void refuse
(
    const argList& args,
    const Time& time,
    const stageLog& log,
    const Foam::error& failure
)
{
    const label nStages = log.costs().size();
    const refusal what
    (
        refusalOf(failure, nStages ? log.costs()[nStages - 1].stage : word())
    );
    setParallel(false);
    try
    {
        const throwingErrors throwing(true);
        const fileName folder
        (
            prismCase::reportFolder
            (
                time, args.lookupOrDefault("region", polyMesh::defaultRegion)
            )
        );
        if (UPstream::master())
        {
            mkDir(folder);
            writeReport(folder/refusedName, toDictionary(what));
        }
    }
    catch (const Foam::error&)
    {
        // The error itself is more important than its file
    }

    Perr<< nl;
    if (const auto* io = dynamic_cast<const IOerror*>(&failure))
    {
        Perr<< *io;
    }
    else
    {
        Perr<< failure;
    }
    Perr<< nl << "\nNo mesh was written. A mesh that was there is as it was.\n"
        << "\nFOAM exiting\n" << endl;
    std::exit(what.status());
}


//- Ends the run because of an exception that is no error of OpenFOAM
static void refuse
(
    const argList& args,
    const Time& time,
    const stageLog& log,
    const refusal::codes code,
    const string& message
)
{
    refusal what;
    what.code = code;
    what.message = message;
    refuse(args, time, log, refusalError(what));
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

    prepareRun();
    Info<< "harmonicPrismMesh " << pluginVersion << nl << endl;
    bool isWell = false;
    stageLog log(Info);
    try
    {
        isWell = makeMesh(args, runTime, log);
    }
    catch (const Foam::error& failure)
    {
        refuse(args, runTime, log, failure);
    }
    catch (const std::bad_alloc&)
    {
        refuse
        (
            args, runTime, log, refusal::codes::resources,
            "There is not enough memory"
        );
    }
    catch (const std::exception& failure)
    {
        refuse
        (
            args, runTime, log, refusal::codes::internal,
            "A fault of harmonicPrismMesh: " + string(failure.what())
        );
    }

    Info<< "End" << nl << endl;

    return isWell ? 0 : 1;
}


// ************************************************************************* //
