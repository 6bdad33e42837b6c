/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/


#include "stackHeights.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Returns three times the volume of the pyramid on a quadrilateral. Computes
//  it with vectors from the middle, in half the time of pyramid3().
static scalar quadPyramid3
(
    const point& p0,
    const point& p1,
    const point& p2,
    const point& p3,
    const point& apex
)
{
    const point middle(0.25*(p0 + p1 + p2 + p3));
    const vector r0(p0 - middle);
    const vector r1(p1 - middle);
    const vector r2(p2 - middle);
    const vector r3(p3 - middle);

    const scalar a0 = mag(r0 ^ r1);
    const scalar a1 = mag(r1 ^ r2);
    const scalar a2 = mag(r2 ^ r3);
    const scalar a3 = mag(r3 ^ r0);

    // Each triangle's centre is a third of the sum of its two vectors
    const vector sumAr
    (
        (a3 + a0)*r0 + (a0 + a1)*r1 + (a1 + a2)*r2 + (a2 + a3)*r3
    );
    const vector centre(sumAr/max(3*(a0 + a1 + a2 + a3), VSMALL));
    const vector area(0.5*((p2 - p0)^(p3 - p1)));

    return area & (middle - apex + centre);
}


//- Three times the volume of the cell between two faces
static scalar volume3
(
    const UList<point>& lower,
    const UList<point>& upper,
    const faceGeometry& lowerFace,
    const faceGeometry& upperFace
)
{
    // The sum does not depend on the apex; near by, it does not round much
    const point& apex = lower[0];
    const label n = lower.size();

    scalar sum = upperFace.pyramid3(apex) - lowerFace.pyramid3(apex);

    for (label k = 0; k < n; ++k)
    {
        const label next = k + 1 < n ? k + 1 : 0;

        sum += quadPyramid3
        (
            lower[k], lower[next], upper[next], upper[k],
            apex
        );
    }

    return sum;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

stackHeights::stackHeights(const prismLayers& layers)
:
    layers_(layers),
    heights_(layers.nLayers)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void stackHeights::collect
(
    const label facei,
    const label level,
    DynamicList<point>& points
) const
{
    points.clear();

    for (const label c : layers_.faces[facei])
    {
        points.append(layers_(c, level));
    }
}


void stackHeights::compute(const label facei)
{
    compute(facei, layers_.nLayers);
}


void stackHeights::compute(const label facei, const label nLayers)
{
    collect(facei, 0, lower_);
    faceGeometry lowerFace(lower_);
    wallArea_ = mag(lowerFace.area);

    for (label i = 1; i <= nLayers; ++i)
    {
        collect(facei, i, upper_);
        const faceGeometry upperFace(upper_);

        heights_[i - 1] = layerHeight
        (
            lowerFace, upperFace,
            volume3(lower_, upper_, lowerFace, upperFace)
        );

        lowerFace = upperFace;
        lower_.swap(upper_);
    }
}

} // End namespace Foam

// ************************************************************************* //
