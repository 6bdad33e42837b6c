/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismCase.H"
#include "argList.H"
#include "farFieldReport.H"
#include "layerSurfaces.H"
#include "OSspecific.H"
#include "partsOfMesh.H"
#include "polyMesh.H"
#include "prepareSurface.H"
#include "prismPolyMesh.H"
#include "replacedFiles.H"
#include "returnMemory.H"
#include "throwingErrors.H"
#include "Time.H"
#include "wallPointsError.H"
#include "writeStageFields.H"
#include "writeVtk.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static IOobject dictObject(const argList& args, const Time& time)
{
    return IOobject::selectIO
    (
        IOobject
        (
            "harmonicPrismMeshDict", time.system(), time,
            IOobject::MUST_READ, IOobject::NO_WRITE
        ),
        args.found("dict") ? fileName(args["dict"]) : fileName::null
    );
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::prismCase::prismCase(const argList& args, Time& time)
:
    args_(args),
    time_(time),
    region_(args.lookupOrDefault<word>("region", polyMesh::defaultRegion)),
    dict_(dictObject(args, time)),
    team_(time)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::prismCase::checkOverwrite
(
    const UList<fileName>& surfaces,
    const farFieldControls& farField
) const
{
    const bool replaces =
        args_.found("overwrite")
     || (farField.type == "mesh" && farField.region.empty());

    for (const fileName& file : {outerFile(), sidesFile()})
    {
        if (surfaces.found(file))
        {
            FatalErrorInFunction
                << "The surface " << file << " would be overwritten by what is"
                << " written for other meshers; give it another name"
                << exit(FatalError);
        }
    }

    for (label processor = 0; processor < team_.size(); ++processor)
    {
        const fileName folder
        (
            team_.isParallel()
          ? time_.globalPath()/("processor" + name(processor))/polyMeshPath()
          : polyMeshFolder()
        );

        if (!replaces && isDir(folder))
        {
            FatalErrorInFunction
                << "There is a mesh already: " << folder << nl
                << "Use -overwrite to replace it" << exit(FatalError);
        }
    }
}


Foam::polyMeshParts Foam::prismCase::readCore(const word& region) const
{
    const word name(region.empty() ? region_ : region);
    const fileName folder
    (
        name == polyMesh::defaultRegion
      ? fileName(polyMesh::meshSubDir) : name/polyMesh::meshSubDir
    );

    if (!isFile(time_.path()/time_.constant()/folder/"faces"))
    {
        FatalErrorInFunction
            << "There is no mesh for the layers to go into: "
            << time_.path()/time_.constant()/folder << nl
            << "Make it, with blockMesh or snappyHexMesh, or name its region:"
            << " farField.region" << exit(FatalError);
    }

    return partsOf
    (
        polyMesh
        (
            IOobject(name, time_.constant(), time_, IOobject::MUST_READ)
        )
    );
}


void Foam::prismCase::writeFields
(
    const wallSurface& wall,
    const prismLayerMesh& m
) const
{
    Info<< "Writing VTK files to " << reportFolder() << endl;
    writeStageFields(reportFolder(), wall, m);
}


Foam::fileName Foam::prismCase::writeFailedPoints
(
    const wallPointsError& failure
) const
{
    vtkGrid grid;
    grid.points = failure.points();
    forAll(grid.points, i)
    {
        grid.addCell(vtkCell::vertex, labelList(1, i));
    }

    const labelList& labels = failure.labels();
    grid.pointFields.add("wallPoint", scalarList(labels.begin(), labels.end()));
    mkDir(reportFolder());
    writeVtk(failedPointsFile(), grid);

    return failedPointsFile();
}


void Foam::prismCase::writeSurface
(
    const fileName& target,
    const MeshedSurface<face>& surface,
    replacedFiles& files
) const
{
    const word name(target.name());
    const fileName file(files.scratch(target, name)/name);

    surface.write(file);
    checkEnd(file, "# </faces>");
}


void Foam::prismCase::writeOuter
(
    const prismLayers& layers,
    const bool hasFarField,
    replacedFiles& files
) const
{
    writeSurface(outerFile(), outerSurface(layers), files);

    if (!hasFarField && endOnParts(layers))
    {
        writeSurface(sidesFile(), sideSurface(layers), files);
    }
}


Foam::IOobject Foam::prismCase::meshObject() const
{
    return IOobject
    (
        region_, time_.constant(), time_,
        IOobject::NO_READ, IOobject::AUTO_WRITE
    );
}


bool Foam::prismCase::writePiece() const
{
    meshPiece piece(team_.receivePiece());
    replacedFiles files;
    string failure;
    const throwingErrors throwing(true);
    IOstream::defaultPrecision(17);

    try
    {
        writePiece(piece, files);
    }
    catch (const Foam::error& e)
    {
        failure = e.message();
    }

    const bool all = team_.tellWritten(failure);
    if (all)
    {
        files.replaceAll();
    }
    else
    {
        files.removeScratch();
    }

    return all;
}


void Foam::prismCase::writeAll
(
    const wallSurface& wall,
    prismLayerMesh& m,
    const dictionary& surfaceChanges,
    stageLog& log,
    replacedFiles& files
) const
{
    log.begin("prismPolyMesh");
    const bool hasFarField = !m.farField.empty();

    writeOuter(m.made.layers, hasFarField, files);
    layerReport report
    (
        makeLayerReport
        (
            wall, m.addressing, m.request, m.made.layers, m.certificate,
            m.made.causes
        )
    );
    report.noField = m.noField;
    report.points = countKinds(m.pointKinds);
    report.nFurtherColumns = m.front.extraColumnPoints().size();
    report.nRetreats = m.made.nRetreats;
    report.faces = m.faces;

    const qualityControls bounds(m.bounds);
    prismLayers layers(std::move(m.made.layers));
    farFieldMesh farField(std::move(m.farField));
    m = prismLayerMesh();
    returnMemory();

    const label nLayerCells = layers.faces.size()*layers.nLayers;
    const autoPtr<polyMesh> mesh(writeMesh(layers, farField, files));
    farField = farFieldMesh();
    log.end
    (
        mesh
      ? name(mesh->nCells()) + " cells, " + name(mesh->nFaces()) + " faces"
      : name(nLayerCells) + " cells, " + name(team_.size()) + " pieces"
    );
    report.stages = log.costs();

    dictionary entries(toDictionary(report));
    entries.add("surface", surfaceChanges);
    Foam::write(Info, report);

    if (hasFarField)
    {
        const farFieldReport far(makeFarFieldReport(mesh(), bounds));
        entries.add("farField", toDictionary(far));
        Foam::write(Info, far);
    }

    IOstream::defaultPrecision(6);
    writeReport(files.scratch(reportFile(), "report")/"report", entries);
}


void Foam::prismCase::replace
(
    const std::function<void(replacedFiles&)>& write
) const
{
    replacedFiles files;

    // What was certified is what is written: no digit may be lost
    IOstream::defaultPrecision(17);

    try
    {
        const throwingErrors throwing(true);
        write(files);
        files.replaceAll();
    }
    catch (const Foam::error& failure)
    {
        files.removeScratch();

        FatalErrorInFunction
            << "Cannot write " << files.current() << nl
            << failure.message().c_str() << nl
            << "All files of the case are as they were" << exit(FatalError);
    }
}


void Foam::prismCase::writePrepared
(
    const fileName& file,
    const wallSurface& surface
) const
{
    replace([&](replacedFiles& files)
    {
        writeSurface(file, toMeshedSurface(surface), files);
    });

    Info<< nl << "Surface: " << file << nl << endl;
}


void Foam::prismCase::write
(
    const wallSurface& wall,
    prismLayerMesh& m,
    stageLog& log,
    const fileName& preparedFile,
    const preparedSurface& prepared
) const
{
    replace([&](replacedFiles& files)
    {
        if (prepared.isChanged())
        {
            writeSurface
            (
                preparedFile, toMeshedSurface(prepared.surface), files
            );
        }
        writeAll(wall, m, prepared.changes, log, files);
    });

    rm(failedPointsFile());

    Info<< nl << "Mesh:   " << polyMeshFolder() << nl
        << "Outer:  " << outerFile() << nl
        << "Report: " << reportFile() << nl;

    if (prepared.isChanged())
    {
        Info<< "Surface: " << preparedFile << nl;
    }
    Info<< endl;
}


// ************************************************************************* //
