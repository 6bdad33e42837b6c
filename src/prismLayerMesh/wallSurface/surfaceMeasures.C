/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceMeasures.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static scalar smallestAngleOf(const face& f, const pointField& points)
{
    scalar largestCos = -1;

    forAll(f, k)
    {
        const point& x = points[f[k]];
        const vector a(points[f.nextLabel(k)] - x);
        const vector b(points[f.prevLabel(k)] - x);
        const scalar both = Foam::sqrt(magSqr(a)*magSqr(b));
        largestCos = max(largestCos, both > 0 ? (a & b)/both : scalar(1));
    }

    return radToDeg(Foam::acos(min(largestCos, scalar(1))));
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

surfaceMeasures measuresOf(const wallSurface& surface)
{
    surfaceMeasures result;

    for (const face& f : surface.faces)
    {
        const scalar angle = smallestAngleOf(f, surface.points);
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
