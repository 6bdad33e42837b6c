/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismEntries.H"
#include "boxSides.H"
#include "controlEntries.H"
#include "HashSet.H"
#include "layerEntries.H"
#include "OStringStream.H"
#include "ranges.H"
#include "surfacePart.H"
#include "Tuple2.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * *  Surface  * * * * * * * * * * * * * * * //

//- Whether the surface is open on a side of the box
static bool isOpenOnBox(const snappyCase& given)
{
    const pointField& x = given.walls.surface.points;
    if (!given.box.isFound || x.empty())
    {
        return false;
    }
    const scalar tolerance = 1e-4*boundBox(x, false).mag();
    const List<sidePatch> sides(sidesOf(given.box.bounds));

    return anyOf(outline(given.walls.surface.faces), [&](const edge& e)
    {
        return anyOf(sides, [&](const sidePatch& side)
        {
            return side.hasEdge(x[e.start()], x[e.end()], tolerance);
        });
    });
}


//- Highest level of the entry features; -1 if there is none
static label featureLevel(const dictionary& castellated)
{
    label highest = -1;
    if (!castellated.found("features"))
    {
        return highest;
    }
    const PtrList<dictionary> features(castellated.lookup("features"));
    for (const dictionary& feature : features)
    {
        List<Tuple2<scalar, label>> levels;
        feature.readIfPresent("levels", levels);
        highest = max(highest, feature.getOrDefault<label>("level", -1));
        for (const auto& distanceAndLevel : levels)
        {
            highest = max(highest, distanceAndLevel.second());
        }
    }

    return highest;
}


static dictionary remeshEntries(const snappyCase& given, const word& repair)
{
    const dictionary& castellated =
        given.snappy.subDict("castellatedMeshControls");
    const label level = given.walls.level();
    const label sharp = featureLevel(castellated);
    label finest = max(level, sharp);
    const scalar angle =
        castellated.getOrDefault<scalar>("resolveFeatureAngle", 30);
    const scalar least = repair == "wrap" ? 45 : angle < 10 ? 30 : 10;

    dictionary remesh;
    remesh.add("maxEdge", given.widthAt(level));
    remesh.add("featureAngle", min(max(angle, least), 90.0));
    dictionary patches;
    for (const snappyPatch& patch : given.walls.patches)
    {
        finest = max(finest, patch.finest);
        if (patch.level != level)
        {
            dictionary entry;
            entry.add("maxEdge", given.widthAt(patch.level));
            patches.set(patch.name, entry);
        }
    }
    remesh.add("minEdge", rounded(0.5*given.widthAt(finest)));
    addFilled(remesh, "patches", patches);
    if (sharp > level)
    {
        dictionary edges;
        edges.add("maxEdge", given.widthAt(sharp));
        remesh.add("sharpEdges", edges);
    }

    return remesh;
}


//- Adds what one region without baffles has, and several regions have not.
//  location: a point in the fluid, or null
static void addRepairAndRemesh
(
    const snappyCase& given,
    const bool isFluidInside,
    const point* location,
    dictionary& surface
)
{
    word repair(given.repair);
    if (repair.empty())
    {
        repair = given.isCrossed() ? "stitch" : "none";
    }
    if (location)
    {
        surface.add("inside", *location);
    }
    else
    {
        surface.add("fluid", word("outside"));
    }
    surface.add("repair", repair);
    dictionary wrap;
    if (given.box.hasWidths())
    {
        wrap.add("size", given.widthAt(given.walls.level()));
        surface.add("remesh", remeshEntries(given, repair));
    }
    if (isFluidInside)
    {
        wrap.add("seeds", pointField(1, *location));
    }
    addFilled(surface, "wrapCoeffs", wrap);
}


//- Adds the names of the baffles.
//  Errors: FatalError if a repair is asked for
static void addBaffles
(
    const snappyCase& given,
    dictionary& surface,
    remarkList& remarks
)
{
    const wordList baffles(given.walls.baffles());
    const string names(listed(baffles));
    if (given.repair.size() && given.repair != "none")
    {
        FatalErrorInFunction
            << "-repair " << given.repair << " is not possible: faceType"
            << " baffle of " << names.c_str() << " needs regions, and regions"
            << " have no repair" << nl << "Leave out -repair, or remove"
            << " faceZone of " << names.c_str() << " from refinementSurfaces"
            << exit(FatalError);
    }
    surface.add("baffles", baffles);
    remarks.append
    (
        "The baffles " + names + " need regions, which have no remesh: the"
        " levels of refinementSurfaces are not used, triangles stay as they are"
    );
}


