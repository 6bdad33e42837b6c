/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readRegions.H"
#include "Enum.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

const wordList geometryRegionKeys
({
    "geometry", "mode", "distance"
});

static const Enum<geometryRegion::modes> modeNames
({
    {Foam::geometryRegion::modes::inside, "inside"},
    {Foam::geometryRegion::modes::outside, "outside"},
    {Foam::geometryRegion::modes::distance, "distance"}
});


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

geometryRegion readGeometryRegion(const dictionary& dict)
{
    geometryRegion region;
    region.name = dict.dictName();
    region.geometry = mandatoryDict(dict, "geometry");

    word mode(modeNames[region.mode]);
    readChoice(dict, "mode", modeNames.names(), mode);
    region.mode = modeNames[mode];

    const bool hasDistance =
        readBounded(dict, "distance", SMALL, GREAT, region.distance);

    if (hasDistance != (region.mode == geometryRegion::modes::distance))
    {
        entryError(dict, hasDistance ? "distance" : "mode")
            << "The region " << region.name << " has mode " << mode
            << (hasDistance ? " with a distance" : " without a distance")
            << exit(FatalIOError);
    }

    return region;
}

} // End namespace Foam

// ************************************************************************* //
