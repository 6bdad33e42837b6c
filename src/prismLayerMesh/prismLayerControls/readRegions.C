/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "readRegions.H"

// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

const Foam::wordList Foam::geometryRegionKeys
({
    "geometry", "mode", "distance"
});


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::geometryRegion Foam::readGeometryRegion(const dictionary& dict)
{
    geometryRegion region;
    region.name = dict.dictName();
    region.geometry = mandatoryDict(dict, "geometry");

    word mode("inside");
    readChoice(dict, "mode", {"inside", "outside", "distance"}, mode);
    region.mode =
        mode == "inside" ? geometryRegion::modes::inside
      : mode == "outside" ? geometryRegion::modes::outside
      : geometryRegion::modes::distance;

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


void Foam::forEntries
(
    const dictionary& dict,
    const word& key,
    const std::function<void(const keyType&, const dictionary&)>& read
)
{
    const dictionary& entries = optionalDict(dict, key);

    for (const entry& e : entries)
    {
        if (!e.isDict())
        {
            entryError(entries, e.keyword())
                << "The entry " << e.keyword() << " of " << key
                << " must be a dictionary" << exit(FatalIOError);
        }

        read(e.keyword(), e.dict());
    }
}


// ************************************************************************* //
