/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pointHeights.H"
#include "FlatOutput.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The entry for each patch, or null
static List<const heightEntries*> patchEntries
(
    const wordList& patchNames,
    const layerControls& controls
)
{
    List<const heightEntries*> result(patchNames.size(), nullptr);

    for (const patchLayers& entry : controls.patches)
    {
        bool used = false;

        forAll(patchNames, patchi)
        {
            if (!entry.isSide && entry.patches.match(patchNames[patchi]))
            {
                result[patchi] = &entry.heights;
                used = true;
            }
        }

        if (!used && !entry.isSide)
        {
            FatalErrorInFunction
                << "The entry " << entry.patches << " of layers.patches"
                << " matches no patch of the surface" << nl
                << "Its patches: " << flatOutput(patchNames)
                << exit(FatalError);
        }
    }

    return result;
}


static void checkRegions
(
    const layerControls& controls,
    const localHeights& local
)
{
    forAll(controls.regions, i)
    {
        if (!local.inRegion[i].found(true))
        {
            FatalErrorInFunction
                << "There is no point of the wall in the region "
                << controls.regions[i].name << " of layers.regions"
                << exit(FatalError);
        }
    }
}


//- Whether a is lower than b, first by its first layer
static bool thinner(const heightSeries& a, const heightSeries& b)
{
    const scalar h1 = a.firstLayerThickness;

    return h1 == b.firstLayerThickness
      ? totalThickness(a.n, h1, a.expansionRatio)
      < totalThickness(b.n, h1, b.expansionRatio)
      : h1 < b.firstLayerThickness;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

scalar pointHeights::unit(const label p) const
{
    return units_.size() ? units_[p] : 1;
}


heightEntries pointHeights::generalEntries(const label p) const
{
    const bool hasFirst = local_.firstThickness.size();
    const bool hasTotal = local_.thickness.size();
    heightEntries given;

    given.firstLayerThickness = hasFirst ? local_.firstThickness[p] : 0;
    given.thickness = hasTotal ? local_.thickness[p] : 0;

    return given;
}


heightSeries pointHeights::patchHeights(const label p) const
{
    const heightSeries general
    (
        changedHeights
        (
            changedHeights(heightSeries(), controls_.heights, unit(p)),
            generalEntries(p),
            1
        )
    );
    heightSeries thinnest(general);
    thinnest.firstLayerThickness = VGREAT;

    for (const label facei : addressing_.pointFaces[p])
    {
        const heightEntries* given = ofPatch_[wall_.patchIDs[facei]];
        const heightSeries ofFace
        (
            given ? changedHeights(general, *given, unit(p)) : general
        );

        if (thinner(ofFace, thinnest))
        {
            thinnest = ofFace;
        }
    }

    return thinnest;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

pointHeights::pointHeights
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const layerControls& controls,
    const localHeights& local,
    const scalarField& units
)
:
    wall_(wall),
    addressing_(addressing),
    controls_(controls),
    local_(local),
    ofPatch_(patchEntries(wall.patchNames, controls)),
    units_(units)
{
    checkRegions(controls, local);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

heightSeries pointHeights::of(const label p) const
{
    heightSeries heights;

    try
    {
        heights = patchHeights(p);

        forAll(controls_.regions, i)
        {
            if (local_.inRegion[i][p])
            {
                heights = changedHeights
                (
                    heights, controls_.regions[i].heights, unit(p)
                );
            }
        }
    }
    catch (const heightEntriesError& error)
    {
        FatalErrorInFunction
            << "Heights of the layers at the point " << wall_.points[p]
            << " of the wall: " << error.what() << exit(FatalError);
    }

    return heights;
}

} // End namespace Foam

// ************************************************************************* //
