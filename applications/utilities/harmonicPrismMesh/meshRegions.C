/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshRegions.H"
#include "boundBox.H"
#include "layerStages.H"
#include "OFstream.H"
#include "polygonReport.H"
#include "prepareWall.H"
#include "prismPolyMesh.H"
#include "readRegionControls.H"
#include "readWallSurface.H"
#include "regionMeshes.H"
#include "returnMemory.H"
#include "splitAtSidePatches.H"
#include "stringListOps.H"
#include "surfaceMeasures.H"
#include "surfacePart.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The reports of a region: its layers, its far field, its verdict, and the
//  entries of all
struct regionReport
{
    layerReport layers;
    farFieldReport farField;
    meshVerdict verdict;
    dictionary entries;
};


//- The meshes of regions. By region and face the common polygon, see
//  polygonMesh; empty lists if the meshes have triangles.
struct regionMeshes
{
    List<polyMeshParts> meshes;
    List<labelList> polygons;
};

} // End anonymous namespace


//- Puts points that are nearly in the sides of a box into them. Returns their
//  number.
static label putOnSides(const boundBox& box, pointField& points)
{
    const scalar tolerance = regionTolerance*boundBox(points, false).mag();
    label nMoved = 0;
    for (point& x : points)
    {
        bool isMoved = false;
        for (direction d = 0; d < 3; ++d)
        {
            for (const scalar side : {box.min()[d], box.max()[d]})
            {
                const scalar distance = mag(x[d] - side);
                if (distance > 0 && distance < tolerance)
                {
                    x[d] = side;
                    isMoved = true;
                }
            }
        }
        nMoved += isMoved;
    }

    return nMoved;
}


//- Gives each side of a box two triangles
static void useLargeTriangles(const boundBox& box, farBoundary& sides)
{
    wallSurface& surface = sides.surface;
    surface.points = box.points();
    surface.faces.clear();
    surface.patchIDs.clear();
    forAll(boundBox::faces, side)
    {
        // Normals point into the box
        const face f(boundBox::faces[side].reverseFace());
        surface.faces.append(face({f[0], f[1], f[2]}));
        surface.faces.append(face({f[0], f[2], f[3]}));
        surface.patchIDs.append(labelList(2, sides.boxPatches[side]));
    }
}


static farBoundary makeSides
(
    const prismCase& files,
    const farBoundaryControls& boundary
)
{
    farBoundary sides
    (
        makeFarBoundary
        (
            boundary,
            [&](const fileName& file) { return files.surfaceFile(file); }
        )
    );
    if (boundary.type == farBoundaryType::box)
    {
        useLargeTriangles(boundary.box, sides);
    }

    return sides;
}


static regionsControls readControls(const prismCase& files)
{
    return readRegionControls
    (
        files.dict(),
        [&](const farBoundaryControls& boundary)
        {
            return makeSides(files, boundary);
        }
    );
}


//- Reads the surface of all regions, with the far boundary
static wallSurface readSurface
(
    const prismCase& files,
    const regionsControls& controls,
    stageLog& log
)
{
    log.begin("wallSurface");
    wallReading reading;
    wallSurface surface
    (
        readWallSurface
        (
            files.surfaceFiles(controls.surface), controls.surface, reading
        )
    );
    const string sizes(sizesOf(surface));
    label nMoved = 0;
    if (controls.boundary.type != farBoundaryType::none)
    {
        if (controls.boundary.type == farBoundaryType::box)
        {
            nMoved = putOnSides(controls.boundary.box, surface.points);
        }

        // Where a face is in a side, it is of the side
        wallSurface all(controls.sides.surface);
        appendSurface(surface, labelList(), all);
        surface = all;
    }
    log.end
    (
        sizes
      + (nMoved ? ", " + name(nMoved) + " points put on sides" : string())
    );

    return surface;
}


