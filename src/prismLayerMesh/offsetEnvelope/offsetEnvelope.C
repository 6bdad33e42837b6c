/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "offsetEnvelope.H"
#include "limitGradient.H"
#include "pointOrder.H"
#include "sparsePoints.H"
#include "wallClearance.H"
#include "ListOps.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Vector along the axis of a cone so long that all faces are one unit away, at
//  most maxStretch
static vector offsetVector(const visibilityCone& cone, const scalar maxStretch)
{
    return min(1/max(cone.cosine, SMALL), maxStretch)*cone.axis;
}


//- Returns the points of the wall in the order in which their sheet points are
//  chosen: first points on concave edges, then points on no edge, then the
//  others, each in a sweep by place. A point on a concave edge would lose its
//  sheet points to its neighbours; a point on a convex edge has several.
static labelList sweepOrder
(
    const wallSurface& wall,
    const List<pointKind>& kinds
)
{
    const auto rank = [&](const label p)
    {
        return isOnConcaveEdge(kinds[p]) ? 0
          : kinds[p] == pointKind::flat ? 1 : 2;
    };
    labelList order(identity(wall.points.size()));

    std::sort(order.begin(), order.end(), [&](const label p, const label q)
    {
        return rank(p) != rank(q)
          ? rank(p) < rank(q) : isBefore(wall.points[p], wall.points[q]);
    });

    return order;
}


namespace
{

//- A line from point p of the wall on which sheets have points
struct ray
{
    label p;

    //- From p to the unit height
    vector offset;

    //- Radius of the envelope along the line [m]
    scalar radius;

    //- Whether only the envelope has a point on the line
    bool outerOnly = false;
};


//- Makes the rays, and sheets of their points
struct sheetMaker
{
    const wallSurface& wall;
    const wallSearch& search;
    const wallVisibility& visibility;

    //- Radius of the envelope [m] that is wanted at each point of the wall
    const scalarField& wanted;

    //- Factor on the distance between the points of each point of the wall
    const scalarField& closeness;

    //- Length of rays over their height
    const scalar maxStretch;

    DynamicList<ray> rays;

    bool limited(const label p, const scalar radius) const
    {
        return radius < sheetControls::limitedShare*wanted[p];
    }


    //- Whether the opposite wall begins to limit the radius at p, beside a
    //  concave edge
    bool isBesideTip
    (
        const labelUList& neighbours,
        const label p,
        const scalarField& radius
    ) const
    {
        for (const label q : neighbours)
        {
            const vector qp = wall.points[p] - wall.points[q];

            if
            (
                limited(p, radius[p])
             && !limited(q, radius[q])
             && (visibility.cones[q].axis & qp)
              > sheetControls::tipCosine*mag(qp)
            )
            {
                return true;
            }
        }

        return false;
    }


    //- From the normal n of a face to the axis of the cone, as far as there is
    //  room: more than along the normal only where a slit ends
    void addArc(const label p, const vector& n, const scalar radius)
    {
        const vector& axis = visibility.cones[p].axis;
        const point& x = wall.points[p];
        const scalar room = roomAlong(search, x, n, radius);

        // At the foot of another wall
        if (room < sheetControls::leastRoom*radius)
        {
            return;
        }

        rays.append(ray{p, n, room});

        for
        (
            scalar s = sheetControls::arcStep;
            s < 1 - SMALL && limited(p, room);
            s += sheetControls::arcStep
        )
        {
            const vector d(normalised((1 - s)*n + s*axis));
            rays.append(ray{p, d, roomAlong(search, x, d, radius)});
        }
    }


    //- Along the axis at a point; on the way around a sharp convex edge or
    //  corner also along the normals of the faces
    void addPoint(const label p, const scalar radius)
    {
        const visibilityCone& cone = visibility.cones[p];
        rays.append(ray{p, offsetVector(cone, maxStretch), radius});

        const scalar apart = sheetControls::apartCosine;
        DynamicList<vector> others;
        for (const vector& n : visibility.cornerNormals[p])
        {
            bool far = (n & cone.axis) < apart;

            for (const vector& other : others)
            {
                far = far && (n & other) < apart;
            }

            if (far)
            {
                others.append(n);
                addArc(p, n, radius);
            }
        }
    }


    //- Beside a point on edges that are long for the radius: columns stand
    //  only on points, so that further along nothing depends on the field
    void addLongEdges
    (
        const labelUList& neighbours,
        const label p,
        const scalar radius
    )
    {
        const vectorField& normals = visibility.cornerNormals[p];

        forAll(neighbours, i)
        {
            const vector along = wall.points[neighbours[i]] - wall.points[p];

            if (mag(along) > sheetControls::longEdge*radius)
            {
                const visibilityCone cone = makeVisibilityCone
                (
                    vectorField({normals[i], normals[normals.rcIndex(i)]})
                );

                const vector offset
                (
                    normalised(along) + offsetVector(cone, maxStretch)
                );
                rays.append(ray{p, offset, radius, true});
            }
        }
    }


