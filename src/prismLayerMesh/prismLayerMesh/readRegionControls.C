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
                    << "The entry " << key << " of " << entries.dictName()
                    << " is not possible with regions. Remove it"
                    << exit(FatalIOError);
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


//- Refuses cyclic sides of the far boundary. Each region would have a part of
//  them.
static void refuseCyclic
(
    const dictionary& dict,
    const farBoundaryControls& boundary
)
{
    for (const farPatch& patch : boundary.patches)
    {
        if (patch.type == "cyclic")
        {
            const dictionary& entries = dict.subDict("farField")
               .subDict("boundary").subDict("patches");
            entryError(entries.subDict(patch.name), "type")
                << "farField.boundary.patches." << patch.name << ".type is"
                << " cyclic. Cyclic sides are not possible with regions" << nl
                << "Write type patch, wall, symmetry or symmetryPlane"
                << exit(FatalIOError);
        }
    }
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


//- Returns the dictionaries of the regions.
//  Errors: FatalIOError if there are none
static const dictionary& regionsOf(const dictionary& dict)
{
    const dictionary& regions = mandatoryDict(dict, "regions");
    if (regions.empty())
    {
        entryError(dict, "regions")
            << "The entry regions has no region" << nl
            << "Write: regions { air { inside (x y z); } }"
            << exit(FatalIOError);
    }

    return regions;
}


//- Declares the entries of a region. Others than the point change the general
//  entries: mergeLayers and readRegion merge them.
static void declare(controlEntries& entries, regionSeed& seed)
{
    entries.read("inside", seed.inside, "A point in the region", "point");
    entries.require("inside");
    entries.has
    (
        "layers", "Layers on the walls of the region",
        "dictionary, or no", "the general layers"
    );
    entries.has("patches", "Layers on patches of the region", "dictionary");
    entries.has("farField", "Cells of the region", "dictionary");
}


static regionControls readRegion
(
    const keyType& name,
    const dictionary& region,
    dictionary dict,
    const farBoundary& sides
)
{
    regionControls result;
    result.seed.name = name;
    controlEntries::read(region, [&](controlEntries& entries)
    {
        declare(entries, result.seed);
    });
    result.hasLayers = mergeLayers(region, dict);
    const dictionary& ownFarField = optionalDict(region, "farField");
    if (ownFarField.found("boundary", keyType::LITERAL))
    {
        entryError(ownFarField, "boundary")
            << "The far boundary is around all regions. Move boundary from "
            << name << ".farField to farField" << exit(FatalIOError);
    }
    dictionary& farField = entriesIn(dict, "farField");
    farField.merge(ownFarField);
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
    if (result.controls.layers.fromRun.isGiven())
    {
        const dictionary& yPlus = dict.subDict("layers").subDict("yPlus");
        entryError(yPlus, "from")
            << "layers.yPlus.from cannot be combined with regions" << nl
            << "Write U, nu and L in yPlus, or firstLayerThickness"
            << exit(FatalIOError);
    }
    const farFieldType type = result.controls.farField.type;
    if (type == farFieldType::none || type == farFieldType::mesh)
    {
        entryError(region, "farField")
            << "The farField.type of the region " << name << " must be tet or"
            << " hexCore, and is " << farFieldTypes[int(type)]
            << exit(FatalIOError);
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
    refuseCyclic(dict, result.boundary);
    if (hasBoundary)
    {
        result.sides = farSides(result.boundary);
    }

    const dictionary& regions = regionsOf(dict);
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

    return result;
}

} // End namespace Foam

// ************************************************************************* //
