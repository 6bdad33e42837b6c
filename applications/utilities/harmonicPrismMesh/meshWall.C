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
//  pictures: whether all stages are written as VTK files
//  Errors: FatalError with the file of the points where no layers are possible,
//  or with the reason of another process
static autoPtr<caseLayers> makeLayers
(
    const prismCase& files,
    const parallelRun& parallel,
    const wallSurface& wall,
    const prismLayerControls& controls,
    const localHeights& local,
    const bool pictures,
    stageLog& log
)
{
    try
    {
        sendOrder(parallel, files.dict());
        const auto draw = [&](const prismLayerMesh& mesh)
        {
            Info<< "Writing VTK files to " << files.reportFolder() << endl;
            writeStageFields(files.reportFolder(), wall, mesh);
        };

        return autoPtr<caseLayers>::New
        (
            parallel, wall, controls, local, log.observer(),
            pictures ? caseLayers::stageViewer(draw) : nullptr
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
    farFieldMesh farField;
    if (controls.farField.isWanted())
    {
        farField = makeFarField
        (
            made->wholeLayers(), std::move(domain), controls.farField,
            log.observer()
        );
    }

    log.begin("prismPolyMesh");
    replaceFiles([&](replacedFiles& replaced)
    {
        if (isChanged)
        {
            writer.writeSurface(preparedFile, given.prepared.surface, replaced);
        }
        writeCase
        (
            files, parallel, writer, given, made, std::move(farField),
            controls.quality, log, replaced
        );
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
