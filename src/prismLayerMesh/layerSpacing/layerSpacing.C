/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerSpacing.H"
#include "HashSet.H"
#include "limitGradient.H"
#include "OStringStream.H"
#include "ranges.H"

#include <algorithm>

namespace Foam
{

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
        forAll(patchNames, patchi)
        {
            if (!entry.isSide && entry.patches.match(patchNames[patchi]))
            {
                result[patchi] = &entry.heights;
            }
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
                << controls.regions[i].name << " of layers.regions" << nl
                << "Check its geometry, mode and distance" << exit(FatalError);
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


namespace
{

//- The heights that are asked for at a point of the wall. The general entries
//  come first, then local values, patches and regions. Each of them replaces
//  entries of the ones before it.
class pointHeights
{
    const wallSurface& wall_;
    const wallAddressing& addressing_;
    const layerControls& controls_;
    const localHeights& local_;
    const List<const heightEntries*> ofPatch_;

    //- Unit of relative sizes at each point, or empty
    const scalarField& units_;


    scalar unit(const label p) const
    {
        return units_.size() ? units_[p] : 1;
    }

    //- Whether the earlier mesh of a run gives the thickness
    bool ofEarlierMesh() const
    {
        return
            controls_.fromRun.isGiven() && !controls_.thicknessField.isGiven()
         && local_.thickness.size();
    }

    //- Heights by the general entries. Heights of files, or of a run, replace
    //  the general heights.
    heightSeries generalHeights(const label p) const
    {
        heightEntries ofPoint;
        ofPoint.firstLayerThickness =
            local_.firstThickness.size() ? local_.firstThickness[p] : 0;
        ofPoint.thickness = local_.thickness.size() ? local_.thickness[p] : 0;

        if (!controls_.fromRun.isGiven())
        {
            return changedHeights
            (
                changedHeights(heightSeries(), controls_.heights, unit(p)),
                ofPoint,
                1
            );
        }

        // The general entries have no first height
        heightEntries given(controls_.heights);
        given.yPlus = controls_.fromRun.target;
        given.firstLayerThickness = ofPoint.firstLayerThickness;
        if (ofPoint.thickness > 0)
        {
            given.thickness = ofPoint.thickness;
        }

        return changedHeights(heightSeries(), given, 1);
    }

    //- Heights by the general entries, then by the patches of p
    heightSeries patchHeights(const label p) const
    {
        const heightSeries general(generalHeights(p));
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


public:

    //- All arguments must outlive the object.
    //  Errors: FatalError if an entry for patches matches no patch, or a region
    //  has no point
    pointHeights
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

    //- Heights at the point p.
    //  Errors: FatalError if heights are out of their bounds
    heightSeries of(const label p) const
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
                << " of the wall: " << error.what()
                << (ofEarlierMesh() ? "\nThe thickness is that of the earlier"
                    " mesh. layers.thickness asks for another one" : "")
                << exit(FatalError);
        }

        return heights;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * *  Layer Spacing  * * * * * * * * * * * * * * //

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

    #pragma omp parallel for schedule(static, 256)
    forAll(spacing.thickness, p)
    {
        scalarList column(n + 1);
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


// * * * * * * * * * * * * *  Make Layer Spacing * * * * * * * * * * * * * * //

//- Share of the area of the wall on which an automatic number of layers is
//  enough for the last of them to be as high as asked for
static const scalar automaticShare = 0.95;


static bool hasRelativeSizes(const layerControls& controls)
{
    const auto isRelative = [](const auto& entry)
    {
        return entry.heights.relativeSizes;
    };

    return
        isRelative(controls)
     || anyOf(controls.patches, isRelative)
     || anyOf(controls.regions, isRelative);
}


//- Number of layers until the last one is as high as asked for, at points that
//  have a share of the area of the wall
static label automaticNumber
(
    const wallSurface& wall,
    const List<heightSeries>& heights,
    const scalarField& finalHeights
)
{
    scalarField areas(heights.size(), 0);
    for (const face& f : wall.faces)
    {
        const scalar share = f.mag(wall.points)/f.size();

        for (const label p : f)
        {
            areas[p] += share;
        }
    }

    List<std::pair<scalar, label>> numbers(heights.size());

    forAll(heights, p)
    {
        const heightSeries& series = heights[p];

        if (series.expansionRatio <= 1)
        {
            FatalErrorInFunction
                << "With nSurfaceLayers auto the expansionRatio must be more"
                << " than 1; it is " << series.expansionRatio
                << " at the point " << wall.points[p] << exit(FatalError);
        }

        const scalar growth =
            max(finalHeights[p]/series.firstLayerThickness, 1.0);

        numbers[p].first = 1 + ::log(growth)/::log(series.expansionRatio);
        numbers[p].second = p;
    }

    std::sort(numbers.begin(), numbers.end());

    scalar left = automaticShare*sum(areas);
    label i = 0;
    while (i + 1 < numbers.size() && (left -= areas[numbers[i].second]) > 0)
    {
        ++i;
    }

    // Rounded up, so that ratios are lowered rather than raised
    const label n = ::ceil(numbers[i].first - 1e-6);

    return min(n, heightSeries::maxLayers);
}


//- Lower the ratio where the last of n layers would be higher than asked for
static void limitFinalHeight
(
    const label n,
    const scalar finalHeight,
    heightSeries& heights
)
{
    heights.n = n;

    if (n > 1)
    {
        const scalar growth = max(finalHeight/heights.firstLayerThickness, 1.0);

        heights.expansionRatio =
            min(heights.expansionRatio, ::pow(growth, 1.0/(n - 1)));
    }
}


//- The ratio with which n layers have first height and thickness of fewer, or
//  are uniform
static scalar ratioOfMore(const label n, const heightSeries& fewer)
{
    const scalar h1 = fewer.firstLayerThickness;
    const scalar thickness = totalThickness(fewer.n, h1, fewer.expansionRatio);

    return thickness > n*h1
      ? fittedRatio(n, h1, thickness)
      : min(fewer.expansionRatio, scalar(1));
}


scalarField localEdgeLengths
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const scalar growth
)
{
    scalarField lengths(meanEdges(wall, addressing));
    limitRatio(addressing, growth, lengths);

    return lengths;
}


//- Returns the units of relative heights; empty if they are not needed
static scalarField unitLengths
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const layerControls& controls,
    const localHeights& local
)
{
    if (!controls.automatic() && !hasRelativeSizes(controls))
    {
        return scalarField();
    }

    const scalarField edges
    (
        localEdgeLengths(wall, addressing, controls.transitionRatio)
    );

    return local.largestCells.empty()
      ? edges : scalarField(min(edges, local.largestCells));
}


layerSpacing makeLayerSpacing
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const layerControls& controls,
    const localHeights& local
)
{
    const scalarField units(unitLengths(wall, addressing, controls, local));
    const pointHeights asked(wall, addressing, controls, local, units);
    List<heightSeries> heights(wall.points.size());
    label n = 1;

    forAll(heights, p)
    {
        heights[p] = asked.of(p);
        n = max(n, heights[p].n);
    }

    if (controls.automatic())
    {
        const scalarField finalHeights(controls.finalAspect*units);
        n = automaticNumber(wall, heights, finalHeights);

        forAll(heights, p)
        {
            limitFinalHeight(n, finalHeights[p], heights[p]);
        }
    }

    layerSpacing spacing;
    spacing.nLayers = n;
    spacing.firstThickness.setSize(heights.size());
    spacing.ratio.setSize(heights.size());
    spacing.thickness.setSize(heights.size());
    spacing.layersAsked.setSize(heights.size());

    forAll(heights, p)
    {
        const heightSeries& series = heights[p];
        const scalar h1 = series.firstLayerThickness;
        const scalar ratio =
            series.n < n ? ratioOfMore(n, series) : series.expansionRatio;

        spacing.firstThickness[p] = h1;
        spacing.ratio[p] = ratio;
        spacing.thickness[p] = totalThickness(n, h1, ratio);
        spacing.layersAsked[p] = series.n;
    }

    return spacing;
}

} // End namespace Foam

// ************************************************************************* //
