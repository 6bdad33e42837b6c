/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readPrismLayerControls.H"
#include "controlEntries.H"
#include "readFieldControls.H"
#include "readFarFieldControls.H"
#include "readLayerControls.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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

    readBounded(dict, "scale", 1e-9, 1e9, controls.scale);
    readBounded(dict, "mergeTolerance", 0, 1e-3, controls.mergeTolerance);

    return controls;
}


static envelopeControls readEnvelope(const dictionary& dict)
{
    checkKeys(dict, {"scale"});

    envelopeControls controls;
    readBounded(dict, "scale", 1, 10, controls.scale);

    return controls;
}


static backgroundMeshControls readBackgroundMesh
(
    const dictionary& dict,
    const bool onLevelSets
)
{
    checkKeys(dict, {"radiusEdgeRatio", "minSheets"});

    backgroundMeshControls controls;
    if (onLevelSets)
    {
        controls.minSheets = backgroundMeshControls::levelSetSheets;
    }
    readBounded(dict, "minSheets", 0, 10, controls.minSheets);
    readBounded(dict, "radiusEdgeRatio", 1, 10, controls.radiusEdgeRatio);

    return controls;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

prismLayerControls readPrismLayerControls(const dictionary& dict)
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
    controls.surface = readSurface(mandatoryDict(dict, "surface"));
    controls.layers = readLayerControls(mandatoryDict(dict, "layers"));
    controls.envelope = readEnvelope(optionalDict(dict, "envelope"));
    controls.backgroundMesh =
        readBackgroundMesh
        (
            optionalDict(dict, "backgroundMesh"), controls.layers.onLevelSets
        );
    controls.field = readFieldControls
    (
        optionalDict(dict, "field"), controls.layers.onLevelSets
    );
    controls.farField = readFarFieldControls
    (
        optionalDict(dict, "farField"), controls.surface.fluidOutside
    );

    return controls;
}

} // End namespace Foam

// ************************************************************************* //