static dictionary surfaceEntries
(
    const snappyCase& given,
    const bool isFluidInside,
    const point* location,
    remarkList& remarks
)
{
    const snappyWalls& walls = given.walls;
    if (given.isCrossed())
    {
        remarks.append("The surface goes through a side of the box");
    }

    dictionary surface;
    surface.add("files", walls.files);
    surface.add("patches", walls.names);
    surface.add("scale", walls.scale);
    if (given.hasBaffles())
    {
        addBaffles(given, surface, remarks);
    }
    else
    {
        addRepairAndRemesh(given, isFluidInside, location, surface);
    }

    return surface;
}


// * * * * * * * * * * * * * * *  The Far Field  * * * * * * * * * * * * * * //

//- Adds regions of the cells that refinementRegions refines in a geometry
static void addRegions
(
    const snappyCase& given,
    const word& name,
    const dictionary& geometry,
    const dictionary& refinement,
    dictionary& regions
)
{
    const word mode(refinement.get<word>("mode"));
    List<Tuple2<scalar, scalar>> levels;
    scalar only = 0;
    if (refinement.readIfPresent("level", only))
    {
        levels.append(Tuple2<scalar, scalar>(GREAT, only));
    }
    refinement.readIfPresent("levels", levels);
    forAll(levels, i)
    {
        const label level = round(levels[i].second());
        if (level < 1 || (mode != "distance" && i > 0))
        {
            continue;
        }
        dictionary region;
        region.add("geometry", geometry);
        region.add("mode", mode);
        if (mode == "distance")
        {
            region.add("distance", levels[i].first());
        }
        region.add("cellSize", given.widthAt(level));
        regions.add(i ? word(name + '_' + Foam::name(i)) : name, region);
    }
}


static dictionary regionEntries(const snappyCase& given, remarkList& remarks)
{
    const dictionary& refined =
        given.snappy.subDict("castellatedMeshControls")
       .subOrEmptyDict("refinementRegions");
    dictionary regions;
    for (const entry& e : given.snappy.subDict("geometry"))
    {
        const word key(e.keyword());
        const word name(e.dict().getOrDefault<word>("name", key));
        const dictionary* refinement = refined.findDict(name, keyType::REGEX);
        if (!refinement)
        {
            continue;
        }
        dictionary geometry(e.dict());
        geometry.remove("name");
        geometry.remove("regions");
        const word type(geometry.get<word>("type"));
        if (type.endsWith("ollection"))
        {
            remarks.append("refinementRegions: " + name + " is a " + type);
            continue;
        }
        if (type.endsWith("riSurfaceMesh") && !geometry.found("file"))
        {
            geometry.add("file", string(key));
        }
        addRegions
        (
            given, word::validate(name, true), geometry, *refinement, regions
        );
    }

    return regions;
}


static dictionary boundaryEntries(const snappyCase& given)
{
    dictionary boundary;
    boundary.add("type", word("box"));
    boundary.add("min", given.box.bounds.min());
    boundary.add("max", given.box.bounds.max());
    boundary.add("patches", given.box.patches);

    return boundary;
}


static dictionary farFieldEntries
(
    const snappyCase& given,
    const bool isFluidInside,
    remarkList& remarks
)
{
    const bool needsDomain =
        !isFluidInside || given.isCrossed() || isOpenOnBox(given);
    if (needsDomain && !given.box.isBox && given.hasBaffles())
    {
        FatalErrorInFunction
            << "faceType baffle of " << listed(given.walls.baffles()).c_str()
            << " needs regions, and regions around bodies need blocks of"
            << " blockMeshDict that fill a box along the axes: "
            << (given.box.isFound ? "they do not" : "there is no blockMeshDict")
            << nl << "Write such a blockMeshDict, or remove the baffles from"
            << " refinementSurfaces" << exit(FatalError);
    }

    dictionary farField;
    if (needsDomain && !given.box.isBox)
    {
        remarks.append
        (
            string(given.box.isFound ? "The blocks fill no box along the axes"
          : "There is no blockMeshDict")
          + ": farField.type mesh needs the mesh of the case. Make it first:"
            " blockMesh, then perhaps snappyHexMesh with castellatedMesh alone."
        );
        farField.add("type", word("mesh"));
    }
    else
    {
        farField.add("type", word("hexCore"));
    }
    if (needsDomain && given.box.isBox)
    {
        farField.add("boundary", boundaryEntries(given));
    }
    const label n = given.snappy.subDict("castellatedMeshControls")
       .getOrDefault<label>("nCellsBetweenLevels", 1);
    farField.add("growthRate", rounded(min(pow(2.0, 1.0/max(n, 1)), 1.3)));
    if (given.box.isFound)
    {
        farField.add("maxCellSize", given.widthAt(0));
    }
    if (given.box.hasWidths())
    {
        addFilled(farField, "regions", regionEntries(given, remarks));
    }

    return farField;
}


