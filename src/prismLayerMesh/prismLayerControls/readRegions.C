/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "readRegions.H"
#include "Enum.H"

// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

const Foam::wordList Foam::geometryRegionKeys
({
    "geometry", "mode", "distance"
});

static const Foam::Enum<Foam::geometryRegion::modes> modeNames
({
    {Foam::geometryRegion::modes::inside, "inside"},
    {Foam::geometryRegion::modes::outside, "outside"},
    {Foam::geometryRegion::modes::distance, "distance"}
});


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::geometryRegion Foam::readGeometryRegion(const dictionary& dict)
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


// ************************************************************************* //
