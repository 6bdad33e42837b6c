/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshWall.H"
#include "pluginVersion.H"
#include "polygonReport.H"
#include "layerStages.H"
#include "meshOrder.H"
#include "OSspecific.H"
#include "prismCase.H"
#include "prismPolyMesh.H"
#include "refusal.H"
#include "returnMemory.H"
#include "wallPointsError.H"
#include "writeStageFields.H"

namespace Foam
{

// * * * * * * * * * * * * * * *  Write Case * * * * * * * * * * * * * * * * //

//- Writes a mesh, in a parallel run all pieces. Returns what the log says.
//  processes: is set to the costs of a parallel run
static string writeMesh
(
    const prismCase& files,
    const parallelRun& parallel,
    const caseWriter& writer,
    const meshInBlocks& mesh,
    const planarControls& planar,
    dictionary& processes,
    replacedFiles& replaced
)
{
    if (!parallel.isParallel())
    {
        return
            name(writer.writeMesh(files, mesh, planar, replaced)) + " faces";
    }
    writer.requireDivisible(mesh);
    writer.writeOwn(makePieces(parallel, mesh, processes), replaced);

    return "in parts for all processes";
}


void setEntries
(
    const bool hasLayers,
    const bool hasFarField,
    const List<verdictLine>& others,
    regionReport& report
)
{
    const layerReport* layers = hasLayers ? &report.layers : nullptr;
    const farFieldReport* far = hasFarField ? &report.farField : nullptr;
    report.verdict = makeVerdict(layers, far, others);

    dictionary& entries = report.entries;
    entries.add("schemaVersion", reportVersion);
    entries.add("version", string(pluginVersion));
    entries.add("status", word("ok"));
    if (layers)
    {
        entries.merge(toDictionary(*layers));
        Foam::write(Info, *layers);
    }
    if (far)
    {
        entries.add("farField", toDictionary(*far));
        Foam::write(Info, *far);
    }
    entries.add("verdict", toDictionary(report.verdict));
}


//- Writes the polygons if there are any, otherwise layers and far field.
//  Consumes all. Returns what the log says.
//  processes: see above
static string writeCells
(
    const prismCase& files,
    const parallelRun& parallel,
    const caseWriter& writer,
    regionParts&& cells,
    polygonMesh&& polygons,
    const planarControls& planar,
    dictionary& processes,
    replacedFiles& replaced
)
{
    const auto write = [&](const meshInBlocks& mesh)
    {
        returnMemory();

        return writeMesh
        (
            files, parallel, writer, mesh, planar, processes, replaced
        );
    };
    if (!polygons.mesh.nCells)
    {
        return write(meshOrder(cells.layers, cells.farField).mesh());
    }
    meshInBlocks mesh(blocksOf(polygons.mesh));
    mesh.nStackCells = polygons.counts.nLayerCells;
    mesh.nLayers = cells.layers.nLayers;
    cells.layers = prismLayers();
    cells.farField = farFieldMesh();

    return write(mesh);
}


//- On the master: writes mesh, outer surface and report. Consumes the cells.
static void writeCase
(
    const prismCase& files,
    const parallelRun& parallel,
    const caseWriter& writer,
    const caseWall& given,
    const fileName& preparedFile,
    regionParts&& cells,
    polygonMesh&& polygons,
    const prismLayerControls& controls,
    regionReport& report,
    stageLog& log,
    replacedFiles& replaced
)
{
    const bool hasFarField = !cells.farField.empty();
    if (given.isChanged)
    {
        writer.writeSurface(preparedFile, given.prepared.surface, replaced);
    }
    writer.writeSurfaces(cells.layers, hasFarField, replaced);
    dictionary others;
    others.add("surface", given.entries);
    if (controls.polygons)
    {
        others.add("polygons", toDictionary(polygons.counts));
        reportPolygons
        (
            polygons, controls.quality, report.layers, report.farField
        );
    }

    dictionary processes;
    const string size
    (
        writeCells
        (
            files, parallel, writer, std::move(cells), std::move(polygons),
            controls.surface.planar, processes, replaced
        )
    );
    log.end
    (
        name(report.layers.nCells + report.farField.nCells) + " cells, " + size
    );
    report.layers.stages = log.costs();

    setEntries
    (
        true, hasFarField,
        List<verdictLine>(1, verdictOnWall(given.prepared.account)), report
    );
    if (processes.size())
    {
        others.add("processes", processes);
    }
    others.add("fields", writer.compareWithFields(files, replaced));
    report.entries.merge(others);
    writer.writeReports(files, report.entries, replaced);
}


// * * * * * * * * * * * * * * * *  Mesh Wall  * * * * * * * * * * * * * * * //

//- The dictionary, with the box of the controls
static dictionary orderOf
(
    const prismCase& files,
    const farBoundaryControls& boundary
)
{
    dictionary order(files.dict());
    if (boundary.type == farBoundaryType::box)
    {
        dictionary& entries = order.subDict("farField").subDict("boundary");
        entries.set("min", boundary.box.min());
        entries.set("max", boundary.box.max());
    }

    return order;
}


//- Errors: FatalError, after the numbers, if the layers are useless
static void requireUsable
(
    const layerReport& report,
    const layerControls& controls
)
{
    meshVerdict verdict;
    verdict.lines = verdictOnLayers(report);
    if (!controls.allowPoorHeights && verdict.isUseless())
    {
        Foam::write(Info, report);
        requireUsable(report);
    }
}


static caseLayers makeLayers
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
    caseLayers made;
    try
    {
        sendOrder(parallel, orderOf(files, controls.farField.boundary));
        const auto draw = [&](const prismLayerMesh& mesh)
        {
            Info<< "Writing VTK files to " << files.reportFolder() << endl;
            writeStageFields(files.reportFolder(), wall, mesh);
        };

        made = makeCaseLayers
        (
            parallel, wall, controls, local, log.observer(),
            pictures ? stageViewer(draw) : nullptr
        );
    }
    catch (const wallPointsError& failure)
    {
        mkDir(files.reportFolder());
        writeFailedPoints(files.failedPointsFile(), failure);

        refusal what(refusalOf(failure, ""));
        what.code = refusal::codes::noRoom;
        what.place = pointField(1, failure.points()[0]);
        what.message +=
            "\nTheir places are in " + files.failedPointsFile();
        throw refusalError(what);
    }
    requireUsable(made.report, controls.layers);

