/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "offsetEnvelope.H"
#include "limitGradient.H"
#include "sparsePoints.H"
#include "wallClearance.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Mean length of the edges at each point
static scalarField edgeLengths
(
    const wallSurface& wall,
    const wallAddressing& addressing
)
{
    scalarField lengths(wall.points.size(), 0);

    forAll(lengths, p)
    {
        for (const label q : addressing.pointPoints[p])
        {
            lengths[p] += mag(wall.points[q] - wall.points[p]);
        }
        lengths[p] /= addressing.pointPoints[p].size();
    }

    return lengths;
}


//- Vector along the axis of a cone so long that all faces are one unit away
static vector offsetVector(const visibilityCone& cone)
{
    return min(1/max(cone.cosine, SMALL), clearanceControls::maxStretch)
       *cone.axis;
}


namespace
{

//- Points of a sheet before they are thinned
struct sheet
{
    const wallSurface& wall;
    const wallSearch& search;
    const wallVisibility& visibility;

    //- Radius of the envelope [m] that is wanted at each point of the wall
    const scalarField& wanted;

    //- Height of the sheet over the radius of the envelope
    scalar share;

    //- Distance of points over the height of the sheet, in general and where
    //  the opposite wall limits the radius
    scalar density;
    scalar slitDensity;

    DynamicList<point> points;
    DynamicList<scalar> spacings;
    DynamicList<scalar> gaps;

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


    //- Above point p of the wall, along an offset for the unit height, where
    //  the envelope has a radius
    void add(const label p, const vector& offset, const scalar radius)
    {
        const scalar height = share*radius;
        const point x = wall.points[p] + height*offset;

        if (!search.nearer(x, sheetControls::ownShare*height))
        {
            points.append(x);
            spacings.append
            (
                height*(limited(p, radius) ? slitDensity : density)
            );
            gaps.append(radius);
        }
    }


    //- From the normal n of a face to the axis of the cone, as far as there is
    //  room: more than along the normal only where a slit ends
    void addArc(const label p, const vector& n, const scalar radius)
    {
        const vector& axis = visibility.cones[p].axis;
        const scalar room = roomAlong(search, wall.points[p], n, radius);

        // At the foot of another wall
        if (room < sheetControls::leastRoom*radius)
        {
            return;
        }

        add(p, n, room);

        for
        (
            scalar s = sheetControls::arcStep;
            s < 1 - SMALL && limited(p, room);
            s += sheetControls::arcStep
        )
        {
            const vector d(normalised((1 - s)*n + s*axis));
            add(p, d, roomAlong(search, wall.points[p], d, radius));
        }
    }


    //- Above a point of the wall; on the way around a sharp convex edge or
    //  corner also along the normals of the faces
    void addPoint(const label p, const scalar radius)
    {
        const visibilityCone& cone = visibility.cones[p];
        add(p, offsetVector(cone), radius);

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


    //- Beside a point on edges that are long for the height: columns stand
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

            if (mag(along) > sheetControls::longEdge*share*radius)
            {
                const visibilityCone cone = makeVisibilityCone
                (
                    vectorField({normals[i], normals[normals.rcIndex(i)]})
                );

                add(p, normalised(along) + offsetVector(cone), radius);
            }
        }
    }
};

} // End anonymous namespace


static void append(const sheet& s, offsetEnvelope& envelope)
{
    const labelList kept
    (
        sparsePoints(pointField(s.points), scalarField(s.spacings))
    );

    envelope.points.append(pointField(UIndirectList<point>(s.points, kept)));
    envelope.gaps.append(scalarField(UIndirectList<scalar>(s.gaps, kept)));
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

offsetEnvelope makeOffsetEnvelope
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallSearch& search,
    const wallVisibility& visibility,
    const scalarField& radius,
    const scalarField& wanted,
    const backgroundMeshControls& mesh
)
{
    const scalarField lengths(edgeLengths(wall, addressing));
    const scalarField leastRadius(sheetControls::leastResolved*lengths);

    offsetEnvelope envelope;
    envelope.radius = radius;
    limitGradient(wall, addressing, sheetControls::maxSlope, envelope.radius);

    const auto sheetAt = [&](const scalar share)
    {
        const scalar d = mesh.radiusEdgeRatio;
        const scalar inSlits =
            share < 1 ? d : min(d, sheetControls::slitSpacing);

        return sheet
        {
            wall, search, visibility, wanted, share, d, inSlits, {}, {}, {}
        };
    };

    sheet outer(sheetAt(1));
    forAll(wall.points, p)
    {
        const labelList& neighbours = addressing.pointPoints[p];
        const scalar r = envelope.radius[p];

        if (r > leastRadius[p] || !outer.isBesideTip(neighbours, p, radius))
        {
            outer.addPoint(p, r);
            outer.addLongEdges(neighbours, p, r);
        }
    }
    append(outer, envelope);
    envelope.nEnvelope = envelope.points.size();

    const scalar longest = max(envelope.radius/lengths);
    scalar share = 0.5;

    for
    (
        label k = 0;
        k < mesh.minSheets || share*longest >= 1;
        ++k, share *= 0.5
    )
    {
        sheet inner(sheetAt(share));
        forAll(wall.points, p)
        {
            // The lowest sheet is as far from the wall as its edges are long
            const scalar r = envelope.radius[p];

            if (k < mesh.minSheets || share*r >= lengths[p])
            {
                inner.addPoint(p, r);
            }
        }
        append(inner, envelope);
    }

    return envelope;
}

} // End namespace Foam

// ************************************************************************* //
