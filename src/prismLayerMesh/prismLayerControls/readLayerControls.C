/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "controlEntries.H"
#include "readControls.H"
#include "Switch.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

const wordList layerHeightKeys
({
    "nSurfaceLayers",
    "firstLayerThickness",
    "finalLayerThickness",
    "thickness",
    "expansionRatio",
    "yPlus",
    "relativeSizes"
});


static yPlusRun readRun(const dictionary& yPlus)
{
    checkKeys(yPlus, {"target", "from"});
    const dictionary& dict = optionalDict(yPlus, "from");
    checkKeys(dict, {"case", "time"});

    yPlusRun run;
    run.target = readMandatory(yPlus, "target", 1e-3, 1e4);
    dict.readEntry("case", run.folder);

    if (run.folder.empty())
    {
        entryError(dict, "case")
            << "Value of case is empty; it must be the folder of a case"
            << exit(FatalIOError);
    }
    if (!dict.found("time", keyType::LITERAL))
    {
        return run;
    }

    const ITstream& is = dict.lookup("time", keyType::LITERAL);
    run.isLatest = is.size() && is[0].isWord();

    if (run.isLatest)
    {
        word value;
        readChoice(dict, "time", {"latest"}, value);
    }
    else
    {
        run.time = dict.get<scalar>("time", keyType::LITERAL);
    }

    return run;
}


static void readFlatPlate(const dictionary& dict, heightEntries& given)
{
    checkKeys(dict, {"target", "U", "nu", "L", "from"});

    const scalar yPlus = readMandatory(dict, "target", 1e-3, 1e4);
    const scalar U = readMandatory(dict, "U", 1e-9, 1e6);
    const scalar nu = readMandatory(dict, "nu", 1e-12, 1e3);
    const scalar L = readMandatory(dict, "L", 1e-9, 1e6);

    given.firstLayerThickness = flatPlateThickness(yPlus, U, nu, L);
    given.yPlus = yPlus;
    given.Re = U*L/nu;
}


//- Reads the entry yPlus of dict; the others are given
static void readYPlus
(
    const dictionary& dict,
    heightEntries& given,
    yPlusRun* run
)
{
    if (given.relativeSizes)
    {
        entryError(dict, "yPlus")
            << "yPlus gives a height in metres, but the heights of "
            << dict.dictName() << " are relativeSizes" << nl
            << "Write relativeSizes false, or firstLayerThickness"
            << exit(FatalIOError);
    }

    const dictionary& yPlus = mandatoryDict(dict, "yPlus");

    if (!yPlus.found("from", keyType::LITERAL))
    {
        readFlatPlate(yPlus, given);
    }
    else if (run)
    {
        *run = readRun(yPlus);
    }
    else
    {
        entryError(yPlus, "from")
            << "yPlus.from applies to the whole wall. Move it from "
            << dict.dictName() << " to layers.yPlus"
            << exit(FatalIOError);
    }
}


heightEntries readLayerHeights
(
    const dictionary& dict,
    const bool relativeSizes,
    yPlusRun* run
)
{
    heightEntries given;

    const auto read = [&](const word& key, scalar& value)
    {
        return readBounded
        (
            dict, key,
            heightSeries::minThickness, heightSeries::maxThickness, value
        );
    };

    const bool hasFirst =
        read("firstLayerThickness", given.firstLayerThickness);
    read("finalLayerThickness", given.finalLayerThickness);
    read("thickness", given.thickness);
    readBounded
    (
        dict, "expansionRatio",
        heightSeries::minRatio, heightSeries::maxRatio, given.expansionRatio
    );

    Switch relative(relativeSizes);
    dict.readIfPresent("relativeSizes", relative, keyType::LITERAL);
    given.relativeSizes = relative;

    if (dict.found("yPlus", keyType::LITERAL))
    {
        if (hasFirst)
        {
            entryError(dict, "yPlus")
                << "Both yPlus and firstLayerThickness determine the first"
                << " layer of " << dict.dictName() << ". Remove one"
                << exit(FatalIOError);
        }

        readYPlus(dict, given, run);
    }

    return given;
}


