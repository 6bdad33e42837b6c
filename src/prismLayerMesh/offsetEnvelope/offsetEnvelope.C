/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "offsetEnvelope.H"
#include "sparsePoints.H"

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

    DynamicList<point> points;
    DynamicList<scalar> heights;
    DynamicList<scalar> gaps;

    void add(const point& x, const scalar height, const scalar gap)
    {
        if (!search.nearer(x, sheetControls::ownShare*height))
        {
            points.append(x);
            heights.append(height);
            gaps.append(gap);
        }
    }


    //- Above a point of the wall; on the way around a sharp convex edge or
    //  corner also along the normals of the faces
    void addPoint(const label p, const scalar height, const scalar gap)
    {
        const visibilityCone& cone = visibility.cones[p];
        add(wall.points[p] + height*offsetVector(cone), height, gap);

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
                add(wall.points[p] + height*n, height, gap);
            }
        }
    }


    //- Beside a point on edges that are long for the height: columns stand
    //  only on points, so that further along nothing depends on the field
    void addLongEdges
    (
        const labelUList& neighbours,
        const label p,
        const scalar height
    )
    {
        const vectorField& normals = visibility.cornerNormals[p];

        forAll(neighbours, i)
        {
            const vector along = wall.points[neighbours[i]] - wall.points[p];

            if (mag(along) > sheetControls::longEdge*height)
            {
                const visibilityCone cone = makeVisibilityCone
                (
                    vectorField({normals[i], normals[normals.rcIndex(i)]})
                );

                add
                (
                    wall.points[p]
                  + height*(normalised(along) + offsetVector(cone)),
                    height,
                    height
                );
            }
        }
    }
};

} // End anonymous namespace


static void append
(
    const sheet& s,
    const scalar density,
    offsetEnvelope& envelope
)
{
    const labelList kept
    (
        sparsePoints(pointField(s.points), density*scalarField(s.heights))
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
    const backgroundMeshControls& mesh
)
{
    const scalarField lengths(edgeLengths(wall, addressing));
    const scalar density = mesh.radiusEdgeRatio;

    offsetEnvelope envelope;
    envelope.radius = radius;

    sheet outer{wall, search, visibility, {}, {}, {}};
    forAll(wall.points, p)
    {
        outer.addPoint(p, radius[p], radius[p]);
        outer.addLongEdges(addressing.pointPoints[p], p, radius[p]);
    }
    append(outer, density, envelope);
    envelope.nEnvelope = envelope.points.size();

    const scalar longest = max(radius/lengths);
    scalar share = 0.5;

    for
    (
        label k = 0;
        k < mesh.minSheets || share*longest >= 1;
        ++k, share *= 0.5
    )
    {
        sheet inner{wall, search, visibility, {}, {}, {}};
        forAll(wall.points, p)
        {
            // The lowest sheet is as far from the wall as its edges are long
            if (k < mesh.minSheets || share*radius[p] >= lengths[p])
            {
                inner.addPoint(p, share*radius[p], radius[p]);
            }
        }
        append(inner, density, envelope);
    }

    return envelope;
}

} // End namespace Foam

// ************************************************************************* //
