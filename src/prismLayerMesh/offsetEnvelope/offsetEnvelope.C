/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "offsetEnvelope.H"
#include "sparsePoints.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A point nearer to the wall than this share of its sheet's height is above
//  another part of the wall, in a concave corner
static const scalar ownShare = 0.7;

//- Bound on the distance from a point of the wall over the height there
static const scalar maxStretch = 2;


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


//- Directions from p to the Minkowski sum: the axis of the visibility cone, so
//  long that all faces at p are one unit away; on the way around a sharp
//  convex edge or corner also the normals of the faces
static DynamicList<vector> offsets(const wallVisibility& visibility, label p)
{
    const visibilityCone& cone = visibility.cones[p];
    const scalar stretch = min(1/max(cone.cosine, SMALL), maxStretch);

    DynamicList<vector> vectors;
    vectors.append(stretch*cone.axis);

    // 0.8: 37 degrees off the axis
    for (const vector& n : visibility.cornerNormals[p])
    {
        bool far = (n & cone.axis) < 0.8;

        for (label i = 1; far && i < vectors.size(); ++i)
        {
            far = (n & vectors[i]) < 0.8;
        }

        if (far)
        {
            vectors.append(n);
        }
    }

    return vectors;
}


//- Points on the sheet at share times the radius, in the order of the wall's
static void addSheet
(
    const wallSurface& wall,
    const wallSearch& search,
    const wallVisibility& visibility,
    const scalarField& lengths,
    const scalar share,
    const scalar density,
    offsetEnvelope& envelope
)
{
    DynamicList<point> points;
    DynamicList<scalar> heights, gaps;

    forAll(wall.points, p)
    {
        const scalar height = share*envelope.radius[p];

        // The finest sheet is about as far from the wall as its edges are long
        if (share < 1 && height < lengths[p])
        {
            continue;
        }

        for (const vector& offset : offsets(visibility, p))
        {
            const point x = wall.points[p] + height*offset;

            if (!search.nearer(x, ownShare*height))
            {
                points.append(x);
                heights.append(height);
                gaps.append(envelope.radius[p]);
            }
        }
    }

    const labelList kept
    (
        sparsePoints(pointField(points), density*scalarField(heights))
    );

    envelope.points.append(pointField(UIndirectList<point>(points, kept)));
    envelope.gaps.append(scalarField(UIndirectList<scalar>(gaps, kept)));
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::offsetEnvelope Foam::makeOffsetEnvelope
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallSearch& search,
    const wallVisibility& visibility,
    const scalarField& clearance,
    const layerSpacing& spacing,
    const envelopeControls& controls,
    const scalar density
)
{
    const scalarField lengths(edgeLengths(wall, addressing));

    offsetEnvelope envelope;
    envelope.radius = min(controls.scale*spacing.thickness, clearance);

    addSheet
    (
        wall, search, visibility, lengths, 1, density, envelope
    );
    envelope.nEnvelope = envelope.points.size();

    for
    (
        scalar share = 0.5;
        max(share*envelope.radius/lengths) >= 1;
        share *= 0.5
    )
    {
        addSheet
        (
            wall, search, visibility, lengths, share, density, envelope
        );
    }

    return envelope;
}


// ************************************************************************* //
