/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshWall.H"
#include "boxSides.H"
#include "cellSizes.H"
#include "planarColumns.H"
#include "pluginVersion.H"
#include "polygonReport.H"
#include "layerStages.H"
#include "OSspecific.H"
#include "OStringStream.H"
#include "prismCase.H"
#include "prismPolyMesh.H"
#include "readLocalHeights.H"
#include "refusal.H"
#include "returnMemory.H"
#include "wallPointsError.H"
#include "writeStageFields.H"

namespace Foam
{

//- Errors: FatalError if the wall has a patch of the far boundary
static void requireNotOf(const wallSurface& wall, const word& farPatch)
{
    if (prismPatchNames(wall.patchNames).found(farPatch))
    {
        FatalErrorInFunction
            << "The far boundary and the wall both have a patch " << farPatch
            << ". Rename one of them, by farField.boundary.patches or by"
            << " surface.patches" << exit(FatalError);
    }
}


//- Cells of a hexCore are at most so many times as wide as two parallel sides
//  are apart
static constexpr scalar widthShare = 2;

//- A domain is thin if two parallel sides are nearer to each other than this
//  share of its diagonal
static constexpr scalar thinShare = 0.05;


//- Bounds the sizes by the least distance of two parallel sides. Returns what
//  the log says of a thin domain. Tetrahedra are not bounded: TetGen takes
//  minutes for two planes of small triangles that are near to each other.
static string boundByWidth
(
    const wallSurface& wall,
    const farFieldControls& controls,
    sizeBounds& bounds
)
{
    if (emptySides(wall.border).first() >= 0)
    {
        return "";
    }

    const scalar width = leastWidth(controls.boundary, wall.border.sides);
    const bool isHexCore = controls.type == farFieldType::hexCore;
    if (isHexCore)
    {
        bounds.largest = min(bounds.largest, widthShare*width);
    }
    if
    (
        controls.boundary.type != farBoundaryType::box
     || width > thinShare*controls.boundary.box.mag()
    )
    {
        return "";
    }

    OStringStream os;
    os  << nl << "parallel sides are only " << width << " m apart: "
        << (
               isHexCore
             ? "cells are at most twice as wide"
             : "tetrahedra are flat between them, farField.type hexCore is"
               " better there"
           );

    return os.str();
}


//- The type and the patches of a far boundary
static string textOf(const farBoundaryType type, const wordList& patches)
{
    string names;
    if (type != farBoundaryType::none)
    {
        names = farBoundaryTypes[int(type)];
    }
    for (const word& patch : patches)
    {
        names += ' ' + patch;
    }

    return names;
}


//- The far boundary of the surface files if there is one, otherwise the far
//  boundary that the controls ask for
static farBoundary readBoundary
(
    const prismCase& files,
    const wallSurface& far,
    const farBoundaryControls& controls
)
{
    return
        far.faces.size()
      ? makeFarBoundary(far)
      : makeFarBoundary
        (
            controls,
            [&](const fileName& file) { return files.surfaceFile(file); }
        );
}


farFieldDomain readFarField
(
    const prismCase& files,
    const wallSurface& wall,
    const wallSurface& far,
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
        !fluidOutside && controls.boundary.type != farBoundaryType::none
     && wall.border.sides.empty() && far.faces.empty()
    )
    {
        FatalErrorInFunction
            << "The fluid is inside of the wall: remove farField.boundary, or"
            << " write surface { fluid outside; }" << exit(FatalError);
    }

    domain.bounds = makeSizeBounds(controls, time);
    const auto cyclic(cyclicSides(controls.boundary, wall.border.sides));

    if (controls.type == farFieldType::mesh)
    {
        log.begin("readMesh");
        domain.core = files.readCore(controls.region);
        log.end(name(domain.core.nCells) + " cells");
        domain.boundary.cyclicSides = cyclic;
        return domain;
    }

    log.begin("farBoundary");
    domain.boundary = readBoundary(files, far, controls.boundary);
    domain.boundary.cyclicSides = cyclic;