//- Refuses entries of layers.patches and of surface.baffles that match no patch
static void requirePatches
(
    const regionsControls& controls,
    const wallSurface& surface
)
{
    for (const regionControls& region : controls.regions)
    {
        requirePatches(region.controls.layers, surface.patchNames);
    }
    for (const wordRe& baffle : controls.baffles)
    {
        if (findMatchingStrings(baffle, surface.patchNames).empty())
        {
            FatalErrorInFunction
                << "The entry " << baffle << " of surface.baffles matches no"
                << " patch of the surface" << nl << "Its patches: "
                << flatOutput(surface.patchNames) << exit(FatalError);
        }
    }
}


//- Logs which parts of the files are beside no region.
//  sides: patches of the far boundary
static void logUnused(const spaceRegions& all, const wordList& sides)
{
    const List<unusedArea> areas(unusedAreas(all));
    forAll(areas, patchi)
    {
        const unusedArea& area = areas[patchi];
        const word& patch = all.surface.patchNames[patchi];
        if (area.unused > 0 && !sides.found(patch))
        {
            Info<< "    " << 100*area.unused/area.whole << " % of the patch "
                << patch << " is beside no region, first at " << area.place
                << nl;
        }
    }
    Info<< flush;
}


static spaceRegions makeRegions
(
    const prismCase& files,
    const regionsControls& controls,
    stageLog& log
)
{
    const wallSurface surface(readSurface(files, controls, log));
    requirePatches(controls, surface);

    log.begin("spaceRegions");
    List<regionSeed> seeds;
    for (const regionControls& region : controls.regions)
    {
        seeds.append(region.seed);
    }
    const scalar tolerance =
        max(regionTolerance, controls.surface.mergeTolerance);
    spaceRegions all
    (
        makeSpaceRegions
        (
            makeArrangement(surface, tolerance), seeds, controls.baffles,
            tolerance
        )
    );
    forAll(all.regions, r)
    {
        const regionControls& asked = controls.regions[r];
        all.open
        (
            r,
            [&](const word& patch)
            {
                return asked.controls.layers.isSide(patch);
            },
            asked.hasLayers ? layerOpening : tetOpening
        );
    }
    log.end(name(all.surface.faces.size()) + " faces");

    forAll(all.regions, r)
    {
        const spaceRegion& region = all.regions[r];
        Info<< "    " << region.name
            << (controls.regions[r].hasLayers ? "" : ", without layers")
            << ": " << region.surface.faces.size() << " faces, volume "
            << region.volume << " m3" << nl;
    }
    logUnused(all, controls.sides.surface.patchNames);

    return all;
}


//- Whether triangles are all of the far boundary
static bool isWhole(const wallSurface& far, const farBoundary& whole)
{
    static constexpr scalar rounding = 1e-9;
    const scalar area = measuresOf(whole.surface).area;

    return mag(measuresOf(far).area - area) < rounding*area;
}


//- The domain of a region, and its controls with this far boundary
static farFieldDomain readDomain
(
    const prismCase& files,
    const regionWall& walls,
    const regionsControls& all,
    const Time& time,
    prismLayerControls& controls,
    stageLog& log
)
{
    farBoundaryControls& boundary = controls.farField.boundary;
    const bool isAlone = walls.far.faces.empty();
    const bool isAround = !isAlone && isWhole(walls.far, all.sides);
    if (isAround)
    {
        boundary = all.boundary;
    }
    const bool isOwn = !isAlone && !isAround;
    if (isOwn)
    {
        boundary.type = farBoundaryType::surface;
    }

    return readFarField
    (
        files, walls.wall, isOwn ? walls.far : wallSurface(), !isAlone,
        controls.farField, time, log
    );
}


