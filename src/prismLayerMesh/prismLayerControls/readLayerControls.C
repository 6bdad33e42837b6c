/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readLayerControls.H"
#include "controlEntries.H"
#include "readLayerHeights.H"
#include "readLayerParts.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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
            << "finalAspect is for nSurfaceLayers auto, but nSurfaceLayers is "
            << n << exit(FatalIOError);
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

    controls.patches = readLayerPatches(dict, controls);
    controls.regions = readLayerRegions(dict, controls);

    return controls;
}

} // End namespace Foam

// ************************************************************************* //