    for (const word& patch : domain.boundary.surface.patchNames)
    {
        requireNotOf(wall, patch);
    }
    log.end
    (
        textOf(controls.boundary.type, domain.boundary.surface.patchNames)
      + boundByWidth(wall, controls, domain.bounds)
    );

    return domain;
}


// * * * * * * * * * * * * * * *  Write Case * * * * * * * * * * * * * * * * //

//- Writes the mesh, in a parallel run all pieces, and drops the layers. Returns
//  what the log says.
//  processes: is set to the costs of a parallel run
static string writeMesh
(
    const parallelRun& parallel,
    const caseWriter& writer,
    autoPtr<caseLayers>& made,
    farFieldMesh& farField,
    const prismCase& files,
    polygonMesh& polygons,
    const planarControls& planar,
    dictionary& processes,
    replacedFiles& replaced
)
{
    if (polygons.mesh.nCells && parallel.isParallel())
    {
        writer.requireDivisible(farField);
        parallel.begin();
        const meshPiece piece(made->makePiece(std::move(polygons)));
        processes = made->costs();
        made.clear();
        writer.writeOwn(piece, replaced);

        return "in parts for all processes";
    }
    if (polygons.mesh.nCells)
    {
        made.clear();
        const label nFaces = polygons.mesh.topology.faces.size();
        writer.writeMesh(files, std::move(polygons.mesh), replaced);

        return name(nFaces) + " faces";
    }
    if (parallel.isParallel())
    {
        if (!farField.empty())
        {
            writer.requireDivisible(farField);
            parallel.begin();
        }
        const meshPiece piece(made->makePiece(farField));
        processes = made->costs();
        made.clear();
        writer.writeOwn(piece, replaced);

        return "in parts for all processes";
    }

    const prismLayers layers(std::move(made->layers()));
    made.clear();
    returnMemory();

    return
        name(writer.writeMesh(layers, farField, planar, replaced)) + " faces";
}


dictionary reportEntries
(
    const layerReport* layers,
    const farFieldReport* far,
    const meshVerdict& verdict
)
{
    dictionary entries;
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
    entries.add("verdict", toDictionary(verdict));

    return entries;
}


//- On the master: writes mesh, outer surface and report. Consumes the layers
//  and the far field. Returns the verdict.
static meshVerdict writeCase
(
    const prismCase& files,
    const parallelRun& parallel,
    const caseWriter& writer,
    const caseWall& given,
    autoPtr<caseLayers>& made,
    farFieldMesh&& farField,
    polygonMesh& polygons,
    const prismLayerControls& controls,
    stageLog& log,
    replacedFiles& replaced
)
{
    layerReport report(made->report());
    const label nPolygonCells = polygons.mesh.nCells;
    const bool hasFarField = !farField.empty();
    writer.writeSurfaces(made->surfaces(), replaced);
    farFieldReport far
    (
        hasFarField
      ? makeFarFieldReport(made->wholeLayers(), farField, controls.quality)
      : farFieldReport()
    );
    if (nPolygonCells)
    {
        reportPolygons(polygons, controls.quality, report, far);
    }

    dictionary processes;
    const string size
    (
        writeMesh
        (
            parallel, writer, made, farField, files, polygons,
            controls.surface.planar, processes, replaced
        )
    );
    log.end(name(report.nCells + far.nCells) + " cells, " + size);
    report.stages = log.costs();

    const farFieldReport* farOrNull = hasFarField ? &far : nullptr;
    const List<verdictLine> wall(1, verdictOnWall(given.prepared.account));
    const meshVerdict verdict(makeVerdict(&report, farOrNull, wall));
    dictionary entries(reportEntries(&report, farOrNull, verdict));
    entries.add("surface", given.entries);
    if (nPolygonCells)
    {
        entries.add("polygons", toDictionary(polygons.counts));
    }
    if (processes.size())
    {
        entries.add("processes", processes);
    }

    entries.add("fields", writer.compareWithFields(files, replaced));
    writer.writeReports(files, entries, replaced);

    return verdict;
}


