/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readControls.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Declares the earlier run of yPlus
static void declare(controlEntries& entries, yPlusRun& run)
{
    entries.read("case", run.folder, "Folder of the case", "a folder");
    const bool hasTime =
        entries.has("time", "Time of the field", "a time, latest", "latest");
    if (!entries.dict())
    {
        return;
    }

    const dictionary& dict = *entries.dict();
    entries.require("case");
    if (run.folder.empty())
    {
        entryError(dict, "case")
            << "Value of case is empty; it must be the folder of a case"
            << exit(FatalIOError);
    }
    run.isLatest =
        !hasTime || dict.get<token>("time", keyType::LITERAL).isWord();
    if (!run.isLatest)
    {
        run.time = dict.get<scalar>("time", keyType::LITERAL);
    }
    else if (hasTime && dict.get<word>("time", keyType::LITERAL) != "latest")
    {
        entryError(dict, "time")
            << "Value of time is " << dict.get<word>("time")
            << "; it must be a time, or latest" << exit(FatalIOError);
    }
}


//- Declares yPlus of the heights of a dictionary with a name.
//  run: set if yPlus is from a run; null if it may not be
static void declareYPlus
(
    controlEntries& entries,
    const word& name,
    heightEntries& given,
    yPlusRun* run
)
{
    scalar U = 0;
    scalar nu = 0;
    scalar L = 0;
    yPlusRun from;
    entries.readBounded
    (
        "target", given.yPlus, 1e-3, 1e4,
        "y+ of the centres of the first cells"
    );
    entries.require("target");
    entries.readBounded("U", U, 1e-9, 1e6, "Speed of the free stream [m/s]");
    entries.readBounded("nu", nu, 1e-12, 1e3, "Kinematic viscosity [m2/s]");
    entries.readBounded
    (
        "L", L, 1e-9, 1e6, "Length of the body along the flow [m]"
    );
    const bool isFrom = entries.readDict
    (
        "from", "A run with a field yPlus, in place of U, nu and L",
        [&](controlEntries& earlier) { declare(earlier, from); }
    );

    const dictionary* dict = entries.dict();
    if (dict && isFrom && !run)
    {
        entryError(*dict, "from")
            << "yPlus.from applies to the whole wall. Move it from "
            << name << " to layers.yPlus" << exit(FatalIOError);
    }
    if (dict && isFrom)
    {
        checkKeys(*dict, {"target", "from"});
        from.target = given.yPlus;
        given.yPlus = 0;
        *run = from;
    }
    else if (dict)
    {
        for (const word key : {"U", "nu", "L"})
        {
            entries.require(key);
        }
        given.firstLayerThickness =
            flatPlateThickness(given.yPlus, U, nu, L);
        given.Re = U*L/nu;
    }
}


