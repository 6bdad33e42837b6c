/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismEntries.H"
#include "boxSides.H"
#include "HashSet.H"
#include "OStringStream.H"
#include "ranges.H"
#include "surfacePart.H"
#include "Tuple2.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A number of four digits
static scalar rounded(const scalar x)
{
    const scalar unit = pow(10.0, floor(log10(mag(x) + VSMALL)) - 3);

    return std::round(x/unit)*unit;
}


//- Adds a dictionary that is not empty
static void addFilled(dictionary& dict, const word& key, const dictionary& sub)
{
    if (sub.size())
    {
        dict.add(key, sub);
    }
}


//- Width of snappyHexMesh's cells of a level [m]
static scalar widthAt(const snappyCase& given, const label level)
{
    return rounded(given.box.width/pow(2.0, level));
}


// * * * * * * * * * * * * * * * * *  Surface  * * * * * * * * * * * * * * * //

//- Whether the surface goes through a side of the box
static bool isCrossed(const snappyCase& given)
{
    const boundBox bounds(given.walls.surface.points, false);

    return
        given.box.isBox
     && !widened(given.box.bounds, 1e-4*bounds.mag()).contains(bounds);
}


//- Whether the surface is open on a side of the box
static bool isOpenOnBox(const snappyCase& given)
{
    const pointField& x = given.walls.surface.points;
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
    remesh.add("maxEdge", widthAt(given, level));
    remesh.add("featureAngle", min(max(angle, least), 90.0));
    dictionary patches;
    for (const snappyPatch& patch : given.walls.patches)
    {
        finest = max(finest, patch.finest);
        if (patch.level != level)
        {
            dictionary entry;
            entry.add("maxEdge", widthAt(given, patch.level));
            patches.set(patch.name, entry);
        }
    }
    remesh.add("minEdge", rounded(0.5*widthAt(given, finest)));
    addFilled(remesh, "patches", patches);
    if (sharp > level)
    {
        dictionary edges;
        edges.add("maxEdge", widthAt(given, sharp));
        remesh.add("sharpEdges", edges);
    }

    return remesh;
}


static dictionary surfaceEntries
(
    const snappyCase& given,
    const bool isFluidInside,
    const point& location,
    remarkList& remarks
)
{
    const snappyWalls& walls = given.walls;
    word repair(given.repair);
    if (isCrossed(given))
    {
        remarks.append("The surface goes through a side of the box");
    }
    if (repair.empty())
    {
        repair = isCrossed(given) ? "stitch" : "none";
    }

    dictionary surface;
    surface.add("files", walls.files);
    surface.add("patches", walls.names);
    surface.add("fluid", word(isFluidInside ? "inside" : "outside"));
    surface.add("scale", walls.scale);
    surface.add("repair", repair);
    dictionary wrap;
    if (given.box.hasWidths())
    {
        wrap.add("size", widthAt(given, walls.level()));
        surface.add("remesh", remeshEntries(given, repair));
    }
    if (isFluidInside)
    {
        wrap.add("seeds", pointField(1, location));
    }
    addFilled(surface, "wrapCoeffs", wrap);

    return surface;
}


// * * * * * * * * * * * * * * * * * Layers  * * * * * * * * * * * * * * * * //

//- The last entry of layers that matches a patch; nullptr if there is none
static const entry* layersOf(const dictionary& layers, const snappyPatch& patch)
{
    wordList names(patch.groups);
    names.append(patch.name);
    const entry* last = nullptr;
    for (const entry& e : layers)
    {
        for (const word& name : names)
        {
            last = e.isDict() && e.keyword().match(name) ? &e : last;
        }
    }

    return last;
}


//- Heights of the layers of a patch, in metres
static dictionary heightsOf
(
    const snappyCase& given,
    const dictionary& controls,
    const dictionary& own,
    const label level
)
{
    static const wordList keys
    ({
        "firstLayerThickness", "finalLayerThickness", "thickness",
        "expansionRatio"
    });
    const bool isRelative = own.getOrDefault<bool>
    (
        "relativeSizes", controls.getOrDefault<bool>("relativeSizes", true)
    );
    const bool hasWidth = given.box.isFound;
    const scalar unit =
        isRelative && hasWidth ? given.box.shortest/pow(2.0, level) : 1;

    dictionary heights;
    for (const word& key : keys)
    {
        scalar value = 0;
        if (controls.readIfPresent(key, value))
        {
            own.readIfPresent(key, value);
            heights.add
            (
                key, key == "expansionRatio" ? value : rounded(unit*value)
            );
        }
    }
    if (isRelative && !hasWidth)
    {
        heights.add("relativeSizes", true);
    }

    return heights;
}