//- Makes layers and far field of a region
static regionParts makeParts
(
    const prismCase& files,
    const parallelRun& parallel,
    spaceRegions& all,
    const label regioni,
    const regionsControls& allControls,
    const Time& time,
    regionReport& reports,
    stageLog& log
)
{
    Info<< nl << "Region " << all.regions[regioni].name << nl << endl;
    const regionControls& asked = allControls.regions[regioni];
    prismLayerControls controls(asked.controls);
    const label nStages = log.costs().size();
    const regionWall walls(prepareRegion(all, regioni, controls));
    const wallSurface& wall = walls.wall;
    farFieldDomain domain
    (
        readDomain(files, walls, allControls, time, controls, log)
    );

    regionParts made;
    prismLayers& layers = made.layers;
    layerReport& report = reports.layers;
    if (asked.hasLayers)
    {
        const localHeights local(readLocal(files, wall, controls, time, log));
        caseLayers made
        (
            makeLayers(files, parallel, wall, controls, local, false, log)
        );
        report = made.report;
        layers = std::move(made.layers);
    }
    else
    {
        layers = wallWithoutLayers(wall);
    }

    made.common = commonTrianglesOf(all, regioni, wall);
    made.farField = makeFarField
    (
        layers, std::move(domain), controls.farField, log.observer()
    );
    reports.farField =
        makeFarFieldReport(layers, made.farField, controls.quality);
    report.stages = SubList<stageCost>
    (
        log.costs(), log.costs().size() - nStages, nStages
    );

    return made;
}


//- Sets the entries of the report of a region, and writes the report to the log
static void setEntries(const bool hasLayers, regionReport& report)
{
    const layerReport* layers = hasLayers ? &report.layers : nullptr;
    report.verdict = makeVerdict(layers, &report.farField);
    report.entries = reportEntries(layers, &report.farField, report.verdict);
}


//- Makes the mesh of a region
static polyMeshParts makeMesh
(
    spaceRegions& all,
    const label regioni,
    regionParts&& region
)
{
    const prismLayers layers(std::move(region.layers));
    farFieldMesh farField(std::move(region.farField));
    polyMeshParts mesh(makePrismMeshParts(layers, farField));
    closeRegion(all, regioni, mesh);

    return mesh;
}


//- Makes the meshes of polygons of all regions, and sets their reports
static regionMeshes makePolygons
(
    const regionsControls& controls,
    spaceRegions& all,
    std::vector<regionParts>& regions,
    List<regionReport>& reports,
    stageLog& log
)
{
    log.begin("polygonCells");
    List<polygonMesh> polygons(makePolygonRegions(all, regions));
    regions.clear();
    string text;
    forAll(polygons, r)
    {
        text +=
            '\n' + all.regions[r].name + ": " + textOf(polygons[r].counts);
    }
    log.end(text);

    regionMeshes made;
    forAll(polygons, r)
    {
        const regionControls& asked = controls.regions[r];
        reportPolygons
        (
            polygons[r], asked.controls.quality, reports[r].layers,
            reports[r].farField
        );
        Info<< nl << "Region " << all.regions[r].name << nl << endl;
        setEntries(asked.hasLayers, reports[r]);
        reports[r].entries.add("polygons", toDictionary(polygons[r].counts));
        made.meshes.append(std::move(polygons[r].mesh));
        made.polygons.append(polygons[r].commonPolygons);
    }

    return made;
}


//- Makes the meshes of all regions, and sets their reports
static regionMeshes makeMeshes
(
    const prismCase& files,
    const parallelRun& parallel,
    const regionsControls& controls,
    const Time& time,
    spaceRegions& all,
    List<regionReport>& reports,
    stageLog& log
)
{
    const bool arePolygons = controls.regions[0].controls.polygons;
    std::vector<regionParts> regions;
    regionMeshes made;
    forAll(all.regions, r)
    {
        const prismCase regionFiles(files, all.regions[r].name);
        regionParts region
        (
            makeParts
            (
                regionFiles, parallel, all, r, controls, time, reports[r], log
            )
        );
        if (arePolygons)
        {
            regions.push_back(std::move(region));
            continue;
        }
        setEntries(controls.regions[r].hasLayers, reports[r]);
        made.meshes.append(makeMesh(all, r, std::move(region)));
        made.polygons.append(labelList());
        returnMemory();
    }

    return
        arePolygons
      ? makePolygons(controls, all, regions, reports, log) : made;
}


