/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceMeasures.H"
#include "sidePatch.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

scalar roundingVolume(const boundBox& box, const scalar area)
{
    const scalar largest =
        max(cmptMax(cmptMag(box.min())), cmptMax(cmptMag(box.max())));

    return SMALL*(largest*area + 0.01*pow3(box.mag()));
}


surfaceMeasures measuresOf(const wallSurface& surface)
{
    surfaceMeasures result;
    if (surface.faces.size() && outline(surface.faces).empty())
    {
        result.volume = mag(enclosedVolume(surface));
    }

    result.angles.resize(surface.faces.size());
    forAll(surface.faces, facei)
    {
        const face& f = surface.faces[facei];
        const scalar angle =
            radToDeg(smallestAngleOf(f.points(surface.points)));
        result.area += f.mag(surface.points);
        result.angles[facei] = angle;
        result.smallestAngle = min(result.smallestAngle, angle);

        if (angle < surfaceMeasures::smallAngle)
        {
            result.shareWithSmallAngles += 1.0/surface.faces.size();
        }
    }

    return result;
}


List<patchMeasures> measuresOfPatches(const wallSurface& surface)
{
    List<patchMeasures> result(surface.patchNames.size());

    // Sums of area vectors and of centres times areas
    forAll(surface.faces, facei)
    {
        const faceGeometry f(surface.faces[facei].points(surface.points));
        const scalar area = mag(f.area);
        patchMeasures& patch = result[surface.patchIDs[facei]];
        ++patch.nFaces;
        patch.area += area;
        patch.centre += area*f.centre;
        patch.normal += f.area;
    }

    for (patchMeasures& patch : result)
    {
        if (patch.area <= 0)
        {
            continue;
        }
        patch.centre /= patch.area;
        const scalar sum = mag(patch.normal);
        const bool isPlane =
            sum >= (1 - patchMeasures::planeTolerance)*patch.area;
        patch.normal = isPlane ? patch.normal/sum : Zero;
    }

    return result;
}


scalar wallCosine
(
    const faceGeometry& f,
    const faceGeometry& g,
    const vector& edge
)
{
    const scalar areas = mag(f.area)*mag(g.area);
    if (areas <= VSMALL)
    {
        return GREAT;
    }

    const vector side(edge ^ (f.area/mag(f.area) + g.area/mag(g.area)));
    const vector between(g.centre - f.centre);
    const scalar lengths = mag(side)*mag(between);

    return lengths > VSMALL
      ? min(mag(side & between)/lengths, scalar(1)) : GREAT;
}

} // End namespace Foam

// ************************************************************************* //
