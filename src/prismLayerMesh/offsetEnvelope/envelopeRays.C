/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "envelopeRays.H"
#include "offsetEnvelope.H"
#include "wallClearance.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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

} // End namespace Foam

// ************************************************************************* //
