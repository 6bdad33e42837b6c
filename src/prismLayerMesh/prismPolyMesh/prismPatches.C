/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismPatches.H"
#include "HashSet.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

const word layerOuterName("layerOuter");
const word layerSidesName("layerSides");


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const word& typeOfSide(const wallBorder& border, const word& name)
{
    for (const sidePatch& side : border.sides)
    {
        if (side.name == name)
        {
            return side.type;
        }
    }

    return word::null;
}


static meshPatches patchesOfWall(const prismLayers& layers)
{
    const wordList names(prismPatchNames(layers.patchNames));
    meshPatches wall;
    forAll(names, patchi)
    {
        wall.append
        (
            names[patchi],
            patchi < layers.patchTypes.size()
          ? layers.patchTypes[patchi] : word("wall")
        );
    }

    return wall;
}


//- Leaves out patches of an existing mesh that have lost all faces to the wall
//  and whose names the wall has
static void dropPatchesOfWall(const wordList& wallPatches, farFieldMesh& far)
{
    DynamicList<label> kept;

    forAll(far.patches.names, patchi)
    {
        const word& name = far.patches.names[patchi];
        const label size = far.topology.patchSizes[1 + patchi];

        if (!wallPatches.found(name))
        {
            kept.append(patchi);
        }
        else if (size)
        {
            FatalErrorInFunction
                << "The wall and the mesh around the layers both have a patch "
                << name << ", and " << size << " faces of the mesh's patch"
                << " stay." << nl << "Rename one of the patches"
                << exit(FatalError);
        }
    }

    far.keepPatches(kept);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

wordList sidePatchNames(const wallBorder& border)
{
    DynamicList<word> names;
    for (const sidePatch& side : border.sides)
    {
        if (!names.found(side.name))
        {
            names.append(side.name);
        }
    }

    return wordList(std::move(names));
}


wordList prismPatchNames(const wordList& wallPatchNames)
{
    wordHashSet taken;
    taken.insert(layerOuterName);
    taken.insert(layerSidesName);

    wordList names(wallPatchNames);

    for (word& name : names)
    {
        const word asGiven(name);

        for (label i = 2; !taken.insert(name); ++i)
        {
            name = asGiven + Foam::name(i);
        }
    }

    return names;
}


meshPatches patchesOfLayers(const prismLayers& layers, const label nOpen)
{
    meshPatches patches(patchesOfWall(layers));

    patches.append(layerOuterName, "patch");
    const wordList sides(sidePatchNames(layers.border));
    for (const word& name : sides)
    {
        patches.append(name, typeOfSide(layers.border, name));
    }
    if (nOpen > sides.size())
    {
        patches.append(layerSidesName, "patch");
    }

    return patches;
}


meshPatches patchesOfMesh
(
    const prismLayers& layers,
    const label nOpen,
    farFieldMesh& far
)
{
    if (far.empty())
    {
        return patchesOfLayers(layers, nOpen);
    }

    meshPatches patches(patchesOfWall(layers));
    dropPatchesOfWall(patches.names, far);
    patches.names.append(far.patches.names);
    patches.entries.append(far.patches.entries);

    return patches;
}


List<labelPair> partsOfPatches
(
    const prismLayers& layers,
    const label nOpen,
    const farFieldMesh& far
)
{
    const label nWall = layers.patchNames.size();
    const wordList sideNames(sidePatchNames(layers.border));
    DynamicList<labelPair> parts;

    for (label i = 0; i < (far.empty() ? nWall + 1 + nOpen : nWall); ++i)
    {
        parts.append(labelPair(i, -1));
    }
    forAll(far.patches.names, i)
    {
        // The sides of layers follow the wall and the outer surface
        const label side = sideNames.find(far.patches.names[i]);
        parts.append(labelPair(side < 0 ? -1 : nWall + 1 + side, 1 + i));
    }

    return List<labelPair>(std::move(parts));
}

} // End namespace Foam

// ************************************************************************* //
