/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "prismCase.H"
#include "argList.H"
#include "farFieldReport.H"
#include "MeshedSurface.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "polyMesh.H"
#include "prismPolyMesh.H"
#include "Time.H"
#include "wallPointsError.H"
#include "writeStageFields.H"
#include "writeVtk.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const word dictName("harmonicPrismMeshDict");


static IOobject dictObject(const argList& args, const Time& time)
{
    if (args.found("dict"))
    {
        fileName file(args["dict"]);

        if (isDir(file))
        {
            file = file/dictName;
        }

        return IOobject(file, time, IOobject::MUST_READ, IOobject::NO_WRITE);
    }

    return IOobject
    (
        dictName,
        time.system(),
        time,
        IOobject::MUST_READ,
        IOobject::NO_WRITE
    );
}


//- The outer surface of the layers
static MeshedSurface<face> outerSurface(const prismLayers& layers)
{
    return MeshedSurface<face>
    (
        layers.outerPoints(),
        faceList(layers.faces),
        List<surfZone>(1, surfZone(layerOuterName, layers.faces.size(), 0, 0))
    );
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::prismCase::prismCase(const argList& args, const Time& time)
:
    args_(args),
    time_(time),
    region_(args.lookupOrDefault<word>("region", polyMesh::defaultRegion)),
    dict_(dictObject(args, time))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fileName Foam::prismCase::polyMeshFolder() const
{
    return time_.path()/time_.constant()
       /(region_ == polyMesh::defaultRegion ? word::null : region_)
       /polyMesh::meshSubDir;
}


Foam::fileName Foam::prismCase::reportFolder() const
{
    return time_.path()/"postProcessing"/"harmonicPrismMesh"
       /(region_ == polyMesh::defaultRegion ? word::null : region_);
}


Foam::fileName Foam::prismCase::failedPointsFile() const
{
    return reportFolder()/"failedPoints.vtk";
}


Foam::fileName Foam::prismCase::surfaceFile(const fileName& name) const
{
    if (name.isAbsolute())
    {
        return name;
    }

    return name.find('/') == std::string::npos
      ? time_.path()/time_.constant()/"triSurface"/name
      : time_.path()/name;
}


void Foam::prismCase::checkOverwrite(const fileName& surface) const
{
    if (surfaceFile(surface) == outerFile())
    {
        FatalErrorInFunction
            << "The surface " << surface << " would be overwritten by the outer"
            << " surface of the layers; give it another name"
            << exit(FatalError);
    }

    const fileName folder(polyMeshFolder());

    if (!args_.found("overwrite") && isDir(folder))
    {
        FatalErrorInFunction
            << "There is a mesh already: " << folder << nl
            << "Use -overwrite to replace it" << exit(FatalError);
    }
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
    scalarField labels(grid.points.size());

    forAll(labels, i)
    {
        labels[i] = failure.labels()[i];
        grid.addCell(vtkCell::vertex, labelList(1, i));
    }

    grid.pointFields.add("wallPoint", labels);
    mkDir(reportFolder());
    writeVtk(failedPointsFile(), grid);

    return failedPointsFile();
}


Foam::fileName Foam::prismCase::outerFile() const
{
    const word stem
    (
        region_ == polyMesh::defaultRegion
      ? layerOuterName : word(layerOuterName + '_' + region_)
    );

    return time_.path()/time_.constant()/"triSurface"/(stem + ".obj");
}


void Foam::prismCase::writeOuter(const prismLayers& layers) const
{
    mkDir(outerFile().path());
    outerSurface(layers).write(outerFile());

    // The surface's own writer does not look whether its last bytes arrived
    if (!isFile(outerFile(), false) || !fileSize(outerFile(), false))
    {
        FatalErrorInFunction
            << "Cannot write " << outerFile() << exit(FatalError);
    }
}


void Foam::prismCase::writeReport(const dictionary& report) const
{
    IOstream::defaultPrecision(6);
    mkDir(reportFolder());
    OFstream os(reportFolder()/"report");
    IOobject::writeBanner(os);
    report.write(os, false);
    IOobject::writeEndDivider(os);
    os.flush();

    if (!os.good())
    {
        FatalErrorInFunction
            << "Cannot write " << os.name() << exit(FatalError);
    }
}


Foam::autoPtr<Foam::polyMesh> Foam::prismCase::writeMesh
(
    prismLayerMesh& m
) const
{
    // The old mesh is there until the new one is; nothing of it may stay, and
    // polyMesh would read its tetBasePtIs
    const fileName folder(polyMeshFolder());
    const fileName aside(folder + ".old");
    if (isDir(aside))
    {
        rmDir(aside);
    }
    const bool replaces = isDir(folder) && mv(folder, aside);

    autoPtr<polyMesh> mesh
    (
        makePrismPolyMesh
        (
            m.layers,
            m.farField,
            IOobject
            (
                region_, time_.constant(), time_,
                IOobject::NO_READ, IOobject::AUTO_WRITE
            )
        )
    );

    if (!mesh->write())
    {
        rmDir(folder);
        if (replaces)
        {
            mv(aside, folder);
        }

        FatalErrorInFunction << "Cannot write " << folder << exit(FatalError);
    }

    if (replaces)
    {
        rmDir(aside);
    }

    return mesh;
}


void Foam::prismCase::write
(
    const wallSurface& wall,
    prismLayerMesh& m,
    stageLog& log
) const
{
    log.begin("prismPolyMesh");
    const bool hasFarField = !m.farField.empty();

    // What was certified is what is written: no digit may be lost
    IOstream::defaultPrecision(17);

    writeOuter(m.layers);
    layerReport report
    (
        makeLayerReport
        (
            wall, m.addressing, m.request, m.layers, m.certificate,
            m.columns.causes
        )
    );
    report.noField = m.noField;
    report.points = countKinds(m.pointKinds);
    report.nFurtherColumns = m.front.extraColumnPoints().size();
    report.nRetreats = m.columns.nRetreats;

    const autoPtr<polyMesh> mesh(writeMesh(m));
    log.end
    (
        name(mesh->nCells()) + " cells, " + name(mesh->nFaces()) + " faces"
    );
    report.stages = log.costs();

    dictionary entries(toDictionary(report));
    Foam::write(Info, report);

    if (hasFarField)
    {
        const farFieldReport far(makeFarFieldReport(mesh()));
        entries.add(farFieldName, toDictionary(far));
        Foam::write(Info, far);
    }

    writeReport(entries);
    rm(failedPointsFile());

    Info<< nl << "Mesh:   " << polyMeshFolder() << nl
        << "Outer:  " << outerFile() << nl
        << "Report: " << reportFolder()/"report" << nl << endl;
}


// ************************************************************************* //
