/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planePoints.H"
#include "farFieldMeshControls.H"
#include "sparsePoints.H"
#include "DynamicField.H"
#include "HashSet.H"
#include "linePointRef.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The points of the edges of a region
static pointField verticesOf
(
    const pointField& points,
    const planeRegion& region
)
{
    labelHashSet vertices;
    for (const UList<edge>* edges : {&region.boundary, &region.fence})
    {
        for (const edge& e : *edges)
        {
            vertices.insert(e);
        }
    }

    return pointField(points, vertices.sortedToc());
}


namespace
{

class planeSquares
{
    const sidePatch& side_;
    const std::function<scalar(const point&)>& size_;
    vector e1_;
    vector e2_;

    DynamicField<point> centres_;
    DynamicField<scalar> sizes_;

    point at(const scalar a, const scalar b) const
    {
        const point x(side_.origin + a*e1_ + b*e2_);
        return x - side_.distance(x)*side_.normal;
    }

    void divide(const scalar a, const scalar b, const scalar width)
    {
        const point x(at(a, b));
        const scalar size = size_(x);

        if (width <= farFieldTuned.squareShare*size)
        {
            centres_.append(x);
            sizes_.append(size);
            return;
        }

        const scalar quarter = width/4;
        divide(a - quarter, b - quarter, width/2);
        divide(a + quarter, b - quarter, width/2);
        divide(a - quarter, b + quarter, width/2);
        divide(a + quarter, b + quarter, width/2);
    }

public:

    planeSquares
    (
        const pointField& vertices,
        const sidePatch& side,
        const std::function<scalar(const point&)>& size
    )
    :
        side_(side),
        size_(size)
    {
        // Some direction that is not along the normal
        vector other(Zero);
        other[findMin(cmptMag(side.normal))] = 1;
        e1_ = normalised(other ^ side.normal);
        e2_ = side.normal ^ e1_;

        const vectorField d(vertices - side.origin);
        const scalarField a(d & e1_), b(d & e2_);
        divide
        (
            0.5*(min(a) + max(a)), 0.5*(min(b) + max(b)),
            1.001*max(max(a) - min(a), max(b) - min(b))
        );
    }

    const DynamicField<point>& centres() const { return centres_; }
    const DynamicField<scalar>& sizes() const { return sizes_; }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

pointField planePoints
(
    const pointField& points,
    const planeRegion& region,
    const sidePatch& side,
    const std::function<scalar(const point&)>& size
)
{
    const pointField vertices(verticesOf(points, region));
    const planeSquares squares(vertices, side, size);

    DynamicField<point> all(vertices);
    DynamicField<scalar> distances;
    for (const point& x : vertices)
    {
        distances.append(farFieldTuned.apartShare*size(x));
    }

    forAll(squares.centres(), i)
    {
        const point& x = squares.centres()[i];
        const bool nearFence = std::any_of
        (
            region.fence.begin(), region.fence.end(), [&](const edge& e)
            {
                return e.line(points).nearestDist(x).distance()
                    < farFieldTuned.fenceShare*squares.sizes()[i];
            }
        );

        if (!nearFence)
        {
            all.append(x);
            distances.append(farFieldTuned.apartShare*squares.sizes()[i]);
        }
    }

    const labelList kept(sparsePoints(all, distances));
    DynamicField<point> result(kept.size());
    for (const label p : kept)
    {
        if (p >= vertices.size())
        {
            result.append(point(all[p]));
        }
    }

    return pointField(std::move(result));
}

} // End namespace Foam

// ************************************************************************* //
