/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readLayerParts.H"
#include "controlEntries.H"
#include "readLayerHeights.H"
#include "readRegions.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

const wordList sideTypes
({
    "patch", "wall", "symmetryPlane", "symmetry", "empty"
});


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Number of layers of a patch or region; 0 if it is the general number
static label readNumber(const dictionary& dict, const layerControls& general)
{
    label n = 0;
    readBounded(dict, "nSurfaceLayers", 1, heightSeries::maxLayers, n);

    if (n && general.automatic())
    {
        entryError(dict, "nSurfaceLayers")
            << "Value of nSurfaceLayers for " << dict.dictName() << " is " << n
            << ", but the number of layers is auto, for all of the wall"
            << exit(FatalIOError);
    }

    return n;
}


//- Entries for a part of the wall, checked together with the general entries
static heightEntries readPart
(
    const dictionary& dict,
    const layerControls& general
)
{
    heightEntries given(readLayerHeights(dict, general.heights.relativeSizes));
    given.nSurfaceLayers = readNumber(dict, general);

    if (general.automatic())
    {
        checkAutomatic(dict, given);
    }

    // In other units they are checked at each point later
    if (given.relativeSizes == general.heights.relativeSizes)
    {
        atEntriesOf(dict, [&]()
        {
            const heightSeries before
            (
                changedHeights(heightSeries(), general.heights, 1)
            );
            changedHeights(before, given, 1);
        });
    }

    return given;
}


//- What is said of patches: of those with 0 layers nothing but their type
static patchLayers readPatches
(
    const keyType& key,
    const dictionary& dict,
    const layerControls& general
)
{
    wordList keys(layerHeightKeys);
    keys.append("type");
    checkKeys(dict, keys);

    patchLayers patches;
    patches.patches = key;
    readChoice(dict, "type", sideTypes, patches.type);

    label n = -1;
    patches.isSide =
        dict.readIfPresent("nSurfaceLayers", n, keyType::LITERAL) && n == 0;

    if (!patches.isSide)
    {
        patches.heights = readPart(dict, general);
    }
    else if (dict.size() > (patches.type.empty() ? 1 : 2))
    {
        entryError(dict, "nSurfaceLayers")
            << "Patches " << key << " have no layers: they have no heights"
            << exit(FatalIOError);
    }

    return patches;
}


static layerRegion readRegion
(
    const dictionary& dict,
    const layerControls& general
)
{
    wordList keys(geometryRegionKeys);
    keys.append(layerHeightKeys);
    checkKeys(dict, keys);

    return layerRegion{readGeometryRegion(dict), readPart(dict, general)};
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void checkAutomatic(const dictionary& dict, const heightEntries& given)
{
    if (given.finalLayerThickness > 0 || given.thickness > 0)
    {
        entryError(dict, dict.dictName())
            << "With nSurfaceLayers auto, " << dict.dictName() << " may have"
            << " firstLayerThickness, or yPlus, and expansionRatio; given: "
            << givenKeys(given).c_str() << exit(FatalIOError);
    }
}


List<patchLayers> readLayerPatches
(
    const dictionary& dict,
    const layerControls& general
)
{
    return readEntries<patchLayers>
    (
        dict, "patches", [&](const keyType& key, const dictionary& entries)
        {
            return readPatches(key, entries, general);
        }
    );
}


List<layerRegion> readLayerRegions
(
    const dictionary& dict,
    const layerControls& general
)
{
    return readEntries<layerRegion>
    (
        dict, "regions", [&](const keyType&, const dictionary& entries)
        {
            return readRegion(entries, general);
        }
    );
}

} // End namespace Foam

// ************************************************************************* //
