/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "geometricHeights.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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

} // End namespace Foam

// ************************************************************************* //
