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
    mesh writes postProcessing/harmonicPrismMesh/refused.json.

Usage
    \b harmonicPrismMesh [OPTIONS]

    runOptions.C has the options; -help lists them.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "meshRegions.H"
#include "meshWall.H"
#include "planWall.H"
#include "pluginVersion.H"
#include "readPrismLayerControls.H"
#include "refuseRun.H"
#include "runOptions.H"
#include "throwingErrors.H"
#include "Time.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

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
    requireOneProcess(args, parallel);
    prismLayerControls controls(readPrismLayerControls(files.dict()));
    const fileNameList surfaces(files.surfaceFiles(controls.surface));
    const fileName preparedFile(files.preparedFile(surfaces));
    if (!checkOnly && !prepareOnly && !planOnly)
    {
        files.checkOverwrite
        (
            surfaces, controls.farField,
            parallel.isParallel() ? parallel.size() : 0
        );
    }
    caseWall given(readWall(surfaces, controls, checkOnly, time, log));

    if (checkOnly)
    {
        // What main returns is lost: the destructor of args exits with 0
        Info<< nl << given.advice.c_str() << nl << nl << "End" << nl << endl;
        UPstream::exit(given.defects.empty() ? 0 : 1);
    }
    requireNoDefects(given, controls.surface);

    if (prepareOnly)
    {
        writePrepared(writer, preparedFile, given.prepared.surface);
    }
    else if (planOnly)
    {
        planWall(files, given, controls, log);
    }
    else
    {
        meshWall
        (
            files, parallel, writer, given, preparedFile, controls,
            args.found("writeFields"), log
        );
    }
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
        refuseOptionsOfOne(args);
        meshRegions(files, parallel, writer, args.found("splitRegions"), log);
    }
    else
    {
        meshOneRegion(args, files, parallel, writer, time, log);
    }

    return true;
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
    const bool isWell = runOrRefuse(args, runTime, [&](stageLog& log)
    {
        return makeMesh(args, runTime, log);
    });
    Info<< "End" << nl << endl;

    return isWell ? 0 : 1;
}


// ************************************************************************* //
