/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshRegions.H"
#include "boundBox.H"
#include "makeFarFieldMesh.H"
#include "meshCertificate.H"
#include "meshFaults.H"
#include "prepareWall.H"
#include "prismLayerMesh.H"
#include "prismPolyMesh.H"
#include "regionMeshes.H"
#include "spaceParts.H"
#include "testSurfaces.H"
#include "throwingErrors.H"
#include "wallPointsError.H"

#include <sstream>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A point in each bounded part of space within the box, of so many random
//  points
static List<regionSeed> seedsOf
(
    const wallSurface& surface,
    const wallSurface& around,
    Random& random
)
{
    static constexpr label nPoints = 300;
    const spaceParts parts(surface);
    const spaceParts inBox(around);
    const boundBox box(around.points, false);
    labelList isKnown(parts.nParts(), Zero);
    isKnown[0] = 1;
    List<regionSeed> seeds;
    for (label i = 0; i < nPoints; ++i)
    {
        vector share;
        for (direction d = 0; d < 3; ++d)
        {
            share[d] = random.sample01<scalar>();
        }
        const point x(box.min() + cmptMultiply(share, box.span()));
        if (inBox.partAt(x) == 0)
        {
            continue;
        }
        label& known = isKnown[parts.partAt(x)];
        if (!known++)
        {
            seeds.append(regionSeed{"region" + name(seeds.size()), x});
        }
    }

    return seeds;
}


//- The regions of a surface: all parts of space in the patch box
static spaceRegions regionsOf(const wallSurface& surface, Random& random)
{
    const wallSurface arrangement(makeArrangement(surface));
    const bitSet isBox
    (
        findIndices(surface.patchIDs, surface.patchNames.find("box"))
    );
    wallSurface box(surface);
    keepFaces(isBox, box);

    return makeSpaceRegions
    (
        arrangement, seedsOf(arrangement, makeArrangement(box), random),
        wordRes(List<wordRe>({wordRe("sheet")}))
    );
}


//- Opens all regions. Returns which ones get layers
static boolList openAll(spaceRegions& all, Random& random)
{
    boolList hasLayers(all.regions.size());
    forAll(hasLayers, r)
    {
        hasLayers[r] = randomSurfaces::chance(random, 0.5);
        all.open
        (
            r,
            [](const word& patch) { return patch == "box"; },
            hasLayers[r] ? layerOpening : tetOpening
        );
    }

    return hasLayers;
}


//- Layers and far field of a region, without cells if something is wrong
static regionParts partsOf
(
    spaceRegions& all,
    const label regioni,
    const prismLayerControls& controls,
    const bool hasLayers,
    const listener& tell
)
{
    const regionWall walls(prepareRegion(all, regioni, controls));
    const wallSurface& wall = walls.wall;
    regionParts made;
    made.common = commonTrianglesOf(all, regioni, wall);
    prismLayers& layers = made.layers;
    layers = wallWithoutLayers(wall);
    if (hasLayers)
    {
        prismLayerMesh run
        (
            makePrismLayerMesh
            (
                wall, controls, localHeights(),
                stageObserver
                {
                    [&](const word& stage) { tell("stage", stage); },
                    [](const string&) {}
                }
            )
        );
        if (!run.certificate.valid())
        {
            tell("failed", "the certificate is not valid");
            return made;
        }
        layers = std::move(run.made.layers);
        const std::string fault(findMeshFault(wall, layers));
        if (fault.size())
        {
            tell("failed", oneLine(fault));
            return made;
        }
    }
    tell("stage", "far field of " + all.regions[regioni].name);
    farFieldDomain domain;
    farFieldControls around(controls.farField);
    if (walls.far.faces.size())
    {
        domain.boundary = makeFarBoundary(walls.far);
        around.boundary.type = farBoundaryType::surface;
    }
    made.farField = makeFarFieldMesh(layers, domain, around);

    return made;
}


