/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchReport.H"
#include "bitSet.H"
#include "FixedList.H"
#include "layerGeometry.H"
#include "ListOps.H"

#include <algorithm>
#include <cstring>
#include <iomanip>
#include <numeric>
#include <sstream>

#if defined(__GLIBCXX__) && defined(_OPENMP)
#include <parallel/algorithm>
#endif

namespace Foam
{

//- The shares of the values that are looked for [%]
static const label nShares = 7;
static const scalar shares[nShares] = {0, 1, 5, 50, 95, 99, 100};

typedef FixedList<std::int64_t, nShares> ranks;


//- Index of the value of the nearest rank, in ascending order
static std::int64_t rankOf(const scalar percent, const std::int64_t n)
{
    return std::int64_t(0.01*percent*(n - 1) + 0.5);
}


//- An integer for each value, in the same order
static std::int64_t orderOf(const scalar value)
{
    std::int64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));

    return bits < 0 ? std::int64_t(std::uint64_t(1) << 63) - bits : bits;
}


static scalar valueOf(const std::int64_t order)
{
    const std::int64_t bits =
        order < 0 ? std::int64_t(std::uint64_t(1) << 63) - order : order;
    scalar value = 0;
    std::memcpy(&value, &bits, sizeof(value));

    return value;
}


//- As std::nth_element, on several threads if the library can do that
template<class Iterator>
static void setNthElement(Iterator first, Iterator nth, Iterator last)
{
    #if defined(__GLIBCXX__) && defined(_OPENMP)
    __gnu_parallel::nth_element(first, nth, last);
    #else
    std::nth_element(first, nth, last);
    #endif
}


//- The percentiles of the values of one process
static percentiles ofOneProcess(scalarField& values)
{
    percentiles result;

    // The median first: of the other values those on one side are looked at
    const auto at = [&](const scalar percent)
    {
        return values.begin() + label(rankOf(percent, values.size()));
    };
    const auto percentile =
        [&](const scalar below, const scalar percent, const scalar above)
    {
        setNthElement(at(below), at(percent), at(above) + 1);

        return *at(percent);
    };

    result.mean = average(values);
    result.min = min(values);
    result.max = max(values);
    result.p50 = percentile(0, 50, 100);
    result.p5 = percentile(0, 5, 50);
    result.p1 = percentile(0, 1, 5);
    result.p95 = percentile(50, 95, 100);
    result.p99 = percentile(95, 99, 100);

    return result;
}


//- Number of values of all processes that are not above bounds
static ranks countUpTo
(
    const scalarField& ascending,
    const ranks& bounds,
    const columnTeam& team
)
{
    ranks own;
    forAll(own, i)
    {
        own[i] = std::upper_bound
        (
            ascending.begin(), ascending.end(), valueOf(bounds[i])
        ) - ascending.begin();
    }

    return team.reduce(own, [](ranks a, const ranks& b)
    {
        forAll(a, i)
        {
            a[i] += b[i];
        }

        return a;
    });
}


//- The percentiles of the values of all processes: bounds on each percentile
//  are halved until they meet
static percentiles ofTeam
(
    scalarField& values,
    const std::int64_t n,
    const columnTeam& team
)
{
    std::sort(values.begin(), values.end());
    const scalar least = values.size() ? values.first() : GREAT;
    const scalar most = values.size() ? values.last() : -GREAT;
    ranks low(orderOf(team.reduce(least, minOp<scalar>())));
    ranks high(orderOf(team.reduce(most, maxOp<scalar>())));

    while (low != high)
    {
        ranks middle;
        forAll(middle, i)
        {
            // Differences may be beyond the largest signed integer
            const std::uint64_t width =
                std::uint64_t(high[i]) - std::uint64_t(low[i]);
            middle[i] = std::int64_t(std::uint64_t(low[i]) + width/2);
        }
        const ranks nUpTo(countUpTo(values, middle, team));
        forAll(middle, i)
        {
            const bool isEnough = nUpTo[i] > rankOf(shares[i], n);
            low[i] = isEnough || low[i] == high[i] ? low[i] : middle[i] + 1;
            high[i] = isEnough ? middle[i] : high[i];
        }
    }

    return percentiles
    {
        team.sum(values.size() ? Foam::sum(values) : scalar(0))/n,
        valueOf(low[0]), valueOf(low[1]), valueOf(low[2]), valueOf(low[3]),
        valueOf(low[4]), valueOf(low[5]), valueOf(low[6])
    };
}


percentiles makePercentiles(scalarField values, const columnTeam& team)
{
    const std::int64_t n = team.sum(std::int64_t(values.size()));

    return
        n == 0 ? percentiles()
      : team.isAlone() ? ofOneProcess(values)
      : ofTeam(values, n, team);
}


