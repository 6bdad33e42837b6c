/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readLayerHeights.H"
#include "controlEntries.H"
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


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static void readYPlus(const dictionary& dict, heightEntries& given)
{
    checkKeys(dict, {"target", "U", "nu", "L"});

    const scalar yPlus = readMandatory(dict, "target", 1e-3, 1e4);
    const scalar U = readMandatory(dict, "U", 1e-9, 1e6);
    const scalar nu = readMandatory(dict, "nu", 1e-12, 1e3);
    const scalar L = readMandatory(dict, "L", 1e-9, 1e6);

    given.firstLayerThickness = flatPlateThickness(yPlus, U, nu, L);
    given.yPlus = yPlus;
    given.Re = U*L/nu;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

heightEntries readLayerHeights(const dictionary& dict, const bool relativeSizes)
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
                << " layer of " << dict.dictName() << exit(FatalIOError);
        }
        if (given.relativeSizes)
        {
            entryError(dict, "yPlus")
                << "yPlus gives a height in metres, but the heights of "
                << dict.dictName() << " are relativeSizes"
                << exit(FatalIOError);
        }

        readYPlus(mandatoryDict(dict, "yPlus"), given);
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

} // End namespace Foam

// ************************************************************************* //
