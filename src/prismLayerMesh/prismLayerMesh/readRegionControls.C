/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readRegionControls.H"
#include "controlEntries.H"
#include "readPrismLayerControls.H"
#include "Switch.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Refuses entries that several regions cannot have
static void refuseEntries(const dictionary& dict)
{
    const auto refuse = [](const dictionary& entries, const wordList& keys)
    {
        for (const word& key : keys)
        {
            if (entries.found(key, keyType::LITERAL))
            {
                entryError(entries, key)
                    << "There are regions. " << entries.dictName() << " cannot"
                    << " have " << key << " then" << exit(FatalIOError);
            }
        }
    };

    refuse(dict, {"twoDimensional"});
    refuse
    (
        optionalDict(dict, "surface"),
        {"fluid", "sidePlanes", "repair", "remesh"}
    );
}


//- Returns a sub-dictionary. Adds an empty one if there is none.
static dictionary& entriesIn(dictionary& dict, const word& key)
{
    if (!dict.found(key))
    {
        dict.add(key, dictionary());
    }

    return dict.subDict(key);
}


//- Gives the dictionary of a region what the region says of its layers. Returns
//  whether it has layers.
static bool mergeLayers(const dictionary& region, dictionary& dict)
{
    dictionary& layers = entriesIn(dict, "layers");
    bool hasLayers = true;
    if (region.isDict("layers"))
    {
        layers.merge(region.subDict("layers"));
    }
    else if (region.found("layers"))
    {
        hasLayers = region.get<Switch>("layers");
    }
    if (region.found("patches"))
    {
        entriesIn(layers, "patches").merge(region.subDict("patches"));
    }

    return hasLayers;
}


static regionControls readRegion
(
    const keyType& name,
    const dictionary& region,
    dictionary dict,
    const farBoundary& sides
)
{
    checkKeys(region, {"inside", "layers", "patches", "farField"});

    regionControls result;
    result.seed.name = name;
    region.readEntry("inside", result.seed.inside);
    result.hasLayers = mergeLayers(region, dict);
    dictionary& farField = entriesIn(dict, "farField");
    farField.merge(optionalDict(region, "farField"));
    farField.remove("boundary");
    dict.subDict("surface").set("fluid", "inside");

    dictionary& patches = entriesIn(dict.subDict("layers"), "patches");
    forAll(sides.surface.patchNames, patchi)
    {
        dictionary side;
        side.set("nSurfaceLayers", 0);
        side.set("type", sides.patchTypes[patchi]);
        patches.set(sides.surface.patchNames[patchi], side);
    }

    result.controls = readPrismLayerControls(dict);
    for (const patchLayers& patch : result.controls.layers.patches)
    {
        if (result.controls.polygons && patch.type == "cyclic")
        {
            entryError(dict, "cells")
                << "There are regions, and cyclic patches. cells cannot be"
                << " polygons then" << exit(FatalIOError);
        }
    }
    if (result.controls.layers.fromRun.isGiven())
    {
        const dictionary& yPlus = dict.subDict("layers").subDict("yPlus");
        entryError(yPlus, "from")
            << "There are regions. yPlus cannot have from then"
            << exit(FatalIOError);
    }
    const farFieldType type = result.controls.farField.type;
    if (type == farFieldType::none || type == farFieldType::mesh)
    {
        entryError(region, "farField")
            << "The farField.type of the region " << name << " must be tet or"
            << " hexCore" << exit(FatalIOError);
    }

    return result;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

regionsControls readRegionControls
(
    const dictionary& dict,
    const std::function<farBoundary(const farBoundaryControls&)>& farSides
)
{
    refuseEntries(dict);
    dictionary general(dict);
    general.remove("regions");
    dictionary whole(general);
    const bool hasBoundary =
        optionalDict(whole, "farField").found("boundary", keyType::LITERAL);
    mandatoryDict(whole, "surface");
    regionsControls result;
    for (dictionary* dict : {&general, &whole})
    {
        dictionary& surface = dict->subDict("surface");
        surface.readIfPresent("baffles", result.baffles, keyType::LITERAL);
        surface.remove("baffles");
    }
    whole.subDict("surface").set
    (
        "fluid", hasBoundary ? "outside" : "inside"
    );

    // A region may be the first to say a type
    dictionary& farField = entriesIn(whole, "farField");
    if (!farField.found("type"))
    {
        farField.add("type", word("tet"));
    }
    const prismLayerControls controls(readPrismLayerControls(whole));

    result.surface = controls.surface;
    result.boundary = controls.farField.boundary;
    if (hasBoundary)
    {
        result.sides = farSides(result.boundary);
    }

    const dictionary& regions = mandatoryDict(dict, "regions");
    for (const entry& e : regions)
    {
        result.regions.append
        (
            readRegion
            (
                e.keyword(), optionalDict(regions, e.keyword()), general,
                result.sides
            )
        );
    }
    if (result.regions.empty())
    {
        entryError(dict, "regions")
            << "There are no regions" << exit(FatalIOError);
    }

    return result;
}

} // End namespace Foam

// ************************************************************************* //