scalar weightedMedian
(
    const scalarField& values,
    const scalarField& weights,
    const columnTeam& team
)
{
    if (team.sum(values.size()) == 0)
    {
        return 0;
    }
    const labelList order(sortedOrder(values));
    const scalarField ascending(values, order);
    scalarField upTo(weights, order);
    std::partial_sum(upTo.begin(), upTo.end(), upTo.begin());
    const auto weightUpTo = [&](const scalar bound)
    {
        const label n = std::upper_bound
        (
            ascending.begin(), ascending.end(), bound
        ) - ascending.begin();

        return team.sum(n ? upTo[n - 1] : scalar(0));
    };

    const scalar half = 0.5*weightUpTo(GREAT);
    std::int64_t low = orderOf(-GREAT);
    std::int64_t high = orderOf(GREAT);
    while (low != high)
    {
        const std::uint64_t width = std::uint64_t(high) - std::uint64_t(low);
        const std::int64_t middle =
            std::int64_t(std::uint64_t(low) + width/2);
        const bool isEnough = weightUpTo(valueOf(middle)) >= half;
        low = isEnough ? low : middle + 1;
        high = isEnough ? middle : high;
    }

    return valueOf(low);
}


// * * * * * * * * * * * * * * *  Face Heights * * * * * * * * * * * * * * * //

scalar faceHeights::leastGrowth(const label facei) const
{
    const label n = growthOverRequest.size()/max(areas.size(), label(1));
    scalar least = 1;
    for (label i = 0; i < n; ++i)
    {
        const scalar growth = growthOverRequest[facei*n + i];
        least = min(least, min(growth, 1/max(growth, VSMALL)));
    }

    return least;
}



faceHeights makeFaceHeights
(
    const wallSurface& wall,
    const layerSpacing& request,
    const prismLayers& layers
)
{
    const label nFaces = wall.faces.size();
    const label n = layers.nLayers;

    faceHeights result;
    result.areas.setSize(nFaces);
    result.first.setSize(nFaces);
    result.firstOverRequest.setSize(nFaces);
    result.totalOverRequest.setSize(nFaces);
    result.growthOverRequest.setSize(nFaces*(n - 1));

    #pragma omp parallel for schedule(static, 256)
    forAll(wall.faces, facei)
    {
        const face& f = wall.faces[facei];
        stackHeights stack(layers);
        stack.compute(facei);
        const scalarField& heights = stack.heights();
        const scalar ratio = average(scalarField(request.ratio, f));

        result.areas[facei] = stack.wallArea();
        result.first[facei] = heights[0];
        result.firstOverRequest[facei] =
            heights[0]/average(scalarField(request.firstThickness, f));
        result.totalOverRequest[facei] =
            sum(heights)/average(scalarField(request.thickness, f));

        for (label i = 1; i < n; ++i)
        {
            result.growthOverRequest[facei*(n - 1) + i - 1] =
                heights[i]/(ratio*max(heights[i - 1], VSMALL));
        }
    }

    return result;
}


scalarField changesOverEdges
(
    const UList<labelPair>& edgeFaces,
    const scalarField& ofFaces
)
{
    scalarField changes(edgeFaces.size());
    forAll(changes, edgei)
    {
        const labelPair& faces = edgeFaces[edgei];
        const scalar a = ofFaces[faces.first()];
        const scalar b = faces.second() < 0 ? a : ofFaces[faces.second()];

        changes[edgei] = max(a, b)/max(min(a, b), VSMALL);
    }

    return changes;
}


// * * * * * * * * * * * * *  Face Quality Report  * * * * * * * * * * * * * //

dictionary toDictionary(const faceQualityCounts& faces)
{
    dictionary beyond;
    for (label k = 0; k < faceQualityCounts::nBounds; ++k)
    {
        beyond.add(faceQualityCounts::names[k], faces.nBeyond[k]);
    }

    dictionary dict;
    dict.add("faces", faces.nFaces);
    dict.add("meanNonOrthogonality", faces.meanNonOrtho());
    dict.add("maxNonOrthogonality", faces.maxNonOrtho);
    dict.add("maxSkewness", faces.maxSkewness);
    dict.add("minFaceWeight", faces.minWeight);
    dict.add("minVolumeRatio", faces.minVolRatio);
    dict.add("poorFaces", faces.nBeyondAny);
    dict.add("nonOrthogonalByWall", faces.nOfWall);
    dict.add("beyond", beyond);

    return dict;
}