static dictionary qualityEntries(const dictionary& asked)
{
    struct bound { word key; scalar low, high, usual; };
    static const List<bound> bounds
    ({
        {"maxNonOrtho", 30, 90, 70}, {"maxInternalSkewness", 1, 100, 4},
        {"minFaceWeight", 0, 0.5, 0.05}, {"minVolRatio", 0, 1, 0.01},
        {"minTetQuality", -1e30, 1, 1e-15}
    });
    dictionary quality;
    for (const bound& b : bounds)
    {
        const scalar x = asked.getOrDefault<scalar>(b.key, b.usual);
        if (x != b.usual)
        {
            quality.add(b.key, min(max(x, b.low), b.high));
        }
    }

    return quality;
}


// * * * * * * * * * * * * *  What is not converted  * * * * * * * * * * * * //

//- Appends the entries of dict whose paths do not match
static void appendOthers
(
    const dictionary& dict,
    const string& path,
    const wordRe& converted,
    remarkList& remarks
)
{
    static const wordHashSet never({"tolerance", "maxTreeDepth", "minQuality"});
    for (const entry& e : dict)
    {
        const string here(path + e.keyword());
        const bool isRead =
            converted.match(here) && !never.found(e.keyword());
        if (!isRead && e.isDict())
        {
            appendOthers(e.dict(), here + '.', converted, remarks);
        }
        else if (!isRead)
        {
            OStringStream text;
            for (const token& t : e.stream())
            {
                text << ' ' << t;
            }
            string line("No counterpart: " + here + text.str());
            remarks.append(line.replaceAll("\n", " "));
        }
    }
}


//- Returns one region around a point.
//  Errors: FatalIOError if castellatedMeshControls does not say the point
static dictionary fluidAt(const dictionary& castellated, const point& location)
{
    if (!castellated.found("locationInMesh"))
    {
        entryError(castellated, "locationInMesh")
            << "faceType baffle needs a point in the fluid" << nl
            << "Write: locationInMesh (x y z);" << exit(FatalIOError);
    }
    dictionary fluid;
    fluid.add("inside", location);
    dictionary regions;
    regions.add("fluid", fluid);

    return regions;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

dictionary prismEntries(const snappyCase& given, remarkList& remarks)
{
    const dictionary& castellated =
        given.snappy.subDict("castellatedMeshControls");
    point location;
    const bool hasLocation =
        castellated.readIfPresent("locationInMesh", location);
    if (hasLocation)
    {
        checkLocation(given.walls, location);
    }
    const bool isInsideOfWall =
        hasLocation && isInside(given.walls.surface, location, given.box);

    dictionary entries;
    entries.add
    (
        "surface",
        surfaceEntries
        (
            given, isInsideOfWall, hasLocation ? &location : nullptr, remarks
        )
    );
    if (given.hasBaffles())
    {
        entries.add("regions", fluidAt(castellated, location));
    }
    entries.add("layers", layerEntries(given, remarks));
    addFilled
    (
        entries, "quality",
        qualityEntries(given.snappy.subOrEmptyDict("meshQualityControls"))
    );
    entries.add("farField", farFieldEntries(given, isInsideOfWall, remarks));

    const wordRe converted
    (
        "castellatedMesh|snap|addLayers|singleRegionName|geometry\\..*\\..*"
        "|castellatedMeshControls\\.(features|resolveFeatureAngle"
        "|locationInMesh|nCellsBetweenLevels"
        "|refinementRegions\\..*\\.(mode|levels|level)"
        "|refinementSurfaces\\..*"
        "\\.(level|faceZone|faceType|cellZone|patchInfo))"
        "|addLayersControls\\.(.*\\.)?(nSurfaceLayers|expansionRatio|thickness"
        "|relativeSizes|firstLayerThickness|finalLayerThickness)"
        "|meshQualityControls\\.(maxNonOrtho|maxInternalSkewness|minFaceWeight"
        "|minVolRatio|minTetQuality)",
        wordRe::REGEX
    );
    appendOthers(given.snappy, "", converted, remarks);

    return entries;
}

} // End namespace Foam

// ************************************************************************* //
