/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readControls.H"
#include "Enum.H"
#include "ranges.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

const wordList geometryRegionKeys
({
    "geometry", "mode", "distance"
});

static const Enum<geometryRegion::modes> modeNames
({
    {Foam::geometryRegion::modes::inside, "inside"},
    {Foam::geometryRegion::modes::outside, "outside"},
    {Foam::geometryRegion::modes::distance, "distance"}
});


geometryRegion readGeometryRegion(const dictionary& dict)
{
    geometryRegion region;
    region.name = dict.dictName();
    region.geometry = mandatoryDict(dict, "geometry");

    word mode(modeNames[region.mode]);
    readChoice(dict, "mode", modeNames.names(), mode);
    region.mode = modeNames[mode];

    const bool hasDistance =
        readBounded(dict, "distance", SMALL, GREAT, region.distance);

    if (hasDistance != (region.mode == geometryRegion::modes::distance))
    {
        entryError(dict, hasDistance ? "distance" : "mode")
            << "The region " << region.name << " has mode " << mode
            << (hasDistance ? " with a distance" : " without a distance")
            << exit(FatalIOError);
    }

    return region;
}


// * * * * * * * * * * * * *  Read Remesh Controls * * * * * * * * * * * * * //

//- The longest edge in a part of the surface, no shorter than the shortest
static scalar readMaxEdge
(
    const dictionary& dict,
    const surfaceRemeshControls& general
)
{
    return readMandatory(dict, "maxEdge", max(general.minEdge, SMALL), GREAT);
}


static patchEdges readPatch
(
    const keyType& key,
    const dictionary& dict,
    const surfaceRemeshControls& general
)
{
    checkKeys(dict, {"maxEdge"});

    return patchEdges{key, readMaxEdge(dict, general)};
}


static edgeRegion readRegion
(
    const dictionary& dict,
    const surfaceRemeshControls& general
)
{
    wordList keys(geometryRegionKeys);
    keys.append("maxEdge");
    checkKeys(dict, keys);

    return edgeRegion{readGeometryRegion(dict), readMaxEdge(dict, general)};
}


static void readSharpEdges
(
    const dictionary& dict,
    surfaceRemeshControls& controls
)
{
    if (!dict.found("sharpEdges", keyType::LITERAL))
    {
        return;
    }

    const dictionary& sharp = optionalDict(dict, "sharpEdges");
    checkKeys(sharp, {"angle", "maxEdge"});
    controls.sharpAngle = max(controls.sharpAngle, controls.featureAngle);
    readBounded
    (
        sharp, "angle", controls.featureAngle, 180, controls.sharpAngle
    );
    controls.sharpMaxEdge = readMaxEdge(sharp, controls);
}


surfaceRemeshControls readRemeshControls(const dictionary& surface)
{
    const dictionary& dict = optionalDict(surface, "remesh");
    checkKeys
    (
        dict,
        {
            "maxEdge", "minEdge", "deviation", "featureAngle", "growthRate",
            "patches", "regions", "sharpEdges", "edgePerGap"
        }
    );

    surfaceRemeshControls controls;
    controls.active = surface.found("remesh");
    readBounded(dict, "maxEdge", SMALL, GREAT, controls.maxEdge);
    readBounded
    (
        dict, "minEdge", SMALL,
        controls.maxEdge > 0 ? controls.maxEdge : GREAT, controls.minEdge
    );
    readBounded(dict, "deviation", SMALL, GREAT, controls.deviation);
    readBounded(dict, "featureAngle", 1, 90, controls.featureAngle);
    readBounded(dict, "growthRate", 1.01, 2, controls.growthRate);

    controls.patches = readEntries<patchEdges>
    (
        dict, "patches",
        [&](const keyType& key, const dictionary& entries)
        {
            return readPatch(key, entries, controls);
        }
    );
    controls.regions = readEntries<edgeRegion>
    (
        dict, "regions",
        [&](const keyType&, const dictionary& entries)
        {
            return readRegion(entries, controls);
        }
    );
    readSharpEdges(dict, controls);
    readBounded(dict, "edgePerGap", 0.1, 100, controls.edgePerGap);

    return controls;
}