//- The faces on the patches of solids, and those between regions: stacks on
//  these are counted. They would go around in polyhedra.
static labelList wallFaces(const polyMeshParts& mesh, const bool hasPolygons)
{
    labelList faces;
    for (const faceZoneParts& zone : mesh.faceZones)
    {
        faces.append(hasPolygons ? labelList() : zone.faces);
    }
    forAll(mesh.patches.names, patchi)
    {
        if (mesh.patches.names[patchi] != "box")
        {
            faces.append
            (
                identity
                (
                    mesh.topology.patchSizes[patchi],
                    mesh.topology.patchStarts[patchi]
                )
            );
        }
    }

    return faces;
}


//- The volume [m3] of a cell. cell::mag adds the magnitudes of pyramids, too
//  many in a concave cell
static scalar volumeOf(const polyhedralMesh& cells, const label celli)
{
    scalar volume = 0;
    for (const label f : cells.cellFaces(celli))
    {
        volume += cells.pyramidVolume(f, celli, cells.centre(celli));
    }

    return volume;
}


//- The regions that do not have their volume but for a share of it
static std::string volumeFault
(
    const spaceRegions& all,
    const polyMeshParts& mesh,
    const polyhedralMesh& cells,
    const scalar share
)
{
    std::ostringstream fault;
    forAll(all.regions, r)
    {
        scalar volume = 0;
        for (const label c : mesh.cellZones[r].cells)
        {
            volume += volumeOf(cells, c);
        }
        if (mag(volume - all.regions[r].volume) > share*volume)
        {
            fault<< "region " << r << " has the volume " << volume
                << " in place of " << all.regions[r].volume << ' ';
        }
    }

    return fault.str();
}


//- What is wrong with the whole mesh; empty if nothing is
static std::string faultOf
(
    const spaceRegions& all,
    const polyMeshParts& mesh,
    const bool hasPolygons
)
{
    // Sides in single precision are put into planes, which they are not.
    // Polygons lose points of walls.
    static constexpr scalar ofTriangles = 1e-6;
    static constexpr scalar ofPolygons = 0.5;

    const polyMeshTopology& t = mesh.topology;
    const faceList faces(t.faces);
    const labelList owner(t.owner);
    const labelList neighbour(t.neighbour);
    const polyhedralMesh cells(mesh.points, faces, owner, neighbour);
    const meshCertificate certificate
    (
        certifyMesh
        (
            cells, wallFaces(mesh, hasPolygons), labelList(),
            bitSet(mesh.nCells, true)
        )
    );

    std::ostringstream fault;
    if (certificate.invalidCells.size())
    {
        const label c = certificate.invalidCells[0];
        fault<< certificate.invalidCells.size() << " cells are not positive,"
            << " the first is a "
            << meshCellShapeName[certificate.invalidShapes[0]] << " of volume "
            << volumeOf(cells, c) << " at x = " << cells.centre(c).x() << ' ';
    }
    if (certificate.doubleFaces.size() || !certificate.fillsBoundary())
    {
        fault<< "cells overlap: " << certificate.doubleFaces.size()
            << " faces twice, volume " << certificate.cellVolume
            << ", inside of the boundary " << certificate.boundaryVolume << ' ';
    }
    fault<< volumeFault
    (
        all, mesh, cells, hasPolygons ? ofPolygons : ofTriangles
    );

    return fault.str();
}


//- Whether an error names places where there can be no layers, or no room for
//  a far field
static bool isRefusal(const Foam::error& e)
{
    const std::string message(e.message());
    const auto has = [&](const char* words)
    {
        return message.find(words) != std::string::npos;
    };

    return
        dynamic_cast<const wallPointsError*>(&e)
     || has("boundary cuts the layers")
     || has("Walls are too near to each other there")
     || has("all of its patches are to have no layers")
     || has("crosses another edge of its side")
     || has("More than two side patches meet");
}