void write(Ostream& os, const char* where, const faceQualityCounts& faces)
{
    std::ostringstream text;
    text<< std::fixed << std::setprecision(1)
        << "Faces " << where << ": non-orthogonality mean "
        << faces.meanNonOrtho() << ", max " << faces.maxNonOrtho
        << std::setprecision(2) << "; skewness max " << faces.maxSkewness
        << std::defaultfloat << std::setprecision(2)
        << "; weight min " << faces.minWeight
        << "; volume ratio min " << faces.minVolRatio << '\n';

    if (faces.nBeyondAny)
    {
        const char* separator = "    beyond bounds: ";
        for (label k = 0; k < faceQualityCounts::nBounds; ++k)
        {
            if (faces.nBeyond[k])
            {
                text<< separator << faces.nBeyond[k] << ' '
                    << faceQualityCounts::names[k];
                separator = ", ";
            }
            if (k == 0 && faces.nOfWall)
            {
                text<< " (" << faces.nOfWall << " because of the wall's faces)";
            }
        }

        const point& x = faces.firstPlace;
        text<< std::setprecision(6) << "; first at (" << x.x() << ' ' << x.y()
            << ' ' << x.z() << ")\n";
    }

    os  << text.str().c_str();
}


// * * * * * * * * * * * * * * *  Patch Report * * * * * * * * * * * * * * * //

template<class Type>
static MinMax<Type> ofAll(const MinMax<Type>& range, const columnTeam& team)
{
    return MinMax<Type>
    (
        team.reduce(range.min(), minOp<Type>()),
        team.reduce(range.max(), maxOp<Type>())
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void wallSample::addPoints(const labelUList& faces, patchReport& patch) const
{
    bitSet points;
    for (const label facei : faces)
    {
        const face& f = wall.faces[facei];
        points.set(f);

        // Between patches, the thinner one's count
        patch.layersAsked =
            max(patch.layersAsked, min(labelList(spacing.layersAsked, f)));
    }

    for (const label p : points)
    {
        if (team.isOwn(p))
        {
            patch.request.firstThickness.add(spacing.firstThickness[p]);
            patch.request.ratio.add(spacing.ratio[p]);
            patch.request.thickness.add(spacing.thickness[p]);
            ++patch.points[int(causes[p])];
        }
    }

    layerRequest& request = patch.request;
    request.firstThickness = ofAll(request.firstThickness, team);
    request.ratio = ofAll(request.ratio, team);
    request.thickness = ofAll(request.thickness, team);
    patch.layersAsked = team.reduce(patch.layersAsked, maxOp<label>());
    for (label& n : patch.points)
    {
        n = team.sum(n);
    }
}


void wallSample::addFaces(const labelUList& counted, patchReport& patch) const
{
    const scalarField areas(heights.areas, counted);
    const scalarField first(heights.firstOverRequest, counted);
    const scalarField total(heights.totalOverRequest, counted);
    const scalarField jacobians(certificate.worstJacobian, counted);
    patch.nFaces = team.sum(counted.size());
    patch.area = team.sum(sum(areas));
    const scalar worst = team.reduce(min(jacobians), minOp<scalar>());
    const scalar sumJacobians = team.sum(sum(jacobians));
    const auto areaPercent = [&](const std::function<bool(label)>& counts)
    {
        scalar share = 0;
        forAll(counted, i)
        {
            share += counts(i) ? areas[i] : 0;
        }

        return 100*team.sum(share)/max(patch.area, VSMALL);
    };
    patch.fullThicknessArea =
        areaPercent([&](const label i) { return total[i] >= 0.99; });
    patch.firstHeightArea =
        areaPercent([&](const label i) { return mag(first[i] - 1) <= 0.01; });
    patch.thicknessArea =
        areaPercent([&](const label i) { return mag(total[i] - 1) <= 0.05; });
    patch.vanishingArea = areaPercent([&](const label i)
    {
        return heights.leastGrowth(counted[i]) < patchReport::vanishing;
    });
    patch.firstHeightMedian = weightedMedian(first, areas, team);
    patch.thicknessMedian = weightedMedian(total, areas, team);

    if (patch.nFaces)
    {
        // Layers are on every face
        patch.layersReached = layers.nLayers;
        patch.fullLayersArea = 100;
        patch.worstJacobian = worst;
        patch.meanJacobian = sumJacobians/patch.nFaces;
    }
}


patchReport wallSample::report(const word& name, const labelUList& faces) const
{
    patchReport patch;
    patch.name = name;
    const labelList counted
    (
        subsetList
        (
            faces,
            [&](const label facei) { return team.countsFace(facei); }
        )
    );
    addFaces(counted, patch);

    const label n = spacing.nLayers - 1;
    scalarField growth(n*counted.size());
    #pragma omp parallel for schedule(static)
    forAll(counted, i)
    {
        SubList<scalar>(growth, n, i*n) =
            SubList<scalar>(heights.growthOverRequest, n, counted[i]*n);
    }
    patch.firstHeight =
        makePercentiles(scalarField(heights.firstOverRequest, counted), team);
    patch.totalThickness =
        makePercentiles(scalarField(heights.totalOverRequest, counted), team);
    patch.growth = makePercentiles(growth, team);
    addPoints(faces, patch);

    return patch;
}

} // End namespace Foam

// ************************************************************************* //
