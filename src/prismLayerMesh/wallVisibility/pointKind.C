/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pointKind.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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

} // End namespace Foam

// ************************************************************************* //