// * * * * * * * * * * * * * * * *  Mesh Wall  * * * * * * * * * * * * * * * //

//- Returns the largest edges that cells of the far field may have at points.
//  Errors: FatalError if no far field is made whose cells are known before
static scalarField largestCellsAt
(
    const pointField& points,
    const farFieldControls& controls,
    const Time& time
)
{
    if (!controls.isWanted() || controls.type == farFieldType::mesh)
    {
        FatalErrorInFunction
            << "With layers.relativeTo cells, farField.type must be tet or"
            << " hexCore: heights are in units of the cells that are made"
            << exit(FatalError);
    }

    const sizeBounds bounds(makeSizeBounds(controls, time));
    scalarField sizes(points.size(), bounds.largest);
    if (bounds.atPoints)
    {
        sizes = min(sizes, bounds.atPoints(points));
    }

    return sizes;
}


localHeights readLocal
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
    localHeights local
    (
        readLocalHeights
        (
            wall, controls,
            [&](const fileName& file) { return files.surfaceFile(file); },
            time, found
        )
    );
    if (controls.layers.relativeToCells)
    {
        local.largestCells =
            largestCellsAt(wall.points, controls.farField, time);
        found += "\nrelative heights are in units of the far field's cells";
    }
    log.end(found);

    return local;
}


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


autoPtr<caseLayers> makeLayers
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
    autoPtr<caseLayers> made;
    try
    {
        sendOrder(parallel, orderOf(files, controls.farField.boundary));
        const auto draw = [&](const prismLayerMesh& mesh)
        {
            Info<< "Writing VTK files to " << files.reportFolder() << endl;
            writeStageFields(files.reportFolder(), wall, mesh);
        };

        made.reset
        (
            new caseLayers
            (
                parallel, wall, controls, local, log.observer(),
                pictures ? caseLayers::stageViewer(draw) : nullptr
            )
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
    requireUsable(made->report(), controls.layers);

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


//- Makes the far field if it is wanted. Returns the mesh of polygons, without
//  cells if it is not wanted.
static polygonMesh makeCells
(
    const caseLayers& made,
    farFieldDomain&& domain,
    const prismLayerControls& controls,
    farFieldMesh& farField,
    stageLog& log
)
{
    const prismLayers& layers = made.wholeLayers();
    List<sidePatch> sides(layers.border.sides);
    if (controls.farField.isWanted())
    {
        sides = domain.boundary.cyclicSides;
        farField = makeFarField
        (
            layers, std::move(domain), controls.farField, log.observer()
        );
    }
    polygonMesh polygons;
    if (controls.polygons)
    {
        log.begin("polygonCells");
        polygons = makePolygonCells(layers, farField, sides);
        log.end(textOf(polygons.counts));
    }

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
    const Time& time,
    stageLog& log
)
{
    const wallSurface& wall = given.prepared.wall;
    const bool isChanged = given.isChanged;
    if (!isChanged)
    {
        given.prepared.surface = wallSurface();
    }
    const localHeights local(readLocal(files, wall, controls, time, log));
    farFieldDomain domain
    (
        readFarField
        (
            files, wall, given.prepared.far, controls.surface.fluidOutside,
            controls.farField, time, log
        )
    );
    autoPtr<caseLayers> made
    (
        makeLayers(files, parallel, wall, controls, local, pictures, log)
    );
    farFieldMesh farField;
    polygonMesh polygons
    (
        makeCells(*made, std::move(domain), controls, farField, log)
    );
    log.begin("prismPolyMesh");
    meshVerdict verdict;
    replaceFiles([&](replacedFiles& replaced)
    {
        if (isChanged)
        {
            writer.writeSurface(preparedFile, given.prepared.surface, replaced);
        }
        verdict = writeCase
        (
            files, parallel, writer, given, made, std::move(farField),
            polygons, controls, log, replaced
        );
    });
    files.removeRefusal();

    logFiles(files, isChanged ? preparedFile : fileName());
    Foam::write(Info, verdict);
    Info<< endl;
}

} // End namespace Foam

// ************************************************************************* //
