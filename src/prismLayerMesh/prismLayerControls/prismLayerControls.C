/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "prismLayerControls.H"
#include "controlEntries.H"
#include "diffusionTensor.H"
#include "readLayerThickness.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The sub-dictionary, or an empty one
static const dictionary& optional(const dictionary& dict, const word& key)
{
    if (!dict.found(key, keyType::LITERAL))
    {
        return dictionary::null;
    }

    if (!dict.isDict(key, keyType::LITERAL))
    {
        entryError(dict, key)
            << "The entry " << key << " of " << dict.dictName()
            << " must be a dictionary" << exit(FatalIOError);
    }

    return dict.subDict(key, keyType::LITERAL);
}


static const dictionary& mandatory(const dictionary& dict, const word& key)
{
    if (!dict.found(key, keyType::LITERAL))
    {
        entryError(dict, key)
            << "The dictionary " << key << " is missing"
            << exit(FatalIOError);
    }

    return optional(dict, key);
}


static wallSurfaceControls readSurface(const dictionary& dict)
{
    checkKeys(dict, {"file", "fluid", "scale", "mergeTolerance"});

    wallSurfaceControls controls;
    dict.readEntry("file", controls.file);

    if (controls.file.empty())
    {
        entryError(dict, "file")
            << "Value of file is empty; it must be the name of a surface file"
            << exit(FatalIOError);
    }

    word fluid(controls.fluidOutside ? "outside" : "inside");
    readChoice(dict, "fluid", {"outside", "inside"}, fluid);
    controls.fluidOutside = (fluid == "outside");

    readBounded(dict, "scale", scalar(1e-9), scalar(1e9), controls.scale);
    readBounded
    (
        dict, "mergeTolerance",
        scalar(0), scalar(1e-3), controls.mergeTolerance
    );

    return controls;
}


static patchLayers readPatch
(
    const dictionary& dict,
    const keyType& patches,
    const layerControls& layers
)
{
    wordList keys(layerThicknessKeys);
    keys.append("nSurfaceLayers");
    checkKeys(dict, keys);

    label n = layers.nSurfaceLayers;
    readBounded(dict, "nSurfaceLayers", label(0), label(1000), n);

    if (n != layers.nSurfaceLayers)
    {
        entryError(dict, "nSurfaceLayers")
            << "Value of nSurfaceLayers for the patches " << patches << " is "
            << n << "; numbers of layers that differ between patches are not"
            << " available yet, it must be " << layers.nSurfaceLayers
            << exit(FatalIOError);
    }

    patchLayers entry;
    entry.patches = patches;
    entry.thickness = readLayerThickness(dict, n, layers.thickness);

    return entry;
}


static layerControls readLayers(const dictionary& dict)
{
    wordList keys(layerThicknessKeys);
    keys.append
    (
        wordList
        ({
            "nSurfaceLayers",
            "transitionRatio",
            "maxStretch",
            "multipleNormalsAngle",
            "patches"
        })
    );
    checkKeys(dict, keys);

    layerControls controls;
    label& n = controls.nSurfaceLayers;

    if (!readBounded(dict, "nSurfaceLayers", label(1), label(1000), n))
    {
        entryError(dict, "nSurfaceLayers")
            << "The entry nSurfaceLayers of " << dict.dictName()
            << " is missing" << exit(FatalIOError);
    }

    controls.thickness = readLayerThickness(dict, n);
    readBounded
    (
        dict, "transitionRatio",
        scalar(1.01), scalar(100), controls.transitionRatio
    );
    readBounded
    (
        dict, "maxStretch", scalar(1), scalar(10), controls.maxStretch
    );
    readBounded
    (
        dict, "multipleNormalsAngle", scalar(0), scalar(90),
        controls.multipleNormalsAngle
    );

    DynamicList<patchLayers> patches;

    const dictionary& entries = optional(dict, "patches");

    for (const entry& e : entries)
    {
        if (!e.isDict())
        {
            entryError(entries, e.keyword())
                << "The entry " << e.keyword() << " of patches must be a"
                << " dictionary" << exit(FatalIOError);
        }

        patches.append(readPatch(e.dict(), e.keyword(), controls));
    }

    controls.patches.transfer(patches);

    return controls;
}


static envelopeControls readEnvelope(const dictionary& dict)
{
    checkKeys(dict, {"scale"});

    envelopeControls controls;
    readBounded(dict, "scale", scalar(1), scalar(10), controls.scale);

    return controls;
}


static backgroundMeshControls readBackgroundMesh(const dictionary& dict)
{
    checkKeys(dict, {"radiusEdgeRatio"});

    backgroundMeshControls controls;
    readBounded
    (
        dict, "radiusEdgeRatio",
        scalar(1), scalar(10), controls.radiusEdgeRatio
    );

    return controls;
}


static fieldControls readField(const dictionary& dict)
{
    const wordList models
    (
        diffusionTensor::dictionaryConstructorTablePtr_->sortedToc()
    );
    wordList keys({"tensor", "solver", "tolerance"});

    for (const word& model : models)
    {
        keys.append(model + "Coeffs");
    }

    checkKeys(dict, keys);

    fieldControls controls;
    readChoice(dict, "tensor", models, controls.tensor);
    readChoice(dict, "solver", {"krylov", "iteration"}, controls.solver);
    readBounded
    (
        dict, "tolerance",
        scalar(1e-14), scalar(0.1), controls.tolerance
    );

    // Its coefficients are checked here, not when they are used in mid-run
    controls.tensorCoeffs = optional(dict, controls.tensor + "Coeffs");
    diffusionTensor::New(controls.tensor, controls.tensorCoeffs);

    return controls;
}


static word readFarField(const dictionary& dict)
{
    checkKeys(dict, {"type"});

    word type(prismLayerControls().farFieldType);
    readChoice(dict, "type", {"none"}, type);

    return type;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::prismLayerControls Foam::readPrismLayerControls(const dictionary& dict)
{
    checkKeys
    (
        dict,
        {
            "surface",
            "layers",
            "envelope",
            "backgroundMesh",
            "field",
            "farField"
        }
    );

    prismLayerControls controls;
    controls.surface = readSurface(mandatory(dict, "surface"));
    controls.layers = readLayers(mandatory(dict, "layers"));
    controls.envelope = readEnvelope(optional(dict, "envelope"));
    controls.backgroundMesh =
        readBackgroundMesh(optional(dict, "backgroundMesh"));
    controls.field = readField(optional(dict, "field"));
    controls.farFieldType = readFarField(optional(dict, "farField"));

    return controls;
}


// ************************************************************************* //
