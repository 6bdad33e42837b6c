/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pointKind.H"

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

//- Normals of points, smoothed between points that are on no sharp edge: a
//  crease between coarse triangles that were divided is no curve
static vectorField smoothedNormals
(
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const List<pointKind>& kinds
)
{
    vectorField normals(visibility.meanNormals);
    for (label pass = 0; pass < curvatureControls::nPasses; ++pass)
    {
        const vectorField old(normals);

        #pragma omp parallel for schedule(static, 256)
        forAll(normals, p)
        {
            vector sum(Zero);
            label nFlat = 0;
            for (const label q : addressing.pointPoints[p])
            {
                const bool isFlat = kinds[q] == pointKind::flat;
                sum += isFlat ? old[q] : vector(Zero);
                nFlat += isFlat;
            }
            normals[p] = nFlat ? 0.5*(old[p] + sum/nFlat) : old[p];
        }
    }

    return normals;
}


scalarField inwardCurvature
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const List<pointKind>& kinds
)
{
    const vectorField normals(smoothedNormals(addressing, visibility, kinds));
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