    return made;
}


//- Logs the files of the case that were written.
//  surface: empty if the surface was not
static void logFiles(const prismCase& files, const fileName& surface)
{
    Info<< nl << "Mesh:   " << files.polyMeshFolder() << nl
        << "Outer:  " << files.outerFile() << nl
        << "Report: " << files.reportFile() << nl
        << "Page:   harmonicPrismReport makes one for browsers" << nl;
    if (surface.size())
    {
        Info<< "Surface: " << surface << nl;
    }
    Info<< endl;
}


regionParts makeRegion
(
    const prismCase& files,
    const parallelRun& parallel,
    const wallSurface& wall,
    const prismLayerControls& controls,
    const localHeights* local,
    farFieldDomain&& domain,
    const bool pictures,
    regionReport& report,
    stageLog& log
)
{
    regionParts made;
    if (local)
    {
        caseLayers layers
        (
            makeLayers(files, parallel, wall, controls, *local, pictures, log)
        );
        report.layers = layers.report;
        made.layers = std::move(layers.layers);
    }
    else
    {
        made.layers = wallWithoutLayers(wall);
    }
    if (controls.farField.isWanted())
    {
        made.farField = makeFarField
        (
            made.layers, std::move(domain), controls.farField, log.observer()
        );
        report.farField = makeFarFieldReport
        (
            made.layers, made.farField, controls.quality
        );
    }

    return made;
}


//- Makes the polygons of the only region. Consumes its far field.
//  cyclic: the cyclic sides of the far field
static polygonMesh makePolygons
(
    regionParts& cells,
    const List<sidePatch>& cyclic,
    stageLog& log
)
{
    log.begin("polygonCells");
    polygonMesh polygons
    (
        makePolygonCells
        (
            cells.layers, cells.farField,
            cells.farField.empty() ? cells.layers.border.sides : cyclic
        )
    );
    log.end(textOf(polygons.counts));

    return polygons;
}


void meshWall
(
    const prismCase& files,
    const parallelRun& parallel,
    const caseWriter& writer,
    caseWall& given,
    const fileName& preparedFile,
    const prismLayerControls& controls,
    const bool pictures,
    stageLog& log
)
{
    const wallSurface& wall = given.prepared.wall;
    if (!given.isChanged)
    {
        given.prepared.surface = wallSurface();
    }
    const caseSources sources(files.sources());
    const localHeights local
    (
        readLocal(sources, wall, controls, log.observer())
    );
    farFieldDomain domain
    (
        readDomain
        (
            sources, wall, given.prepared.far, controls.surface.fluidOutside,
            controls.farField, log.observer()
        )
    );
    const List<sidePatch> cyclic(domain.boundary.cyclicSides);
    regionReport report;
    regionParts cells
    (
        makeRegion
        (
            files, parallel, wall, controls, &local, std::move(domain),
            pictures, report, log
        )
    );
    polygonMesh polygons
    (
        controls.polygons ? makePolygons(cells, cyclic, log) : polygonMesh()
    );
    log.begin("prismPolyMesh");
    replaceFiles([&](replacedFiles& replaced)
    {
        writeCase
        (
            files, parallel, writer, given, preparedFile, std::move(cells),
            std::move(polygons), controls, report, log, replaced
        );
    });
    files.removeRefusal();

    logFiles(files, given.isChanged ? preparedFile : fileName());
    Foam::write(Info, report.verdict);
    Info<< endl;
}


bool helpMaster(const parallelRun& parallel, const caseWriter& writer)
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

} // End namespace Foam

// ************************************************************************* //