//- Entries of a patch
//  n: number of layers, if snappyHexMesh makes none
static dictionary patchEntries
(
    const snappyCase& given,
    const snappyPatch& patch,
    const label n,
    remarkList& remarks
)
{
    const dictionary& controls = given.snappy.subDict("addLayersControls");
    const entry* found = layersOf(controls.subDict("layers"), patch);
    const dictionary own(found ? found->dict() : dictionary());
    const label nOwn = own.getOrDefault<label>("nSurfaceLayers", 0);
    const bool isSide = nOwn == 0 && patch.type != "wall";

    dictionary entries;
    entries.add("nSurfaceLayers", isSide ? 0 : nOwn ? nOwn : n);
    if (!isSide)
    {
        entries.merge(heightsOf(given, controls, own, patch.level));
    }
    if (patch.type != (isSide ? "patch" : "wall"))
    {
        entries.add("type", patch.type);
    }
    if (!isSide && nOwn == 0)
    {
        remarks.append("All walls have layers here, also " + patch.name);
    }

    return entries;
}


//- Says which entries of layers are of no patch of the surface. Returns the
//  largest number of layers, 3 if there are none.
static label checkLayers(const snappyCase& given, remarkList& remarks)
{
    const dictionary& layers =
        given.snappy.subDict("addLayersControls").subDict("layers");
    label n = 0;
    for (const entry& e : layers)
    {
        bool isUsed = false;
        for (const snappyPatch& patch : given.walls.patches)
        {
            isUsed = isUsed || layersOf(layers, patch) == &e;
        }
        for (const word& name : given.box.names)
        {
            if (e.keyword().match(name))
            {
                remarks.append
                (
                    "No layers on " + name + ", a side of the box: for layers"
                    " there, add a surface file of the side"
                );
                isUsed = true;
            }
        }
        if (!isUsed)
        {
            remarks.append("Layers of no patch here: " + e.keyword());
        }
        n = max(n, e.dict().get<label>("nSurfaceLayers"));
    }
    if (!given.snappy.getOrDefault<bool>("addLayers", true))
    {
        remarks.append("addLayers is false: the layers are made here");
    }
    if (n == 0)
    {
        remarks.append("snappyHexMeshDict asks for no layers: 3 are a guess");
    }

    return n > 0 ? n : 3;
}


//- Returns layers: it has the entries of the largest patch
static dictionary layerEntries(const snappyCase& given, remarkList& remarks)
{
    const List<snappyPatch>& walls = given.walls.patches;
    const label n = checkLayers(given, remarks);
    List<dictionary> entries(walls.size());
    label largest = -1;
    forAll(walls, i)
    {
        entries[i] = patchEntries(given, walls[i], n, remarks);
        if
        (
            entries[i].get<label>("nSurfaceLayers") > 0
         && (largest < 0 || walls[i].area > walls[largest].area)
        )
        {
            largest = i;
        }
    }
    if (largest < 0)
    {
        FatalErrorInFunction
            << "No patch of the surface is of type wall" << exit(FatalError);
    }

    dictionary layers(entries[largest]);
    layers.remove("type");
    dictionary patches;
    forAll(walls, i)
    {
        if (entries[i] != layers)
        {
            patches.set(walls[i].name, entries[i]);
        }
    }
    addFilled(layers, "patches", patches);

    return layers;
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
    const List<Tuple2<scalar, scalar>> levels(refinement.lookup("levels"));
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
        region.add("cellSize", widthAt(given, level));
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
        !isFluidInside || isCrossed(given) || isOpenOnBox(given);

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
        farField.add("maxCellSize", widthAt(given, 0));
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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

dictionary prismEntries(const snappyCase& given, remarkList& remarks)
{
    const dictionary& castellated =
        given.snappy.subDict("castellatedMeshControls");
    point location;
    const bool isInsideOfWall =
        castellated.readIfPresent("locationInMesh", location)
     && isInside(given.walls.surface, location, given.box);

    dictionary entries;
    entries.add
    (
        "surface", surfaceEntries(given, isInsideOfWall, location, remarks)
    );
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
        "|refinementRegions\\..*\\.(mode|levels)"
        "|refinementSurfaces\\..*\\.(level|faceZone|cellZone|patchInfo))"
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