    //- Adds the points at a share of their radius on rays for which onSheet
    //  holds. Points are about 'wide' times their height apart.
    template<class OnSheet>
    void addSheet
    (
        const scalar share,
        const scalar wide,
        const OnSheet& onSheet,
        offsetEnvelope& envelope
    ) const
    {
        const scalar inSlits =
            share < 1 ? wide : min(wide, sheetControls::slitSpacing);
        pointField points(rays.size());
        List<labelPair> sides(rays.size());
        boolList stands(rays.size(), false);

        #pragma omp parallel for schedule(dynamic, 256)
        forAll(rays, i)
        {
            const ray& r = rays[i];
            const point& root = wall.points[r.p];
            const scalar height = share*r.radius;
            points[i] = root + height*r.offset;
            stands[i] = onSheet(r)
             && search.sides().putOnSides
                (
                    root, sheetControls::sideShare*height, points[i], sides[i]
                )
             && !search.nearer(points[i], sheetControls::ownShare*height);
        }
        inplaceSubset(stands, points);
        inplaceSubset(stands, sides);

        scalarField spacings(points.size()), gaps(points.size());
        label k = 0;
        forAll(rays, i)
        {
            const ray& r = rays[i];
            if (stands[i])
            {
                const scalar d = limited(r.p, r.radius) ? inSlits : wide;
                spacings[k] = share*r.radius*d*closeness[r.p];
                gaps[k++] = r.radius;
            }
        }

        const labelList kept(sparsePoints(points, spacings));
        envelope.points.append(pointField(points, kept));
        envelope.gaps.append(scalarField(gaps, kept));

        if (wall.border.sides.size())
        {
            envelope.sides.append(UIndirectList<labelPair>(sides, kept));
        }
    }
};

} // End anonymous namespace


//- The distance of points on sheets over what is wanted elsewhere. In acute
//  edges whose radius the wall does not resolve, points that are near to the
//  edge would squeeze the level sets
static scalarField closenessOf
(
    const List<pointKind>& kinds,
    const scalarField& radius,
    const scalarField& lengths
)
{
    scalarField closeness(kinds.size(), 1);

    forAll(closeness, p)
    {
        if (isOnConcaveEdge(kinds[p]) && radius[p] > lengths[p])
        {
            closeness[p] = sheetControls::concaveSpacing;
        }
    }

    return closeness;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

offsetEnvelope makeOffsetEnvelope
(
    const wallContext& context,
    const scalarField& radius,
    const scalarField& wanted,
    const backgroundMeshControls& mesh,
    const scalar maxStretch
)
{
    const wallSurface& wall = context.wall;
    const wallAddressing& addressing = context.addressing;
    const scalarField lengths(meanEdges(wall, addressing));

    offsetEnvelope envelope;
    envelope.radius = radius;
    limitGradient(wall, addressing, sheetControls::maxSlope, envelope.radius);

    const scalarField closeness
    (
        closenessOf(context.kinds, envelope.radius, lengths)
    );
    sheetMaker maker
    {
        wall, context.search, context.visibility, wanted, closeness, maxStretch,
        {}
    };
    boolList atTip(wall.points.size());
    for (const label p : sweepOrder(wall, context.kinds))
    {
        const labelList& neighbours = addressing.pointPoints[p];
        const scalar r = envelope.radius[p];

        atTip[p] = r <= sheetControls::leastResolved*lengths[p]
            && maker.isBesideTip(neighbours, p, radius);
        maker.addPoint(p, r);
        maker.addLongEdges(neighbours, p, r);
    }
    const auto onOuter = [&](const ray& r) { return !atTip[r.p]; };
    maker.addSheet(1, mesh.radiusEdgeRatio, onOuter, envelope);
    envelope.nEnvelope = envelope.points.size();

    const scalar longest = max(envelope.radius/lengths);
    scalar share = 0.5;
    for (label k = 0; k < mesh.minSheets || share*longest >= 1; ++k)
    {
        // The lowest sheet is as far from the wall as its edges are long
        const auto onInner = [&](const ray& r)
        {
            return !r.outerOnly
             && (k < mesh.minSheets
              || share*envelope.radius[r.p] >= lengths[r.p]);
        };
        maker.addSheet(share, mesh.radiusEdgeRatio, onInner, envelope);
        share *= 0.5;
    }

    return envelope;
}

} // End namespace Foam

// ************************************************************************* //
