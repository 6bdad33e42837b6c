/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerEntries.H"
#include "controlEntries.H"
#include "ranges.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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
    if (heights.size() == label(heights.found("expansionRatio")))
    {
        entryError(given.snappy, "addLayersControls")
            << "addLayersControls has no height of the layers" << nl
            << "Write firstLayerThickness, finalLayerThickness or thickness"
            << " beside expansionRatio" << exit(FatalIOError);
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
    const bool isSide =
        nOwn == 0 && patch.type != "wall" && !patch.isBaffle;

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
        if (!e.isDict() || !e.dict().found("nSurfaceLayers"))
        {
            entryError(layers, e.keyword())
                << "layers of addLayersControls has no number of layers for "
                << e.keyword() << nl << "Write: " << e.keyword()
                << " { nSurfaceLayers 3; }" << exit(FatalIOError);
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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

dictionary layerEntries(const snappyCase& given, remarkList& remarks)
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
            << "No patch of the surface has layers: none is of type wall"
            << " (patchInfo), and layers of addLayersControls names none" << nl
            << "Patches of the surface: " << listed(given.walls.names.toc())
               .c_str() << exit(FatalError);
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

} // End namespace Foam

// ************************************************************************* //
