/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "pointKind.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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
    bool convex = false;
    bool concave = false;

    forAll(normals, i)
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

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::List<Foam::pointKind> Foam::kindsOfPoints
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


Foam::FixedList<Foam::label, Foam::nPointKinds> Foam::countKinds
(
    const List<pointKind>& kinds
)
{
    FixedList<label, nPointKinds> counts(Zero);

    for (const pointKind kind : kinds)
    {
        ++counts[int(kind)];
    }

    return counts;
}


// ************************************************************************* //
