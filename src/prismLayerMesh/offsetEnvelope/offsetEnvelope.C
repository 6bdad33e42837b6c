/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "offsetEnvelope.H"
#include "limitGradient.H"
#include "ListOps.H"
#include "pointOrder.H"
#include "sparsePoints.H"
#include "stageProgress.H"
#include "wallClearance.H"

#include <algorithm>

namespace Foam
{

//- Vector along the axis of a cone so long that all faces are one unit away, at
//  most maxStretch
static vector offsetVector(const visibilityCone& cone, const scalar maxStretch)
{
    return min(1/max(cone.cosine, SMALL), maxStretch)*cone.axis;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void envelopeRays::addArc(const label p, const vector& n, const scalar radius)
{
    const vector& axis = visibility_.cones[p].axis;
    const point& x = wall_.points[p];
    const scalar room = roomAlong(search_, x, n, radius);

    // At the foot of another wall
    if (room < sheetControls::leastRoom*radius)
    {
        return;
    }

    rays_.append(envelopeRay{p, n, room});

    for
    (
        scalar s = sheetControls::arcStep;
        s < 1 - SMALL && isLimited(p, room);
        s += sheetControls::arcStep
    )
    {
        const vector d(normalised((1 - s)*n + s*axis));
        rays_.append(envelopeRay{p, d, roomAlong(search_, x, d, radius)});
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

envelopeRays::envelopeRays
(
    const wallContext& context,
    const scalarField& wanted,
    const scalar maxStretch
)
:
    wall_(context.wall),
    addressing_(context.addressing),
    search_(context.search()),
    visibility_(context.visibility),
    wanted_(wanted),
    maxStretch_(maxStretch)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool envelopeRays::isLimited(const label p, const scalar radius) const
{
    return radius < sheetControls::limitedShare*wanted_[p];
}


bool envelopeRays::isBesideTip(const label p, const scalarField& radius) const
{
    for (const label q : addressing_.pointPoints[p])
    {
        const vector qp = wall_.points[p] - wall_.points[q];

        if
        (
            isLimited(p, radius[p])
         && !isLimited(q, radius[q])
         && (visibility_.cones[q].axis & qp)
          > sheetControls::tipCosine*mag(qp)
        )
        {
            return true;
        }
    }

    return false;
}


void envelopeRays::addPoint(const label p, const scalar radius)
{
    const visibilityCone& cone = visibility_.cones[p];
    rays_.append(envelopeRay{p, offsetVector(cone, maxStretch_), radius});

    const scalar apart = sheetControls::apartCosine;
    DynamicList<vector> others;
    for (const vector& n : visibility_.cornerNormals[p])
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


void envelopeRays::addLongEdges(const label p, const scalar radius)
{
    const labelList& neighbours = addressing_.pointPoints[p];
    const vectorField& normals = visibility_.cornerNormals[p];

    forAll(neighbours, i)
    {
        const vector along = wall_.points[neighbours[i]] - wall_.points[p];

        if (mag(along) > sheetControls::longEdge*radius)
        {
            const visibilityCone cone = makeVisibilityCone
            (
                vectorField({normals[i], normals[normals.rcIndex(i)]})
            );

            const vector offset
            (
                normalised(along) + offsetVector(cone, maxStretch_)
            );
            rays_.append(envelopeRay{p, offset, radius, true});
        }
    }
}


// * * * * * * * * * * * * * *  Offset Envelope  * * * * * * * * * * * * * * //

//- Returns points of the wall in the order in which their sheet points are
//  chosen: first points on concave edges, then points on no edge, then the
//  others, each in a sweep by place. A point on a concave edge would lose its
//  sheet points to its neighbours; a point on a convex edge has several.
static labelList sweepOrder
(
    const wallSurface& wall,
    const List<pointKind>& kinds,
    const labelUList& wallPoints
)
{
    const auto rank = [&](const label p)
    {
        return isOnConcaveEdge(kinds[p]) ? 0
          : kinds[p] == pointKind::flat ? 1 : 2;
    };
    labelList order(wallPoints);

    std::sort(order.begin(), order.end(), [&](const label p, const label q)
    {
        return rank(p) != rank(q)
          ? rank(p) < rank(q) : isBefore(wall.points[p], wall.points[q]);
    });

    return order;
}


namespace
{

//- Makes sheets of the points on rays
struct sheetMaker
{
    const wallSurface& wall;
    const wallSearch& search;
    const envelopeRays& rays;

    //- Factor on the distance between the points of each point of the wall
    const scalarField& closeness;

    //- Labels of the points of the wall in the part of the wall
    const labelList& inPart;


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
        pointField points(rays.all().size());
        List<labelPair> sides(rays.all().size());
        boolList stands(rays.all().size(), false);
        progressCounter counter("points of a sheet", rays.all().size());

        #pragma omp parallel for schedule(dynamic, 256)
        forAll(rays.all(), i)
        {
            const envelopeRay& r = rays.all()[i];
            const point& root = wall.points[r.p];
            const scalar height = share*r.radius;
            points[i] = root + height*r.offset;
            stands[i] = onSheet(r)
             && search.sides().putOnSides
                (
                    root, sheetControls::sideShare*height, points[i], sides[i]
                )
             && !search.nearer(points[i], sheetControls::ownShare*height);
            counter.countOne();
        }
        inplaceSubset(stands, points);
        inplaceSubset(stands, sides);

        scalarField spacings(points.size()), gaps(points.size());
        labelList roots(points.size());
        label k = 0;
        forAll(rays.all(), i)
        {
            const envelopeRay& r = rays.all()[i];
            if (stands[i])
            {
                const scalar d = rays.isLimited(r.p, r.radius) ? inSlits : wide;
                spacings[k] = share*r.radius*d*closeness[r.p];
                roots[k] = inPart[r.p];
                gaps[k++] = r.radius;
            }
        }

        const labelList kept(sparsePoints(points, spacings));
        envelope.points.append(pointField(points, kept));
        envelope.gaps.append(scalarField(gaps, kept));
        envelope.roots.append(labelList(UIndirectList<label>(roots, kept)));

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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

envelopeRadii envelopeRadii::at(const labelUList& points) const
{
    return envelopeRadii
    {
        scalarField(wanted, points), scalarField(room, points),
        scalarField(radius, points), scalarField(edgeLengths, points)
    };
}


envelopeRadii makeEnvelopeRadii
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const scalarField& wanted,
    const scalarField& clearance,
    const columnTeam& team
)
{
    envelopeRadii radii;
    radii.wanted = wanted;
    radii.room = min(wanted, clearance);
    radii.radius = radii.room;
    do
    {
        limitGradient(wall, addressing, sheetControls::maxSlope, radii.radius);
    }
    while (team.points.lower(radii.radius));
    radii.edgeLengths = meanEdges(wall, addressing);
    team.points.update(radii.edgeLengths);

    return radii;
}


offsetEnvelope makeOffsetEnvelope
(
    const wallContext& context,
    const envelopeRadii& radii,
    const labelUList& wallPoints,
    const backgroundMeshControls& mesh,
    const scalar maxStretch
)
{
    const wallSurface& wall = context.wall;
    const scalarField& lengths = radii.edgeLengths;
    const scalarField closeness
    (
        closenessOf(context.kinds, radii.radius, lengths)
    );
    envelopeRays rays(context, radii.wanted, maxStretch);
    boolList atTip(wall.points.size());
    scalar longest = 0;
    for (const label p : sweepOrder(wall, context.kinds, wallPoints))
    {
        const scalar r = radii.radius[p];

        longest = max(longest, r/lengths[p]);
        atTip[p] = r <= sheetControls::leastResolved*lengths[p]
            && rays.isBesideTip(p, radii.room);
        rays.addPoint(p, r);
        rays.addLongEdges(p, r);
    }

    offsetEnvelope envelope;
    envelope.radius = scalarField(radii.radius, wallPoints);
    const labelList inPart(invert(wall.points.size(), wallPoints));
    const sheetMaker maker{wall, context.search(), rays, closeness, inPart};
    const auto onOuter = [&](const envelopeRay& r) { return !atTip[r.p]; };
    maker.addSheet(1, mesh.radiusEdgeRatio, onOuter, envelope);
    envelope.nEnvelope = envelope.points.size();

    scalar share = 0.5;
    for (label k = 0; k < mesh.minSheets || share*longest >= 1; ++k)
    {
        // The lowest sheet is as far from the wall as its edges are long
        const auto onInner = [&](const envelopeRay& r)
        {
            return !r.outerOnly
             && (k < mesh.minSheets
              || share*radii.radius[r.p] >= lengths[r.p]);
        };
        maker.addSheet(share, mesh.radiusEdgeRatio, onInner, envelope);
        share *= 0.5;
    }

    return envelope;
}

} // End namespace Foam

// ************************************************************************* //
