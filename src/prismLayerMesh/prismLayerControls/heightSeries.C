/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heightSeries.H"

#include <sstream>

namespace Foam
{

//- log((exp(n x) - 1)/(exp(x) - 1)), the logarithm of 1 + alpha + ... +
//  alpha^(n-1) for alpha = exp(x), and its derivative
static scalar logGeometricSum(const label n, const scalar x, scalar& slope)
{
    const scalar small = 1e-5;

    if (mag(n*x) < small)
    {
        // First terms of the series
        slope = 0.5*(n - 1) + x*(sqr(scalar(n)) - 1)/12;

        return Foam::log(scalar(n)) + 0.5*(n - 1)*x;
    }

    // In terms of exp(-|x|), which does not overflow
    const scalar a = -mag(x);
    slope = n/(1 - Foam::exp(-n*x)) - 1/(1 - Foam::exp(-x));

    return
        Foam::log(std::expm1(n*a)/std::expm1(a))
      + (x > 0 ? (n - 1)*x : 0);
}


scalar totalThickness
(
    const label n,
    const scalar firstThickness,
    const scalar ratio
)
{
    // log1p keeps the digits of ratios near 1
    const scalar x = std::log1p(ratio - 1);

    return firstThickness*(x == 0 ? n : std::expm1(n*x)/std::expm1(x));
}


scalar fittedRatio
(
    const label n,
    const scalar firstThickness,
    const scalar thickness
)
{
    // In logarithms the sum is almost linear in x = log(alpha), and Newton's
    // steps converge from anywhere; the bounds are there against rounding.
    // alpha^(n-1) <= sum, and below 1, sum < 1/(1 - alpha).
    const scalar target = Foam::log(thickness/firstThickness);
    scalar low = std::log1p(-firstThickness/thickness);
    scalar high = target/(n - 1);
    scalar x = 2*(target - Foam::log(scalar(n)))/(n - 1);

    for (label i = 0; i < 200 && high - low > 1e-16; ++i)
    {
        if (x <= low || x >= high)
        {
            x = 0.5*(low + high);
        }

        scalar slope = 0;
        const scalar error = logGeometricSum(n, x, slope) - target;
        (error > 0 ? high : low) = x;

        const scalar step = error/slope;
        x -= step;

        if (mag(step) < 1e-15*(1 + mag(x)))
        {
            break;
        }
    }

    return Foam::exp(x);
}


void layerHeights
(
    const label n,
    const scalar firstThickness,
    const scalar ratio,
    const scalar room,
    UList<scalar>& heights
)
{
    const scalar asked = totalThickness(n, firstThickness, ratio);
    scalar h = firstThickness;
    scalar alpha = ratio;

    if (room < asked)
    {
        if (room <= n*firstThickness)
        {
            alpha = min(ratio, scalar(1));
            h = firstThickness*room/totalThickness(n, firstThickness, alpha);
        }
        else
        {
            alpha = fittedRatio(n, firstThickness, room);
        }
    }

    heights[0] = 0;
    for (label i = 1; i <= n; ++i)
    {
        heights[i] = heights[i - 1] + h;
        h *= alpha;
    }

    // Exact in spite of rounding
    heights[n] = min(room, asked);
}


// * * * * * * * * * * * * * * *  Height Series  * * * * * * * * * * * * * * //

template<class... Items>
[[noreturn]] static void fail(const word& key, const Items&... items)
{
    std::ostringstream message;
    (void)std::initializer_list<int>{((message << items), 0)...};

    throw heightEntriesError(key, message.str());
}


//- Out of heights of one layer
static scalar oneHeight(const heightEntries& given)
{
    scalar low = VGREAT, high = 0;

    for
    (
        const scalar h
      : {
            given.firstLayerThickness,
            given.finalLayerThickness,
            given.thickness
        }
    )
    {
        low = h > 0 ? min(low, h) : low;
        high = max(high, h);
    }

    if (high - low > 1e-9*high)
    {
        fail
        (
            "", "One layer has one thickness, but ", givenKeys(given),
            " differ: ", low, " and ", high
        );
    }

    return high;
}


//- alpha of layers from a height, or counted from the other end, to thickness
static scalar ratioToThickness
(
    const heightEntries& given,
    const label n,
    const scalar height,
    const scalar thickness
)
{
    if (thickness <= height*(1 + 1e-9))
    {
        fail
        (
            "thickness", "Value of thickness is ", thickness, "; with ",
            givenKeys(given), " and ", n, " layers it must be more than ",
            height
        );
    }

    return fittedRatio(n, height, thickness);
}


//- h1 and alpha of n > 1 layers. Heights that are given are in metres.
static void solve(const heightEntries& given, heightSeries& heights)
{
    const label n = heights.n;
    const scalar first = given.firstLayerThickness;
    const scalar final = given.finalLayerThickness;
    const scalar total = given.thickness;
    scalar& h1 = heights.firstLayerThickness;
    scalar& alpha = heights.expansionRatio;

    // Beyond this heights are not numbers
    if (n*mag(::log(alpha)) > 600)
    {
        fail
        (
            "expansionRatio", "Value of expansionRatio is ", alpha, "; with ",
            n, " layers heights are out of all bounds"
        );
    }

    if (first > 0)
    {
        h1 = first;
        alpha =
            final > 0 ? ::pow(final/first, 1.0/(n - 1))
          : total > 0 ? ratioToThickness(given, n, first, total)
          : alpha;
    }
    else if (final > 0)
    {
        // Counted from the last layer the ratio is 1/alpha
        alpha = total > 0 ? 1/ratioToThickness(given, n, final, total) : alpha;
        h1 = final/::pow(alpha, n - 1);
    }
    else if (total > 0)
    {
        h1 = total/totalThickness(n, 1, alpha);
    }
}


static void checkDetermined
(
    const heightEntries& given,
    const word& what,
    const scalar value,
    const scalar min,
    const scalar max
)
{
    // Given bounds themselves pass in spite of rounding
    const scalar slack = 1e-9;

    if (!(value >= min*(1 - slack) && value <= max*(1 + slack)))
    {
        fail
        (
            "", "The ", what, " determined by ", givenKeys(given), " is ",
            value, "; it must be from ", min, " to ", max
        );
    }
}


static void checkDetermined
(
    const heightEntries& given,
    const heightSeries& heights
)
{
    const scalar h1 = heights.firstLayerThickness;
    const scalar alpha = heights.expansionRatio;
    const scalar low = heightSeries::minThickness;
    const scalar high = heightSeries::maxThickness;

    checkDetermined
    (
        given, "expansionRatio", alpha,
        heightSeries::minRatio, heightSeries::maxRatio
    );
    checkDetermined(given, "firstLayerThickness", h1, low, high);
    checkDetermined
    (
        given, "thickness", totalThickness(heights.n, h1, alpha), low, high
    );
}


std::string givenKeys(const heightEntries& given)
{
    std::string keys;

    const auto add = [&](const bool isGiven, const char* key)
    {
        if (isGiven)
        {
            keys += (keys.empty() ? "" : ", ") + std::string(key);
        }
    };

    add(given.yPlus > 0, "yPlus");
    add(given.firstLayerThickness > 0 && !(given.yPlus > 0),
        "firstLayerThickness");
    add(given.finalLayerThickness > 0, "finalLayerThickness");
    add(given.thickness > 0, "thickness");
    add(given.expansionRatio > 0, "expansionRatio");

    return keys.empty() ? "none" : keys;
}


heightSeries changedHeights
(
    const heightSeries& before,
    const heightEntries& given,
    const scalar unit
)
{
    heightSeries heights(before);
    heightEntries entries(given);

    if (given.nSurfaceLayers)
    {
        heights.n = given.nSurfaceLayers;
    }
    if (given.expansionRatio > 0)
    {
        heights.expansionRatio = given.expansionRatio;
    }
    if (given.relativeSizes)
    {
        entries.firstLayerThickness *= unit;
        entries.finalLayerThickness *= unit;
        entries.thickness *= unit;
    }

    const label nGiven =
        (given.firstLayerThickness > 0) + (given.finalLayerThickness > 0)
      + (given.thickness > 0);

    if (nGiven + (given.expansionRatio > 0) > 2)
    {
        fail
        (
            "", "The layers are determined twice, by ", givenKeys(given),
            "\nTwo of these are enough; yPlus is firstLayerThickness"
        );
    }

    if (!nGiven)
    {
        entries.firstLayerThickness = before.firstLayerThickness;
    }

    if (heights.n == 1)
    {
        heights.firstLayerThickness = oneHeight(entries);
    }
    else
    {
        solve(entries, heights);
    }

    checkDetermined(given, heights);

    return heights;
}

} // End namespace Foam

// ************************************************************************* //