// * * * * * * * * * * * *  Read Far Field Controls  * * * * * * * * * * * * //

const wordList farFieldTypes({"none", "tet", "hexCore", "mesh"});

const wordList farBoundaryTypes({"box", "sphere", "surface"});


//- Keys of all kinds of boundary
static const wordList boundaryKeys
({
    "type", "patches", "min", "max", "origin", "radius", "file", "scale"
});


//- Refuses the keys of the other kinds of boundary
static void checkKind(const dictionary& dict, const wordList& own)
{
    for (const entry& e : dict)
    {
        if (e.keyword() != "type" && !own.found(e.keyword()))
        {
            entryError(dict, e.keyword())
                << "The entry " << e.keyword() << " is not one of a far"
                << " boundary of type " << dict.get<word>("type") << nl
                << "Its entries: " << listed(own).c_str() << exit(FatalIOError);
        }
    }
}


static void readBox(const dictionary& dict, farBoundaryControls& boundary)
{
    checkKind(dict, {"patches", "min", "max"});

    const point low(dict.get<point>("min"));
    const point high(dict.get<point>("max"));

    // Written so that values that are no numbers fail
    if (!(cmptMin(high - low) > 0 && mag(high - low) < GREAT))
    {
        entryError(dict, "max")
            << "Value of max is " << high << "; it must be more than min "
            << low << " in all directions" << exit(FatalIOError);
    }

    boundary.box = boundBox(low, high);
}


static void readSphere(const dictionary& dict, farBoundaryControls& boundary)
{
    checkKind(dict, {"patches", "origin", "radius"});

    dict.readEntry("origin", boundary.origin);

    boundary.radius = readMandatory(dict, "radius", 1e-9, 1e9);
}


static void readSurface(const dictionary& dict, farBoundaryControls& boundary)
{
    checkKind(dict, {"patches", "file", "scale"});

    dict.readEntry("file", boundary.file);
    readBounded(dict, "scale", 1e-9, 1e9, boundary.scale);
}


cyclicControls readCyclic(const word& type, const dictionary& dict)
{
    cyclicControls cyclic;
    dict.readIfPresent("partner", cyclic.partner);
    const dictionary& rotation = optionalDict(dict, "rotation");
    checkKeys(rotation, {"axis", "origin", "angle"});
    if (rotation.size())
    {
        rotation.readEntry("axis", cyclic.axis);
        rotation.readEntry("origin", cyclic.origin);
        cyclic.angle = readMandatory(rotation, "angle", -180, 180);
    }

    const bool isCyclic = type == "cyclic";
    if ((cyclic.partner.size() || rotation.size()) && !isCyclic)
    {
        entryError(dict, "type")
            << "Patches with a partner or a rotation are of type cyclic, not "
            << type << exit(FatalIOError);
    }
    if (rotation.size() && (!(mag(cyclic.axis) > 0) || cyclic.partner.empty()))
    {
        entryError(dict, "rotation")
            << "The rotation must have an axis that is not zero, and is of the"
            << " patch that has the partner" << exit(FatalIOError);
    }

    return cyclic;
}


static farPatch readFarPatch(const keyType& key, const dictionary& dict)
{
    checkKeys(dict, {"type", "sides", "partner"});

    if (key.isPattern())
    {
        entryError(dict, key)
            << "The patch " << key << " of the far boundary must have a name"
            << exit(FatalIOError);
    }

    farPatch patch;
    patch.name = key;
    patch.sides = wordRes(1, wordRe(key));
    readChoice(dict, "type", planeTypes, patch.type);
    patch.cyclic = readCyclic(patch.type, dict);
    dict.readIfPresent("sides", patch.sides);

    return patch;
}


//- Whether one of some patches is of type cyclic
template<class Patch>
static bool anyCyclic(const UList<Patch>& patches)
{
    return anyOf
    (
        patches, [](const Patch& patch) { return patch.type == "cyclic"; }
    );
}


