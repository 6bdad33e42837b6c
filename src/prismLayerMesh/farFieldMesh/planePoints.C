/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planePoints.H"
#include "boundBox.H"
#include "ranges.H"
#include "sideShape.H"
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
    for (const UList<edge>* edges : {&region.boundary, &region.limits})
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

    //- Longer than a side patch is high above its plane
    const scalar reach_;

    DynamicField<point> centres_;
    DynamicField<scalar> sizes_;

    //- The point of the side patch above one of its plane. False if there is
    //  none.
    bool lift(point& x) const
    {
        const sidePlane& plane = side_;
        x -= plane.distance(x)*plane.normal;

        if (!side_.isCurved())
        {
            return true;
        }

        const vector up(reach_*plane.normal);
        const pointIndexHit hit(side_.shape->hit(x - up, x + up));
        x = hit.hit() ? hit.rawPoint() : x;

        return hit.hit();
    }

    point at(const scalar a, const scalar b) const
    {
        return side_.origin + a*e1_ + b*e2_;
    }

    //- Whether the side patch bends away from its tangent plane at x by more
    //  than a share of the width of a square
    bool isBent
    (
        const point& x,
        const scalar a,
        const scalar b,
        const scalar width
    ) const
    {
        const sidePlane tangent(side_.planeAt(x));

        for (const scalar da : {-0.25, 0.25})
        {
            for (const scalar db : {-0.25, 0.25})
            {
                point y(at(a + da*width, b + db*width));

                if
                (
                    lift(y)
                 && mag(tangent.distance(y)) > farFieldTuned.bentShare*width
                )
                {
                    return true;
                }
            }
        }

        return false;
    }

    void divide(const scalar a, const scalar b, const scalar width)
    {
        point x(at(a, b));
        const bool isOn = lift(x);
        const scalar size = size_(x);

        if
        (
            width <= farFieldTuned.squareShare*size
         && (
                !isOn || !side_.isCurved()
             || width < farFieldTuned.leastBentShare*size
             || !isBent(x, a, b, width)
            )
        )
        {
            if (isOn)
            {
                centres_.append(x);
                sizes_.append
                (
                    side_.isCurved()
                  ? min(size, width/farFieldTuned.squareShare) : size
                );
            }
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
        size_(size),
        reach_(side.isCurved() ? boundBox(side.points, false).mag() : 0)
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
        const bool nearLimit = anyOf(region.limits, [&](const edge& e)
        {
            return e.line(points).nearestDist(x).distance()
                < farFieldTuned.limitShare*squares.sizes()[i];
        });

        if (!nearLimit)
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
