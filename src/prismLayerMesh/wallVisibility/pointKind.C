/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pointKind.H"
#include "ListOps.H"
#include "UIndirectList.H"

#include <cmath>

namespace Foam
{

static pointKind kindOfPoint
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const label p
)
{
    if (visibility.cones[p].empty())
    {
        return pointKind::empty;
    }

    const vectorField& normals = visibility.cornerNormals[p];

    if (normals.size() < addressing.pointPoints[p].size())
    {
        return pointKind::flat;
    }

    bool convex = false;
    bool concave = false;

    forAll(addressing.pointPoints[p], i)
    {
        const vector& before = normals[normals.rcIndex(i)];

        if ((before & normals[i]) < visibilityControls::sharpCosine)
        {
            const vector edge =
                wall.points[addressing.pointPoints[p][i]] - wall.points[p];
            const bool ridge = ((before ^ normals[i]) & edge) < 0;

            (ridge ? convex : concave) = true;
        }
    }

    return convex && concave ? pointKind::saddle
      : convex ? pointKind::convex
      : concave ? pointKind::concave
      : pointKind::flat;
}


List<pointKind> kindsOfPoints
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility
)
{
    List<pointKind> kinds(wall.points.size());
    forAll(kinds, p)
    {
        kinds[p] = kindOfPoint(wall, addressing, visibility, p);
    }

    return kinds;
}


FixedList<label, nPointKinds> countKinds(const List<pointKind>& kinds)
{
    FixedList<label, nPointKinds> counts(Zero);

    for (const pointKind kind : kinds)
    {
        ++counts[int(kind)];
    }

    return counts;
}


// * * * * * * * * * * * * * *  Inward Curvature * * * * * * * * * * * * * * //

//- The number of passes that smooth the normal of each point over its length,
//  0 for a point that has no flat neighbour or is on a sharp edge
static labelList passesOfSmoothing
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const List<pointKind>& kinds,
    const scalarField& thickness
)
{
    labelList nPasses(kinds.size(), 0);

    #pragma omp parallel for schedule(static, 256)
    forAll(kinds, p)
    {
        scalar sum = 0;
        label nFlat = 0;
        for (const label q : addressing.pointPoints[p])
        {
            const bool isFlat = kinds[q] == pointKind::flat;
            sum += isFlat ? magSqr(wall.points[q] - wall.points[p]) : 0;
            nFlat += isFlat;
        }
        if (kinds[p] == pointKind::flat && nFlat)
        {
            // A pass adds a quarter of the mean square of the edges to the
            // variance in each direction
            const scalar length =
                curvatureControls::smoothingLength*thickness[p];
            nPasses[p] = label
            (
                max
                (
                    scalar(curvatureControls::leastPasses),
                    min
                    (
                        scalar(curvatureControls::maxPasses),
                        std::ceil(4*sqr(length)*nFlat/max(sum, VSMALL))
                    )
                )
            );
        }
    }

    return nPasses;
}


//- Normals of points, smoothed between points that are on no sharp edge: a
//  crease between coarse triangles that were divided is no curve
static vectorField smoothedNormals
(
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const List<pointKind>& kinds,
    const labelList& nPasses
)
{
    vectorField normals(visibility.meanNormals);
    labelList active(identity(normals.size()));

    for (label pass = 0; active.size(); ++pass)
    {
        inplaceSubsetList
        (
            active, [&](const label p) { return nPasses[p] > pass; }
        );
        vectorField changed(active.size());

        #pragma omp parallel for schedule(static, 256)
        forAll(active, i)
        {
            vector sum(Zero);
            label nFlat = 0;
            for (const label q : addressing.pointPoints[active[i]])
            {
                const bool isFlat = kinds[q] == pointKind::flat;
                sum += isFlat ? normals[q] : vector(Zero);
                nFlat += isFlat;
            }
            changed[i] = 0.5*(normals[active[i]] + sum/nFlat);
        }
        UIndirectList<vector>(normals, active) = changed;
    }

    return normals;
}


scalarField inwardCurvature
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const List<pointKind>& kinds,
    const scalarField& thickness
)
{
    const vectorField normals
    (
        smoothedNormals
        (
            addressing, visibility, kinds,
            passesOfSmoothing(wall, addressing, kinds, thickness)
        )
    );
    scalarField curvature(wall.points.size(), 0);

    #pragma omp parallel for schedule(static, 256)
    forAll(curvature, p)
    {
        if (kinds[p] != pointKind::flat)
        {
            continue;
        }
        for (const label q : addressing.pointPoints[p])
        {
            const vector d(wall.points[q] - wall.points[p]);
            const scalar turn = (normals[q] - normals[p]) & d;

            if (kinds[q] == pointKind::flat)
            {
                curvature[p] = max(curvature[p], -turn/magSqr(d));
            }
        }
    }

    return curvature;
}

} // End namespace Foam

// ************************************************************************* //
