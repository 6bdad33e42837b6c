/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceMeasures.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

surfaceMeasures measuresOf(const wallSurface& surface)
{
    surfaceMeasures result;

    for (const face& f : surface.faces)
    {
        const scalar angle =
            radToDeg(smallestAngleOf(f.points(surface.points)));
        result.area += f.mag(surface.points);
        result.smallestAngle = min(result.smallestAngle, angle);

        if (angle < surfaceMeasures::smallAngle)
        {
            result.shareWithSmallAngles += 1.0/surface.faces.size();
        }
    }

    return result;
}

} // End namespace Foam

// ************************************************************************* //