//- Writes the list of regions: a region with layers is a fluid
static void writeRegions
(
    const regionsControls& controls,
    const fileName& target,
    replacedFiles& files
)
{
    const fileName file(files.scratch(target, target.name())/target.name());
    string fluids;
    string solids;
    for (const regionControls& region : controls.regions)
    {
        (region.hasLayers ? fluids : solids) += ' ' + region.seed.name;
    }

    OFstream os(file);
    IOobject::writeBanner(os);
    os  << "FoamFile" << nl << "{" << nl
        << "    version     2.0;" << nl
        << "    format      ascii;" << nl
        << "    class       dictionary;" << nl
        << "    object      " << target.name() << ";" << nl << "}" << nl;
    IOobject::writeDivider(os);
    os  << nl << "regions" << nl << "(" << nl
        << "    fluid       (" << fluids.c_str() << " )" << nl
        << "    solid       (" << solids.c_str() << " )" << nl
        << ");" << nl << nl;
    IOobject::writeEndDivider(os);
    os.flush();
    checkEnd(file, "* //");
}


static void writeMeshes
(
    const prismCase& files,
    const caseWriter& writer,
    const spaceRegions& all,
    const regionsControls& controls,
    const bool areApart,
    regionMeshes& made,
    replacedFiles& replaced
)
{
    if (!areApart)
    {
        const polyMeshParts joined
        (
            joinRegions(all, made.meshes, made.polygons)
        );
        writer.writeMesh(files, blocksOf(joined), planarControls(), replaced);
        return;
    }

    separateRegions(all, made.meshes, made.polygons);
    forAll(made.meshes, r)
    {
        writer.writeMesh
        (
            prismCase(files, all.regions[r].name), blocksOf(made.meshes[r]),
            planarControls(), replaced
        );
    }
    if (!isFile(files.regionsFile()))
    {
        writeRegions(controls, files.regionsFile(), replaced);
    }
}


//- Writes the reports of regions, each with the fields of its mesh
static void writeReports
(
    const prismCase& files,
    const caseWriter& writer,
    const spaceRegions& all,
    const bool areApart,
    const List<regionReport>& reports,
    replacedFiles& replaced
)
{
    dictionary fields;
    if (!areApart)
    {
        fields = writer.compareWithFields(files, replaced);
    }
    forAll(all.regions, r)
    {
        const prismCase region(files, all.regions[r].name);
        if (areApart)
        {
            fields = writer.compareWithFields(region, replaced);
        }
        dictionary entries(reports[r].entries);
        entries.add("fields", fields);
        writer.writeReports(region, entries, replaced);
    }
}


static void logMeshes
(
    const prismCase& files,
    const regionsControls& controls,
    const bool areApart
)
{
    fileNameList folders;
    if (!areApart)
    {
        folders.append(files.polyMeshFolder());
    }
    for (label r = 0; areApart && r < controls.regions.size(); ++r)
    {
        const word& name = controls.regions[r].seed.name;
        folders.append(prismCase(files, name).polyMeshFolder());
    }

    Info<< nl;
    for (const fileName& folder : folders)
    {
        Info<< "Mesh:   " << folder << nl;
    }
    Info<< endl;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void meshRegions
(
    const prismCase& files,
    const parallelRun& parallel,
    const caseWriter& writer,
    const bool areApart,
    const Time& time,
    stageLog& log
)
{
    const regionsControls controls(readControls(files));
    const fileNameList surfaces(files.surfaceFiles(controls.surface));
    for (const regionControls& region : controls.regions)
    {
        (areApart ? prismCase(files, region.seed.name) : files)
            .checkOverwrite(surfaces, region.controls.farField, 0);
    }

    spaceRegions all(makeRegions(files, controls, log));
    List<regionReport> reports(all.regions.size());
    regionMeshes made
    (
        makeMeshes(files, parallel, controls, time, all, reports, log)
    );

    log.begin("regionMeshes");
    replaceFiles([&](replacedFiles& replaced)
    {
        writeMeshes
        (
            files, writer, all, controls, areApart, made, replaced
        );
        writeReports(files, writer, all, areApart, reports, replaced);
    });
    log.end(areApart ? "each region apart" : "one mesh");
    files.removeRefusal();
    logMeshes(files, controls, areApart);
    forAll(reports, r)
    {
        prismCase(files, all.regions[r].name).removeRefusal();
        Info<< all.regions[r].name << ": ";
        write(Info, reports[r].verdict);
    }
    Info<< endl;
}

} // End namespace Foam

// ************************************************************************* //
