/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/


#include "stackHeights.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A quadrilateral. Its centre is in the plane through the mean of its points,
//  normal to its area vector: for the volume of a pyramid the mean is as good.
static faceGeometry meanQuad
(
    const point& p0,
    const point& p1,
    const point& p2,
    const point& p3
)
{
    faceGeometry f;
    f.centre = 0.25*(p0 + p1 + p2 + p3);
    f.area = 0.5*((p2 - p0)^(p3 - p1));

    return f;
}


static faceGeometry levelFace(const UList<point>& points)
{
    return points.size() == 4
      ? meanQuad(points[0], points[1], points[2], points[3])
      : faceGeometry(points);
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

        sum += meanQuad(lower[k], lower[next], upper[next], upper[k])
            .pyramid3(apex);
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
    faceGeometry lowerFace(levelFace(lower_));
    wallArea_ = mag(lowerFace.area);

    for (label i = 1; i <= nLayers; ++i)
    {
        collect(facei, i, upper_);
        const faceGeometry upperFace(levelFace(upper_));

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
