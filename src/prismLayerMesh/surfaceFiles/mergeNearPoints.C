/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "mergeNearPoints.H"
#include "bitSet.H"
#include "boundBox.H"
#include "ListOps.H"
#include "wallSides.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- For each point its representative: a point within the tolerance, or the
//  point itself. The representative of points at one place is the first.
static labelList findRepresentatives
(
    const pointField& points,
    const scalar tolerance
)
{
    // In the order of their places along a direction that no plane of a
    // surface is likely to be normal to, near points are near
    const vector direction(0.48712, 0.60539, 0.62962);
    const scalarField place(points & direction);
    const scalar reach = 1.01*mag(direction)*tolerance;

    const labelList order(sortedOrder(place));
    labelList representatives(points.size(), -1);

    forAll(order, i)
    {
        const label p = order[i];

        if (representatives[p] >= 0)
        {
            continue;
        }

        representatives[p] = p;

        for
        (
            label j = i + 1;
            j < order.size() && place[order[j]] - place[p] <= reach;
            ++j
        )
        {
            const label q = order[j];

            if
            (
                representatives[q] < 0
             && magSqr(points[q] - points[p]) <= sqr(tolerance)
            )
            {
                representatives[q] = p;
            }
        }
    }

    return representatives;
}


//- Remove faces with neighbouring corners that have become one point. Returns
//  the number of faces removed.
static label removeCollapsedFaces(wallSurface& wall)
{
    bitSet kept(wall.faces.size());

    forAll(wall.faces, i)
    {
        kept.set(i, !hasRepeatedPoint(wall.faces[i]));
    }

    inplaceSubset(kept, wall.faces);
    inplaceSubset(kept, wall.patchIDs);

    return kept.size() - wall.faces.size();
}


//- Number of points that have another one as representative
static label nRepresented(const labelUList& representatives)
{
    label n = 0;
    forAll(representatives, p)
    {
        n += representatives[p] != p;
    }

    return n;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void mergeNearPoints
(
    wallSurface& wall,
    const scalar tolerance,
    wallReading& reading
)
{
    const scalar diagonal = boundBox(wall.points, false).mag();
    const auto within = [&](const scalar share)
    {
        return findRepresentatives(wall.points, share*diagonal);
    };
    const labelList representatives(within(tolerance));
    const label nNear = nRepresented(within(wallReading::nearTolerance));

    reading.mergedPoints = nRepresented(representatives);
    reading.nearPoints = max(nNear - reading.mergedPoints, label(0));

    for (face& f : wall.faces)
    {
        inplaceRenumber(representatives, f);
    }

    reading.collapsedFaces = removeCollapsedFaces(wall);
}

} // End namespace Foam

// ************************************************************************* //
