/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/


#include "stackHeights.H"
#include "FixedList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Centre and area vector as in primitiveMesh::makeFaceCentresAndAreas
struct faceGeometry
{
    vector centre;
    vector area;

    template<class PointList>
    explicit faceGeometry(const PointList& points);

    //- Three times the volume of the pyramid on the face
    scalar pyramid3(const point& apex) const
    {
        return area & (centre - apex);
    }
};


template<class PointList>
faceGeometry::faceGeometry(const PointList& points)
{
    const label n = points.size();

    if (n == 3)
    {
        centre = (1.0/3.0)*(points[0] + points[1] + points[2]);
        area = 0.5*((points[1] - points[0])^(points[2] - points[0]));
        return;
    }

    point middle(Zero);
    for (const point& p : points)
    {
        middle += p;
    }
    middle /= n;

    vector sumN(Zero);
    vector sumAc(Zero);
    scalar sumA = 0;

    for (label k = 0; k < n; ++k)
    {
        const point& p = points[k];
        const point& q = points[k + 1 < n ? k + 1 : 0];

        const vector normal((q - p)^(middle - p));
        const scalar a = mag(normal);

        sumN += normal;
        sumA += a;
        sumAc += a*(p + q + middle);
    }

    area = 0.5*sumN;
    centre = sumA > VSMALL ? sumAc/(3*sumA) : middle;
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

    FixedList<point, 4> side;
    for (label k = 0; k < n; ++k)
    {
        const label next = k + 1 < n ? k + 1 : 0;

        side[0] = lower[k];
        side[1] = lower[next];
        side[2] = upper[next];
        side[3] = upper[k];

        sum += faceGeometry(side).pyramid3(apex);
    }

    return sum;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stackHeights::stackHeights(const prismLayers& layers)
:
    layers_(layers),
    heights_(layers.nLayers)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::stackHeights::collect
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


void Foam::stackHeights::compute(const label facei)
{
    collect(facei, 0, lower_);
    faceGeometry lowerFace(lower_);
    wallArea_ = mag(lowerFace.area);

    for (label i = 1; i <= layers_.nLayers; ++i)
    {
        collect(facei, i, upper_);
        const faceGeometry upperFace(upper_);

        heights_[i - 1] =
            2.0/3.0*volume3(lower_, upper_, lowerFace, upperFace)
           /max(mag(lowerFace.area) + mag(upperFace.area), VSMALL);

        lowerFace = upperFace;
        lower_.swap(upper_);
    }
}


// ************************************************************************* //
