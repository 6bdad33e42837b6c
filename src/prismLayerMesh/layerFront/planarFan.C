/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planarFan.H"
#include "mathematicalConstants.H"
#include "quaternion.H"
#include "unitConversion.H"

namespace Foam
{

label pointAcross
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const label p
)
{
    const labelList own(addressing.sidesOf(p));
    const bool isPlanar =
        own.size() == 1 && wall.border.sides[own[0]].type == "empty"
     && addressing.pointPoints[p].size() == 3;

    return isPlanar ? addressing.pointPoints[p][1] : -1;
}


//- The angle by which a wall turns at a point [rad], positive where it is
//  convex
static scalar turnAt
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const label p
)
{
    const vectorField& normals = visibility.cornerNormals[p];
    const vector toLast
    (
        wall.points[addressing.pointPoints[p][2]] - wall.points[p]
    );
    const scalar angle =
        ::atan2(mag(normals[0] ^ normals[1]), normals[0] & normals[1]);

    return (normals[0] & toLast) < 0 ? angle : -angle;
}


normalSectors makePlanarFan
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const label p
)
{
    // Rounding must not divide both ends differently
    const label lower = min(p, pointAcross(wall, addressing, p));
    const scalar turn = turnAt(wall, addressing, visibility, lower);
    const scalar fanAngle = degToRad(frontControls::fanAngle);
    normalSectors fan;
    if (turn < fanAngle)
    {
        return fan;
    }

    const label n = ::ceil(turn/fanAngle);
    const scalar step = turn/n;
    const vector& first = visibility.cornerNormals[p][0];
    const labelList& around = addressing.pointPoints[p];
    vector axis(normalised(wall.points[around[1]] - wall.points[p]));
    if (((axis ^ first) & (wall.points[around[0]] - wall.points[p])) > 0)
    {
        axis = -axis;
    }
    const auto turned = [&](const scalar angle)
    {
        return quaternion(axis, angle).transform(first);
    };
    fan.starts = labelList(n + 1, 1);
    fan.starts[0] = 0;
    fan.axes.setSize(n + 1);
    fan.planes.setSize(n + 1);
    for (label s = 0; s <= n; ++s)
    {
        // A direction sees both planes within half of a step
        const scalar toPlane = constant::mathematical::piByTwo - step/2;
        fan.axes[s] = turned(s*step);
        fan.planes[s] = vectorField
        ({
            turned(s*step - toPlane), turned(s*step + toPlane)
        });
    }

    return fan;
}

} // End namespace Foam

// ************************************************************************* //
