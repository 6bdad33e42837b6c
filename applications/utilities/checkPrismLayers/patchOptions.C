/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchOptions.H"
#include "prismPolyMesh.H"
#include "ranges.H"
#include "StringStream.H"
#include "throwingErrors.H"
#include "wallPolyPatch.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The patches of an option in ascending order, or the default ones
static labelList patchesOf
(
    const argList& args,
    const word& option,
    const polyBoundaryMesh& patches,
    const labelList& defaults
)
{
    if (!args.found(option))
    {
        return defaults;
    }

    const wordRes names(args.getList<wordRe>(option));
    const labelList found(patches.patchSet(names).sortedToc());

    if (found.empty())
    {
        FatalErrorInFunction
            << "No patch is called " << args[option].c_str() << ", only "
            << patches.names() << exit(FatalError);
    }

    return found;
}


//- Errors: FatalError if a patch is a wall and an outer one
static void requireApart
(
    const polyBoundaryMesh& patches,
    const labelUList& walls,
    const labelUList& outer
)
{
    for (const label patchi : outer)
    {
        if (walls.found(patchi))
        {
            FatalErrorInFunction
                << "Patch " << patches[patchi].name()
                << " is in -walls and in -outer" << exit(FatalError);
        }
    }
}


//- The numbers of layers of -layers, for patches by their names and for all
struct layersOption
{
    label onAll = 0;
    dictionary onPatches;
};


//- Errors: FatalError if a number is not positive; FatalError and FatalIOError
//  if the text is not a dictionary
static layersOption parseLayers(const std::string& text)
{
    layersOption layers;
    if (read(text, layers.onAll))
    {
        return layers;
    }

    IStringStream entries(text);
    layers.onPatches = dictionary(entries);
    label least = layers.onPatches.size();
    for (const entry& e : layers.onPatches)
    {
        least = min(least, layers.onPatches.get<label>(e.keyword()));
    }
    if (least < 1)
    {
        FatalErrorInFunction << "no positive number" << exit(FatalError);
    }

    return layers;
}


//- Errors: FatalError with the text of -layers
static layersOption readLayers(const argList& args)
{
    layersOption layers;
    layers.onAll = -1;
    try
    {
        const throwingErrors throwing(true);
        layers = parseLayers(args.opt<string>("layers", "0"));
    }
    catch (const Foam::error&)
    {}

    if (layers.onAll < 0)
    {
        FatalErrorInFunction
            << "-layers " << args["layers"].c_str() << " is neither a number"
            << " of layers nor a dictionary of numbers of layers, such as"
            << " 'body 3; \"wing.*\" 5;'" << exit(FatalError);
    }

    return layers;
}


//- The patches that the dictionary of -layers names
//  candidates: patches that may be named
//  Errors: FatalError if a name is not the name of a candidate
static labelList patchesNamed
(
    const dictionary& layers,
    const polyBoundaryMesh& patches,
    const labelUList& candidates
)
{
    DynamicList<word> names;
    DynamicList<label> named;
    for (const label patchi : candidates)
    {
        names.append(patches[patchi].name());
        if (layers.found(names.last()))
        {
            named.append(patchi);
        }
    }

    for (const entry& e : layers)
    {
        const keyType& key = e.keyword();
        if (!anyOf(names, [&](const word& n) { return key.match(n); }))
        {
            FatalErrorInFunction
                << "-layers: no wall is called " << key << ", only "
                << listed(names).c_str() << exit(FatalError);
        }
    }

    return labelList(std::move(named));
}


static labelList layersOn
(
    const polyBoundaryMesh& patches,
    const labelUList& walls,
    const layersOption& layers
)
{
    labelList asked(walls.size());
    forAll(walls, i)
    {
        asked[i] = layers.onPatches.lookupOrDefault<label>
        (
            patches[walls[i]].name(), layers.onAll
        );
    }

    return asked;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

namedPatches readPatchOptions
(
    const argList& args,
    const polyBoundaryMesh& patches,
    const polyhedralMesh& mesh,
    const bitSet& beyond
)
{
    const label outeri = patches.findPatchID(layerOuterName);
    const layersOption layers(readLayers(args));

    namedPatches named;
    named.outer = patchesOf
    (
        args, "outer", patches, labelList(outeri < 0 ? 0 : 1, outeri)
    );
    const labelList layered
    (
        patchesWithLayers(patches, mesh, beyond, named.outer)
    );
    labelHashSet mayHave(patches.findPatchIDs<wallPolyPatch>());
    mayHave.insert(layered);
    named.walls = patchesOf(args, "walls", patches, mayHave.sortedToc());
    const labelList byLayers
    (
        patchesNamed(layers.onPatches, patches, named.walls)
    );
    if (!args.found("walls"))
    {
        labelHashSet walls(layered);
        walls.insert(byLayers);
        named.walls = walls.sortedToc();
        writeBareWalls(patches, named.walls, beyond, named.outer);
    }
    named.layersAsked = layersOn(patches, named.walls, layers);
    requireApart(patches, named.walls, named.outer);

    return named;
}

} // End namespace Foam

// ************************************************************************* //
