/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshRegions.H"
#include "OFstream.H"
#include "polygonReport.H"
#include "prepareWall.H"
#include "prismPolyMesh.H"
#include "regionMeshes.H"
#include "regionStages.H"
#include "returnMemory.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The meshes of regions. By region and face the common polygon, see
//  polygonMesh; empty lists if the meshes have triangles.
struct regionMeshes
{
    List<polyMeshParts> meshes;
    List<labelList> polygons;
};

} // End anonymous namespace


//- Makes layers and far field of a region
static regionParts makeParts
(
    const prismCase& files,
    const parallelRun& parallel,
    spaceRegions& all,
    const label regioni,
    const regionsControls& allControls,
    regionReport& reports,
    stageLog& log
)
{
    Info<< nl << "Region " << all.regions[regioni].name << nl << endl;
    const regionControls& asked = allControls.regions[regioni];
    prismLayerControls controls(asked.controls);
    const caseSources sources(files.sources());
    const label nStages = log.costs().size();
    const regionWall walls(prepareRegion(all, regioni, controls));
    const wallSurface& wall = walls.wall;
    farFieldDomain domain
    (
        readDomain(sources, walls, allControls, controls, log.observer())
    );

    localHeights local;
    if (asked.hasLayers)
    {
        local = readLocal(sources, wall, controls, log.observer());
    }
    regionParts made
    (
        makeRegion
        (
            files, parallel, wall, controls, asked.hasLayers ? &local : nullptr,
            std::move(domain), false, reports, log
        )
    );
    made.common = commonTrianglesOf(all, regioni, wall);
    reports.layers.stages = SubList<stageCost>
    (
        log.costs(), log.costs().size() - nStages, nStages
    );

    return made;
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
        setEntries(asked.hasLayers, true, {}, reports[r]);
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
                regionFiles, parallel, all, r, controls, reports[r], log
            )
        );
        if (arePolygons)
        {
            regions.push_back(std::move(region));
            continue;
        }
        setEntries(controls.regions[r].hasLayers, true, {}, reports[r]);
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
    stageLog& log
)
{
    const regionsControls controls(readRegions(files.dict(), files.sources()));
    const fileNameList surfaces(files.surfaceFiles(controls.surface));
    for (const regionControls& region : controls.regions)
    {
        (areApart ? prismCase(files, region.seed.name) : files)
            .checkOverwrite(surfaces, region.controls.farField, 0);
    }

    spaceRegions all(makeRegions(surfaces, controls, log.observer()));
    List<regionReport> reports(all.regions.size());
    regionMeshes made
    (
        makeMeshes(files, parallel, controls, all, reports, log)
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
