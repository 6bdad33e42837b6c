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
#include "meshOrder.H"
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

namespace
{

//- What the mesh is made of: polygons, or layers and far field
struct caseCells
{
    prismLayers layers;
    farFieldMesh farField;
    polygonMesh polygons;
};

} // End anonymous namespace


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


//- Writes the polygons if there are any, otherwise layers and far field.
//  Consumes all. Returns what the log says.
//  processes: see above
static string writeCells
(
    const prismCase& files,
    const parallelRun& parallel,
    const caseWriter& writer,
    caseCells&& cells,
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
    if (!cells.polygons.mesh.nCells)
    {
        return write(meshOrder(cells.layers, cells.farField).mesh());
    }
    meshInBlocks mesh(blocksOf(cells.polygons.mesh));
    mesh.nStackCells = cells.polygons.counts.nLayerCells;
    mesh.nLayers = cells.layers.nLayers;
    cells.layers = prismLayers();
    cells.farField = farFieldMesh();

    return write(mesh);
}


//- On the master: writes mesh, outer surface and report. Consumes the cells.
//  Returns the verdict.
static meshVerdict writeCase
(
    const prismCase& files,
    const parallelRun& parallel,
    const caseWriter& writer,
    const caseWall& given,
    layerReport& report,
    caseCells&& cells,
    const prismLayerControls& controls,
    stageLog& log,
    replacedFiles& replaced
)
{
    const bool hasFarField = !cells.farField.empty();
    writer.writeSurfaces(cells.layers, hasFarField, replaced);
    farFieldReport far;
    if (hasFarField)
    {
        far = makeFarFieldReport
        (
            cells.layers, cells.farField, controls.quality
        );
    }
    dictionary counts;
    if (controls.polygons)
    {
        counts = toDictionary(cells.polygons.counts);
        reportPolygons(cells.polygons, controls.quality, report, far);
    }

    dictionary processes;
    const string size
    (
        writeCells
        (
            files, parallel, writer, std::move(cells),
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
    if (counts.size())
    {
        entries.add("polygons", counts);
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


caseLayers makeLayers
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


//- Makes far field and polygons if they are wanted
static caseCells makeCells
(
    prismLayers&& layers,
    farFieldDomain&& domain,
    const prismLayerControls& controls,
    stageLog& log
)
{
    caseCells cells{std::move(layers), farFieldMesh(), polygonMesh()};
    List<sidePatch> sides(cells.layers.border.sides);
    if (controls.farField.isWanted())
    {
        sides = domain.boundary.cyclicSides;
        cells.farField = makeFarField
        (
            cells.layers, std::move(domain), controls.farField, log.observer()
        );
    }
    if (controls.polygons)
    {
        log.begin("polygonCells");
        cells.polygons = makePolygonCells
        (
            cells.layers, cells.farField, sides
        );
        log.end(textOf(cells.polygons.counts));
    }

    return cells;
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
    caseLayers made
    (
        makeLayers(files, parallel, wall, controls, local, pictures, log)
    );
    caseCells cells
    (
        makeCells(std::move(made.layers), std::move(domain), controls, log)
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
            files, parallel, writer, given, made.report, std::move(cells),
            controls, log, replaced
        );
    });
    files.removeRefusal();

    logFiles(files, isChanged ? preparedFile : fileName());
    Foam::write(Info, verdict);
    Info<< endl;
}

} // End namespace Foam

// ************************************************************************* //