//- Works. Returns false if the work fails, and tells why.
template<class Work>
static bool isDone(const Work& work, const listener& tell)
{
    try
    {
        work();
        return true;
    }
    catch (const Foam::error& e)
    {
        tell(isRefusal(e) ? "skipped" : "failed", oneLine(e.message()));
        return false;
    }
}


static prismLayerControls controlsOf(const wallSurface& surface, Random& random)
{
    prismLayerControls controls;
    heightEntries& heights = controls.layers.heights;
    heights.nSurfaceLayers = random.position<label>(1, 6);
    heights.thickness =
        boundBox(surface.points, false).mag()
       *randomSurfaces::logUniform(random, 2e-3, 0.1);
    heights.expansionRatio = random.position<scalar>(1, 1.4);
    patchLayers box;
    box.patches = word("box");
    box.isSide = true;
    controls.layers.patches.append(box);
    controls.surface.fluidOutside = false;
    controls.farField.type = farFieldType::tet;
    controls.farField.growthRate = 1.5;

    return controls;
}


//- Makes the mesh of all regions. Returns what is wrong with it; empty if
//  nothing is, or if somebody was told.
static std::string faultOfTriangles
(
    spaceRegions& all,
    const prismLayerControls& controls,
    const boolList& hasLayers,
    const listener& tell
)
{
    List<polyMeshParts> meshes;
    forAll(all.regions, r)
    {
        regionParts made;
        const bool isMade = isDone
        (
            [&]()
            {
                made = partsOf(all, r, controls, hasLayers[r], tell);
                meshes.append(makePrismMeshParts(made.layers, made.farField));
                closeRegion(all, r, meshes.last());
            },
            tell
        );
        if (!isMade || meshes.last().nCells == 0)
        {
            return "";
        }
    }
    tell("stage", "joining");

    return faultOf
    (
        all, joinRegions(all, meshes, List<labelList>(meshes.size())), false
    );
}


//- The same with polygons
static std::string faultOfPolygons
(
    spaceRegions& all,
    const prismLayerControls& controls,
    const boolList& hasLayers,
    const listener& tell
)
{
    std::vector<regionParts> regions(all.regions.size());
    forAll(all.regions, r)
    {
        const bool isMade = isDone
        (
            [&]()
            {
                regions[r] = partsOf(all, r, controls, hasLayers[r], tell);
            },
            tell
        );
        if (!isMade || regions[r].farField.empty())
        {
            return "";
        }
    }
    tell("stage", "polygons");
    List<polyMeshParts> meshes;
    List<labelList> polygons;
    for (polygonMesh& made : makePolygonRegions(all, regions))
    {
        meshes.append(std::move(made.mesh));
        polygons.append(made.commonPolygons);
    }
    tell("stage", "joining");

    return faultOf(all, joinRegions(all, meshes, polygons), true);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void meshRegionsCase(const fuzzCase& one, const listener& tell)
{
    const throwingErrors throwing;
    prismLayerControls untold;
    tell("stage", "surface");
    const wallSurface surface(one.make(untold));
    Random random(one.index + 1);
    prismLayerControls controls(controlsOf(surface, random));
    controls.farField.forPolygons = one.hasPolygons;
    spaceRegions all;
    tell("stage", "regions");
    try
    {
        all = regionsOf(surface, random);
    }
    catch (const Foam::error& e)
    {
        tell("skipped", oneLine(e.message()));
        return;
    }
    if (all.regions.empty())
    {
        tell("skipped", "no point is in the box and in a bounded part");
        return;
    }

    boolList hasLayers;
    try
    {
        hasLayers = openAll(all, random);
    }
    catch (const Foam::error& e)
    {
        tell("skipped", oneLine(e.message()));
        return;
    }
    const std::string fault
    (
        one.hasPolygons
      ? faultOfPolygons(all, controls, hasLayers, tell)
      : faultOfTriangles(all, controls, hasLayers, tell)
    );
    if (fault.size())
    {
        tell("failed", fault);
    }
}

} // End namespace Foam

// ************************************************************************* //