static farBoundaryControls readBoundary(const dictionary& dict)
{
    checkKeys(dict, boundaryKeys);

    farBoundaryControls boundary;

    if (!readChoice(dict, "type", farBoundaryTypes, boundary.type))
    {
        missingEntry(dict, "type");
    }

    if (boundary.type == farBoundaryType::box)
    {
        readBox(dict, boundary);
    }
    else if (boundary.type == farBoundaryType::sphere)
    {
        readSphere(dict, boundary);
    }
    else
    {
        readSurface(dict, boundary);
    }

    boundary.patches = readEntries<farPatch>(dict, "patches", readFarPatch);
    if (boundary.type != farBoundaryType::box && anyCyclic(boundary.patches))
    {
        entryError(dict, "type")
            << "Patches of type cyclic are possible with farField.boundary.type"
            << " box alone"
            << exit(FatalIOError);
    }

    return boundary;
}


static sizeRegion readSizeRegion(const keyType&, const dictionary& dict)
{
    wordList keys(geometryRegionKeys);
    keys.append("cellSize");
    checkKeys(dict, keys);

    return sizeRegion
    {
        readGeometryRegion(dict), readMandatory(dict, "cellSize", 1e-9, 1e9)
    };
}


//- Refuses the entries of other types of far field
static void refuseOtherTypes(const dictionary& dict, const farFieldType type)
{
    const auto refuse = [&](const word& key, const char* types)
    {
        if (dict.found(key, keyType::LITERAL))
        {
            entryError(dict, key)
                << "The entry " << key << " is for a far field of type "
                << types << ", but farField.type is "
                << farFieldTypes[int(type)] << exit(FatalIOError);
        }
    };

    if (type == farFieldType::mesh)
    {
        refuse("boundary", "tet or hexCore");
    }
    if (type == farFieldType::tet)
    {
        refuse("gap", "hexCore or mesh");
    }
    if (type == farFieldType::tet || type == farFieldType::hexCore)
    {
        refuse("region", "mesh");
    }
}


farFieldControls readFarFieldControls
(
    const dictionary& dict,
    const wallSurfaceControls& surface
)
{
    checkKeys
    (
        dict,
        {
            "type", "boundary", "growthRate", "maxCellSize", "maxCells",
            "regions", "gap", "polyhedra", "region"
        }
    );

    farFieldControls controls;
    readChoice(dict, "type", farFieldTypes, controls.type);

    readBounded(dict, "growthRate", 1.01, 2, controls.growthRate);
    readBounded(dict, "maxCellSize", 1e-9, 1e9, controls.maxCellSize);
    readBounded(dict, "maxCells", 1, 200000000, controls.maxCells);
    controls.regions = readEntries<sizeRegion>(dict, "regions", readSizeRegion);

    readBounded(dict, "gap", 0.1, 10, controls.gap);
    Switch polyhedra(controls.polyhedra);
    dict.readIfPresent("polyhedra", polyhedra, keyType::LITERAL);
    controls.polyhedra = polyhedra;
    dict.readIfPresent("region", controls.region);

    const bool hasBoundary = dict.found("boundary", keyType::LITERAL);
    refuseOtherTypes(dict, controls.type);

    if (hasBoundary)
    {
        controls.boundary = readBoundary(optionalDict(dict, "boundary"));
    }

    // An open wall inside of which the fluid is may have one. The point inside
    // tells later where the fluid is.
    const bool fluidOutside = surface.fluidOutside;
    const bool isKnown = surface.isFluidGiven || !surface.hasInside;
    if
    (
        isKnown && controls.isWanted() && controls.type != farFieldType::mesh
     && hasBoundary != fluidOutside && surface.sidePlanes.empty()
     && controls.boundary.type != farBoundaryType::box
    )
    {
        entryError(dict, hasBoundary ? "boundary" : "type")
            << (fluidOutside
              ? "The far field has no boundary: give it one, a box, a sphere or"
                " a surface"
              : "The fluid is inside of the wall: there is no far boundary."
                " Remove the entry boundary, or write surface { fluid outside;"
                " }")
            << exit(FatalIOError);
    }

    return controls;
}

} // End namespace Foam

// ************************************************************************* //