//- Refuses yPlus beside a first height, and in relative heights
static void checkYPlus
(
    const dictionary& dict,
    const bool hasFirst,
    const heightEntries& given
)
{
    if (hasFirst)
    {
        entryError(dict, "yPlus")
            << "Both yPlus and firstLayerThickness determine the first"
            << " layer of " << dict.dictName() << ". Remove one"
            << exit(FatalIOError);
    }
    if (given.relativeSizes)
    {
        entryError(dict, "yPlus")
            << "yPlus gives a height in metres, but the heights of "
            << dict.dictName() << " are relativeSizes" << nl
            << "Write relativeSizes false, or firstLayerThickness"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void declare
(
    controlEntries& entries,
    heightEntries& given,
    yPlusRun* run
)
{
    const auto readHeight = [&]
    (
        const word& key,
        scalar& value,
        const string& text
    )
    {
        return entries.readBounded
        (
            key, value, heightSeries::minThickness, heightSeries::maxThickness,
            text
        );
    };
    const bool hasFirst = readHeight
    (
        "firstLayerThickness", given.firstLayerThickness,
        "Height of the first layer [m]"
    );
    readHeight
    (
        "finalLayerThickness", given.finalLayerThickness,
        "Height of the last layer [m]"
    );
    readHeight
    (
        "thickness", given.thickness, "Sum of the heights of all layers [m]"
    );
    entries.readBounded
    (
        "expansionRatio", given.expansionRatio, heightSeries::minRatio,
        heightSeries::maxRatio,
        "Height of a layer over the height of the layer before it", "1.2"
    );
    entries.readFlag
    (
        "relativeSizes", given.relativeSizes,
        "Heights are in units of local edges, or cells: see relativeTo"
    );
    if (entries.dict() && entries.dict()->found("yPlus", keyType::LITERAL))
    {
        checkYPlus(*entries.dict(), hasFirst, given);
        mandatoryDict(*entries.dict(), "yPlus");
    }
    const word name(entries.dict() ? entries.dict()->dictName() : word());
    entries.readDict
    (
        "yPlus", "The first height by y+ of a turbulent flat plate",
        [&](controlEntries& yPlus) { declareYPlus(yPlus, name, given, run); }
    );
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


//- Entries for a part of the wall, checked together with the general entries
static void declarePart
(
    controlEntries& entries,
    const layerControls& general,
    const label leastNumber,
    heightEntries& given
)
{
    given.relativeSizes = general.heights.relativeSizes;
    declare(entries, given);
    const bool hasNumber = entries.readBounded
    (
        "nSurfaceLayers", given.nSurfaceLayers, leastNumber,
        heightSeries::maxLayers, "Number of layers there"
    );

    const dictionary* dict = entries.dict();
    if (dict && hasNumber && given.nSurfaceLayers && general.automatic())
    {
        entryError(*dict, "nSurfaceLayers")
            << "Value of nSurfaceLayers for " << dict->dictName() << " is "
            << given.nSurfaceLayers << ", but layers.nSurfaceLayers auto is for"
            << " all of the wall" << nl
            << "Remove nSurfaceLayers from " << dict->dictName()
            << exit(FatalIOError);
    }
    if (dict && general.automatic())
    {
        checkAutomatic(*dict, given);
    }

    // In other units, or on heights of a run, they are checked at each point
    // later
    if
    (
        dict
     && given.relativeSizes == general.heights.relativeSizes
     && !general.fromRun.isGiven()
    )
    {
        atEntriesOf(*dict, [&]()
        {
            const heightSeries before
            (
                changedHeights(heightSeries(), general.heights, 1)
            );
            changedHeights(before, given, 1);
        });
    }
}


//- What is said of patches: of those with 0 layers nothing but their type
static void declarePatches
(
    controlEntries& entries,
    const keyType& key,
    const layerControls& general,
    patchLayers& patches
)
{
    patches.patches = key;
    entries.readChoice("type", patches.type, sideTypes, "Type of the patch");

    const dictionary* dict = entries.dict();
    patches.isSide = dict
     && dict->lookupOrDefault<label>
        (
            "nSurfaceLayers", -1, keyType::LITERAL
        ) == 0;
    if (patches.isSide && dict->size() > (patches.type.empty() ? 1 : 2))
    {
        entryError(*dict, "nSurfaceLayers")
            << "Patches " << key << " have no layers, and so no heights"
            << nl << "Remove nSurfaceLayers 0, or all entries but type"
            << exit(FatalIOError);
    }
    declarePart(entries, general, 0, patches.heights);
}


//- n, or auto
static void declareNumber(controlEntries& entries, layerControls& controls)
{
    const string range("[1, " + name(heightSeries::maxLayers) + "], auto");
    label& n = controls.heights.nSurfaceLayers;
    const bool isThere =
        entries.has("nSurfaceLayers", "Number of layers", range);
    entries.require("nSurfaceLayers");
    word number("auto");
    if
    (
        isThere
     && entries.dict()->get<token>("nSurfaceLayers", keyType::LITERAL).isWord()
    )
    {
        entries.readChoice("nSurfaceLayers", number, {number}, "");
    }
    else if (isThere)
    {
        entries.readBounded
        (
            "nSurfaceLayers", n, 1, heightSeries::maxLayers, ""
        );
    }

    const bool hasAspect = entries.readBounded
    (
        "finalAspect", controls.finalAspect, 0.01, 100,
        "Height of the last layer over local edges, with nSurfaceLayers auto"
    );
    if (hasAspect && !controls.automatic())
    {
        entryError(*entries.dict(), "finalAspect")
            << "finalAspect is for nSurfaceLayers auto, but nSurfaceLayers is "
            << n << exit(FatalIOError);
    }
}


static void declare(controlEntries& entries, heightField& field)
{
    entries.read
    (
        "file", field.file, "A VTK file, or a list of OpenFOAM", "file"
    );
    entries.read("field", field.field, "Field of the VTK file", "word");
    entries.require("file");
    if (entries.dict() && field.file.empty())
    {
        entryError(*entries.dict(), "file")
            << "Value of file is empty; it must be the name of a file of values"
            << exit(FatalIOError);
    }
}


static void declareFields(controlEntries& entries, layerControls& controls)
{
    entries.readDict
    (
        "fields", "Heights from files, at the points of the wall",
        [&](controlEntries& fields)
        {
            fields.readDict
            (
                "firstLayerThickness", "Height of the first layer [m]",
                [&](controlEntries& first)
                {
                    declare(first, controls.firstLayerField);
                }
            );
            fields.readDict
            (
                "thickness", "Sum of the heights of all layers [m]",
                [&](controlEntries& total)
                {
                    declare(total, controls.thicknessField);
                }
            );
        }
    );
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


//- Refuses heights that are missing, or contradict each other
static void checkHeights(const dictionary& dict, const layerControls& controls)
{
    const heightEntries& given = controls.heights;
    if (controls.automatic())
    {
        checkAutomatic(dict, given);
    }
    if (controls.automatic() && controls.thicknessField.isGiven())
    {
        entryError(dict, "fields")
            << "With nSurfaceLayers auto, fields may have firstLayerThickness"
            << " alone" << exit(FatalIOError);
    }
    if (controls.fromRun.isGiven())
    {
        checkRun(dict, controls);
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


//- Declares where columns go
static void declareMarching(controlEntries& entries, layerControls& controls)
{
    entries.readChoice
    (
        "relativeTo", controls.relativeToCells, {"edges", "cells"},
        "Unit of relative heights: edges of the wall, or cells beside it"
    );
    entries.readChoice
    (
        "marchingDistances", controls.onLevelSets, {"requested", "levelSets"},
        "Layers end at their heights, or on level sets of the field"
    );
    entries.readChoice
    (
        "marchingDirections", controls.alongField, {"axes", "field"},
        "Columns stand on axes of visibility, or follow the field"
    );
    entries.readBounded
    (
        "transitionRatio", controls.transitionRatio, 1.01, 100,
        "Height over the height at a neighbour where both differ, at most"
    );
    entries.readBounded
    (
        "maxStretch", controls.maxStretch, 1, 10,
        "Length of a column over its height at sharp points, at most"
    );
    entries.readBounded
    (
        "multipleNormalsAngle", controls.multipleNormalsAngle, 0, 90,
        "Several columns where a face is seen under a smaller angle [deg]"
    );
    entries.readFlag
    (
        "allowPoorHeights", controls.allowPoorHeights,
        "A mesh is written also if its heights are useless"
    );
}


void declare(controlEntries& entries, layerControls& controls)
{
    declare(entries, controls.heights, &controls.fromRun);
    declareNumber(entries, controls);
    declareFields(entries, controls);
    if (entries.dict())
    {
        checkHeights(*entries.dict(), controls);
    }
    declareMarching(entries, controls);
    entries.readDicts
    (
        "patches", controls.patches, "Layers on patches",
        [&](controlEntries& part, const keyType& key, patchLayers& patches)
        {
            declarePatches(part, key, controls, patches);
        }
    );
    entries.readDicts
    (
        "regions", controls.regions, "Layers in parts of space",
        [&](controlEntries& part, const keyType& key, layerRegion& region)
        {
            declareRegion(part, key, region);
            declarePart(part, controls, 1, region.heights);
        }
    );
}

} // End namespace Foam

// ************************************************************************* //
