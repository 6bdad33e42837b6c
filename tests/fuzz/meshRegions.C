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


//- The mesh of a region, or an empty one if something is wrong
static polyMeshParts meshOf
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
    prismLayers layers(wallWithoutLayers(wall));
    if (hasLayers)
    {
        prismLayerMesh made
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
        if (!made.certificate.valid())
        {
            tell("failed", "the certificate is not valid");
            return polyMeshParts();
        }
        layers = std::move(made.made.layers);
        const std::string fault(findMeshFault(wall, layers));
        if (fault.size())
        {
            tell("failed", oneLine(fault));
            return polyMeshParts();
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
    farFieldMesh far(makeFarFieldMesh(layers, domain, around));

    return makePrismMeshParts(layers, far);
}


//- The faces between regions, and those on the patches of solids
static labelList wallFaces(const polyMeshParts& mesh)
{
    labelList faces;
    for (const faceZoneParts& zone : mesh.faceZones)
    {
        faces.append(zone.faces);
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


//- What is wrong with the whole mesh; empty if nothing is
static std::string faultOf(const spaceRegions& all, const polyMeshParts& mesh)
{
    const polyMeshTopology& t = mesh.topology;
    const faceList faces(t.faces);
    const labelList owner(t.owner);
    const labelList neighbour(t.neighbour);
    const polyhedralMesh cells(mesh.points, faces, owner, neighbour);
    const meshCertificate certificate
    (
        certifyMesh
        (
            cells, wallFaces(mesh), labelList(), bitSet(mesh.nCells, true)
        )
    );

    // cell::mag adds the magnitudes of pyramids, too many in a concave cell
    const auto volumeOf = [&](const label c)
    {
        scalar volume = 0;
        for (const label f : cells.cellFaces(c))
        {
            volume += cells.pyramidVolume(f, c, cells.centre(c));
        }

        return volume;
    };

    std::ostringstream fault;
    if (certificate.invalidCells.size())
    {
        const label c = certificate.invalidCells[0];
        fault<< certificate.invalidCells.size() << " cells are not positive,"
            << " the first is a "
            << meshCellShapeName[certificate.invalidShapes[0]] << " of volume "
            << volumeOf(c) << " at x = " << cells.centre(c).x() << ' ';
    }
    if (certificate.doubleFaces.size() || !certificate.fillsBoundary())
    {
        fault<< "cells overlap: " << certificate.doubleFaces.size()
            << " faces twice, volume " << certificate.cellVolume
            << ", inside of the boundary " << certificate.boundaryVolume << ' ';
    }
    forAll(all.regions, r)
    {
        scalar volume = 0;
        for (const label c : mesh.cellZones[r].cells)
        {
            volume += volumeOf(c);
        }

        // Sides in single precision are put into planes, which they are not
        if (mag(volume - all.regions[r].volume) > 1e-6*volume)
        {
            fault<< "region " << r << " has the volume " << volume
                << " in place of " << all.regions[r].volume << ' ';
        }
    }

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void meshRegionsCase(const fuzzCase& one, const listener& tell)
{
    const throwingErrors throwing;
    prismLayerControls untold;
    tell("stage", "surface");
    const wallSurface surface(one.make(untold));
    Random random(one.index + 1);
    const prismLayerControls controls(controlsOf(surface, random));
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
    List<polyMeshParts> meshes;
    forAll(all.regions, r)
    {
        try
        {
            meshes.append(meshOf(all, r, controls, hasLayers[r], tell));
            closeRegion(all, r, meshes.last());
        }
        catch (const Foam::error& e)
        {
            tell(isRefusal(e) ? "skipped" : "failed", oneLine(e.message()));
            return;
        }
        if (meshes.last().nCells == 0)
        {
            return;
        }
    }
    tell("stage", "joining");
    const std::string fault(faultOf(all, joinRegions(all, meshes)));
    if (fault.size())
    {
        tell("failed", fault);
    }
}

} // End namespace Foam

// ************************************************************************* //
