/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerSpacing.H"
#include "limitGradient.H"
#include "HashSet.H"
#include "OStringStream.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- "1e-05", or "1e-05 to 3e-05"
template<class Type>
static string range(const UList<Type>& values)
{
    const Type low = *std::min_element(values.begin(), values.end());
    const Type high = *std::max_element(values.begin(), values.end());

    OStringStream os;
    os.precision(4);
    os  << low;

    if (high - low > 1e-9*high)
    {
        os  << " to " << high;
    }

    return os.str();
}


//- Empty where the height is not from y+
static std::string yPlusLine
(
    const std::string& name,
    const heightEntries& given
)
{
    if (!(given.yPlus > 0))
    {
        return std::string();
    }

    OStringStream os;
    os  << name.c_str() << ": y+ " << given.yPlus
        << " on a turbulent flat plate at Re " << given.Re
        << " gives the first height " << given.firstLayerThickness << " m"
        << nl;

    return os.str();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

layerSpacing layerSpacing::at(const labelUList& points) const
{
    return mapped([&](const auto& values, const label nEach)
    {
        std::decay_t<decltype(values)> chosen(points.size()*nEach);
        forAll(chosen, i)
        {
            chosen[i] = values[points[i/nEach]*nEach + i % nEach];
        }

        return chosen;
    });
}


scalarField layerSpacing::givenLayer(const label i) const
{
    scalarField heights(thickness.size());
    forAll(heights, p)
    {
        heights[p] = given[p*nLayers + i - 1];
    }

    return heights;
}


void layerSpacing::setGivenLayer(const label i, const scalarField& heights)
{
    forAll(heights, p)
    {
        given[p*nLayers + i - 1] = heights[p];
    }
}


void layerSpacing::fitRatio(const label p)
{
    if (nLayers > 1)
    {
        ratio[p] = fittedRatio(nLayers, firstThickness[p], thickness[p]);
    }
}


void layerSpacing::setHeights
(
    const label p,
    const scalar room,
    UList<scalar>& heights
) const
{
    if (given.empty())
    {
        layerHeights(nLayers, firstThickness[p], ratio[p], room, heights);
        return;
    }

    const scalar share = min(room/thickness[p], scalar(1));
    heights[0] = 0;
    for (label i = 1; i <= nLayers; ++i)
    {
        heights[i] = share*given[p*nLayers + i - 1];
    }

    // Exact in spite of rounding
    heights[nLayers] = min(room, thickness[p]);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

layerSpacing gradedSpacing
(
    const layerSpacing& asked,
    const wallAddressing& addressing,
    const scalar growth
)
{
    layerSpacing graded(asked);
    labelList lowered(limitRatio(addressing, growth, graded.firstThickness));
    lowered.append(limitRatio(addressing, growth, graded.thickness));

    for (label i = 1; i <= asked.nLayers && graded.given.size(); ++i)
    {
        scalarField layer(graded.givenLayer(i));
        limitRatio(addressing, growth, layer);
        graded.setGivenLayer(i, layer);
    }

    for (const label p : lowered)
    {
        graded.fitRatio(p);
    }

    return graded;
}


scalarField requestedHeights(const layerSpacing& spacing)
{
    const label n = spacing.nLayers;
    scalarField heights(spacing.thickness.size()*n);
    scalarList column(n + 1);

    forAll(spacing.thickness, p)
    {
        spacing.setHeights(p, spacing.thickness[p], column);
        std::copy(column.begin() + 1, column.end(), heights.begin() + p*n);
    }

    return heights;
}


string describe
(
    const layerSpacing& asked,
    const wallSurface& wall,
    const layerControls& controls
)
{
    List<labelHashSet> points(wall.patchNames.size());

    forAll(wall.faces, facei)
    {
        points[wall.patchIDs[facei]].insert(wall.faces[facei]);
    }

    std::string text(yPlusLine("layers", controls.heights));
    for (const patchLayers& entry : controls.patches)
    {
        text += yPlusLine(entry.patches, entry.heights);
    }
    for (const layerRegion& region : controls.regions)
    {
        text += yPlusLine(region.name, region.heights);
    }

    forAll(points, patchi)
    {
        if (points[patchi].empty())
        {
            continue;
        }

        const layerSpacing ofPatch(asked.at(points[patchi].sortedToc()));

        text += wall.patchNames[patchi]
          + ": layers " + range(ofPatch.layersAsked)
          + ", first height " + range(ofPatch.firstThickness)
          + " m, ratio " + range(ofPatch.ratio)
          + ", thickness " + range(ofPatch.thickness) + " m\n";
    }

    return text;
}

} // End namespace Foam

// ************************************************************************* //
