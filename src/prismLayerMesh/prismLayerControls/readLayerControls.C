/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readLayerControls.H"
#include "readRegions.H"
#include "readLayerHeights.H"

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


//- An automatic number of layers follows from h1 and alpha
static void checkAutomatic(const dictionary& dict, const heightEntries& given)
{
    if (given.finalLayerThickness > 0 || given.thickness > 0)
    {
        entryError(dict, dict.dictName())
            << "With nSurfaceLayers auto, " << dict.dictName() << " may have"
            << " firstLayerThickness, or yPlus, and expansionRatio; given: "
            << givenKeys(given).c_str() << exit(FatalIOError);
    }
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


static heightField readHeightField(const dictionary& dict)
{
    checkKeys(dict, {"file", "field"});

    heightField field;
    dict.readEntry("file", field.file);
    dict.readIfPresent("field", field.field);

    if (field.file.empty())
    {
        entryError(dict, "file")
            << "Value of file is empty; it must be the name of a file of values"
            << exit(FatalIOError);
    }

    return field;
}


static void readFields(const dictionary& dict, layerControls& controls)
{
    const dictionary& fields = optionalDict(dict, "fields");
    checkKeys(fields, {"firstLayerThickness", "thickness"});

    if (fields.found("firstLayerThickness", keyType::LITERAL))
    {
        controls.firstLayerField =
            readHeightField(optionalDict(fields, "firstLayerThickness"));
    }
    if (fields.found("thickness", keyType::LITERAL))
    {
        controls.thicknessField =
            readHeightField(optionalDict(fields, "thickness"));
    }

    if (controls.automatic() && controls.thicknessField.isGiven())
    {
        entryError(dict, "fields")
            << "With nSurfaceLayers auto, fields may have firstLayerThickness"
            << " alone" << exit(FatalIOError);
    }
}


//- n, or auto
static void readGeneralNumber(const dictionary& dict, layerControls& controls)
{
    label& n = controls.heights.nSurfaceLayers;

    if (!dict.found("nSurfaceLayers", keyType::LITERAL))
    {
        missingEntry(dict, "nSurfaceLayers");
    }

    const ITstream& is = dict.lookup("nSurfaceLayers", keyType::LITERAL);

    if (is.size() && is[0].isWord())
    {
        word value;
        readChoice(dict, "nSurfaceLayers", {"auto"}, value);
    }
    else
    {
        readBounded(dict, "nSurfaceLayers", 1, heightSeries::maxLayers, n);
    }

    const bool hasAspect =
        readBounded(dict, "finalAspect", 0.01, 100, controls.finalAspect);

    if (hasAspect && !controls.automatic())
    {
        entryError(dict, "finalAspect")
            << "finalAspect is for nSurfaceLayers auto, but there are to be "
            << n << " layers" << exit(FatalIOError);
    }
}


static void readGeneralHeights(const dictionary& dict, layerControls& controls)
{
    controls.heights = readLayerHeights(dict);
    heightEntries& given = controls.heights;
    readGeneralNumber(dict, controls);

    if (controls.automatic())
    {
        checkAutomatic(dict, given);
    }

    if
    (
        !(given.firstLayerThickness > 0)
     && !(given.finalLayerThickness > 0)
     && !(given.thickness > 0)
    )
    {
        entryError(dict, dict.dictName())
            << "The height of the layers of " << dict.dictName()
            << " is missing; given: " << givenKeys(given).c_str() << nl
            << "Give firstLayerThickness, yPlus, finalLayerThickness or"
            << " thickness" << exit(FatalIOError);
    }

    atEntriesOf(dict, [&]()
    {
        heightSeries one;
        one.n = 1;
        changedHeights(one, given, 1);
    });
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

const patchLayers* layerControls::entryOf(const word& patchName) const
{
    for (label i = patches.size() - 1; i >= 0; --i)
    {
        if (patches[i].patches.match(patchName))
        {
            return &patches[i];
        }
    }

    return nullptr;
}


layerControls readLayerControls(const dictionary& dict)
{
    wordList keys(layerHeightKeys);
    keys.append
    (
        wordList
        ({
            "finalAspect", "marchingDistances", "marchingDirections",
            "transitionRatio", "maxStretch", "multipleNormalsAngle", "fields",
            "patches", "regions"
        })
    );
    checkKeys(dict, keys);

    layerControls controls;
    readGeneralHeights(dict, controls);
    readFields(dict, controls);

    word distances("requested");
    readChoice
    (
        dict, "marchingDistances", {"requested", "levelSets"}, distances
    );
    controls.onLevelSets = distances == "levelSets";

    word directions("field");
    readChoice(dict, "marchingDirections", {"field", "axes"}, directions);
    controls.alongField = directions == "field";

    readBounded(dict, "transitionRatio", 1.01, 100, controls.transitionRatio);
    readBounded(dict, "maxStretch", 1, 10, controls.maxStretch);
    readBounded
    (
        dict, "multipleNormalsAngle", 0, 90, controls.multipleNormalsAngle
    );

    controls.patches = readEntries<patchLayers>
    (
        dict, "patches",
        [&](const keyType& key, const dictionary& entries)
        {
            return readPatches(key, entries, controls);
        }
    );
    controls.regions = readEntries<layerRegion>
    (
        dict, "regions",
        [&](const keyType&, const dictionary& entries)
        {
            return readRegion(entries, controls);
        }
    );

    return controls;
}

} // End namespace Foam

// ************************************************************************* //
