/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshWall.H"
#include "layerStages.H"
#include "OSspecific.H"
#include "readDomain.H"
#include "readLocalHeights.H"
#include "replacedFiles.H"
#include "wallPointsError.H"
#include "writeStageFields.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


//- Makes the layers, in a parallel run with the other processes.
//  Errors: FatalError with the file of the points where no layers are possible,
//  or with the reason of another process
static autoPtr<caseLayers> makeLayers
(
    const prismCase& files,
    const parallelRun& parallel,
    const wallSurface& wall,
    const prismLayerControls& controls,
    const localHeights& local,
    const bool keepStages,
    stageLog& log
)
{
    try
    {
        sendOrder(parallel, files.dict());

        return autoPtr<caseLayers>::New
        (
            parallel, wall, controls, local, log.observer(), keepStages
        );
    }
    catch (const wallPointsError& failure)
    {
        mkDir(files.reportFolder());
        writeFailedPoints(files.failedPointsFile(), failure);

        FatalErrorInFunction
            << failure.message().c_str() << nl
            << "Their places are in " << files.failedPointsFile()
            << exit(FatalError);
    }
    catch (Foam::error& failure)
    {
        failure.throwExceptions(false);
        failure.exit();
    }

    return nullptr;
}


//- Makes the far field around layers
static void addFarField
(
    const wallSurface& wall,
    farFieldDomain&& domain,
    const farFieldControls& controls,
    stageLog& log,
    caseLayers& made
)
{
    prismLayerMesh& mesh = made.mesh();
    const wallAddressing addressing
    (
        mesh.share
      ? makeWallAddressing(surfaceOfFront(wall, mesh.front))
      : mesh.front.addressing
    );
    mesh.farField = makeFarField
    (
        made.layers(), addressing, std::move(domain), controls, log.observer()
    );
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void meshWall
(
    const prismCase& files,
    const parallelRun& parallel,
    const caseWriter& writer,
    caseWall& given,
    const fileName& preparedFile,
    const prismLayerControls& controls,
    const bool pictures,
    const Time& time,
    stageLog& log
)
{
    const wallSurface& wall = given.prepared.wall;
    const bool isChanged = given.isChanged();
    if (!isChanged)
    {
        given.prepared.surface = wallSurface();
    }
    const localHeights local(readLocal(files, wall, controls, time, log));
    farFieldDomain domain
    (
        readFarField
        (
            files, wall, controls.surface.fluidOutside, controls.farField,
            time, log
        )
    );
    autoPtr<caseLayers> made
    (
        makeLayers(files, parallel, wall, controls, local, pictures, log)
    );
    if (controls.farField.isWanted())
    {
        addFarField(wall, std::move(domain), controls.farField, log, made());
    }
    if (pictures)
    {
        Info<< "Writing VTK files to " << files.reportFolder() << endl;
        writeStageFields(files.reportFolder(), wall, made->mesh());
    }

    log.begin("prismPolyMesh");
    replaceFiles([&](replacedFiles& replaced)
    {
        if (isChanged)
        {
            writer.writeSurface(preparedFile, given.prepared.surface, replaced);
        }
        writeCase(files, parallel, writer, given, made, log, replaced);
    });
    rm(files.failedPointsFile());

    Info<< nl << "Mesh:   " << files.polyMeshFolder() << nl
        << "Outer:  " << files.outerFile() << nl
        << "Report: " << files.reportFile() << nl
        << (isChanged ? "Surface: " + preparedFile + '\n' : "").c_str()
        << endl;
}

} // End namespace Foam

// ************************************************************************* //