void atEntriesOf(const dictionary& dict, const std::function<void()>& call)
{
    try
    {
        call();
    }
    catch (const heightEntriesError& error)
    {
        entryError(dict, error.key.empty() ? dict.dictName() : error.key)
            << "Heights of the layers of " << dict.dictName() << ": "
            << error.what() << exit(FatalIOError);
    }
}


scalar flatPlateThickness
(
    const scalar yPlus,
    const scalar U,
    const scalar nu,
    const scalar L
)
{
    const scalar skinFriction = 0.026/::pow(U*L/nu, 1.0/7);
    const scalar frictionVelocity = U*Foam::sqrt(0.5*skinFriction);

    return 2*yPlus*nu/frictionVelocity;
}


// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

const wordList sideTypes
({
    "patch", "wall", "symmetryPlane", "symmetry", "empty"
});


const wordList planeTypes
({
    "patch", "wall", "symmetryPlane", "symmetry", "empty", "cyclic"
});


//- Number of layers of a patch or region; 0 if it is the general number
static label readNumber(const dictionary& dict, const layerControls& general)
{
    label n = 0;
    readBounded(dict, "nSurfaceLayers", 1, heightSeries::maxLayers, n);

    if (n && general.automatic())
    {
        entryError(dict, "nSurfaceLayers")
            << "Value of nSurfaceLayers for " << dict.dictName() << " is " << n
            << ", but layers.nSurfaceLayers auto is for all of the wall" << nl
            << "Remove nSurfaceLayers from " << dict.dictName()
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

    // In other units, or on heights of a run, they are checked at each point
    // later
    if
    (
        given.relativeSizes == general.heights.relativeSizes
     && !general.fromRun.isGiven()
    )
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
            << "Patches " << key << " have no layers, and so no heights"
            << nl << "Remove nSurfaceLayers 0, or all entries but type"
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


// * * * * * * * * * * * * *  Read Layer Controls  * * * * * * * * * * * * * //

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


//- Refuses entries that contradict a run, or each other beside it
static void checkRun(const dictionary& dict, const layerControls& controls)
{
    const heightEntries& given = controls.heights;
    const bool hasTotal =
        given.thickness > 0 || controls.thicknessField.isGiven();

    if (controls.firstLayerField.isGiven())
    {
        entryError(dict, "fields")
            << "Both yPlus.from and fields.firstLayerThickness determine the"
            << " first layer of " << dict.dictName() << ". Remove one"
            << exit(FatalIOError);
    }
    if
    (
        (given.finalLayerThickness > 0) + (given.expansionRatio > 0) + hasTotal
      > 1
    )
    {
        entryError(dict, "yPlus")
            << "The layers are determined twice, by yPlus.from and "
            << givenKeys(given).c_str() << nl << "One entry beside yPlus.from"
            << " is enough" << exit(FatalIOError);
    }
}


static void readGeneralHeights(const dictionary& dict, layerControls& controls)
{
    controls.heights = readLayerHeights(dict, false, &controls.fromRun);
    heightEntries& given = controls.heights;
    readGeneralNumber(dict, controls);

    if (controls.automatic())
    {
        checkAutomatic(dict, given);
    }
    if (controls.fromRun.isGiven())
    {
        return;
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
            "relativeTo", "patches", "regions", "allowPoorHeights"
        })
    );
    checkKeys(dict, keys);

    layerControls controls;
    readGeneralHeights(dict, controls);
    readFields(dict, controls);
    if (controls.fromRun.isGiven())
    {
        checkRun(dict, controls);
    }

    word unit("edges");
    readChoice(dict, "relativeTo", {"edges", "cells"}, unit);
    controls.relativeToCells = unit == "cells";

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

    Switch allow(controls.allowPoorHeights);
    dict.readIfPresent("allowPoorHeights", allow, keyType::LITERAL);
    controls.allowPoorHeights = allow;

    controls.patches = readLayerPatches(dict, controls);
    controls.regions = readLayerRegions(dict, controls);

    return controls;
}

} // End namespace Foam

// ************************************************************************* //
