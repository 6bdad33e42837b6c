/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkInFront.H"
#include "ranges.H"
#include "splitAtSidePatches.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void refuseAt(const UList<point>& places, const string& what)
{
    if (places.empty())
    {
        return;
    }

    FatalErrorInFunction
        << what.c_str() << " at " << places.size() << " places:";

    for (label i = 0; i < min(places.size(), label(10)); ++i)
    {
        FatalError << nl << "    " << places[i];
    }

    FatalError << exit(FatalError);
}


void checkInFront
(
    const wallSurface& surface,
    const sidePatch& plane,
    const bitSet& onPlane,
    const scalar tolerance
)
{
    DynamicList<point> beyond, touching;

    forAll(surface.points, p)
    {
        const scalar distance = plane.distance(surface.points[p]);

        if (distance > tolerance)
        {
            beyond.append(surface.points[p]);
        }
        else if (distance > -touchShare*tolerance && !onPlane.test(p))
        {
            touching.append(surface.points[p]);
        }
    }

    for (const face& f : surface.faces)
    {
        const bool isOn =
            allOf(f, [&](const label p) { return onPlane.test(p); });

        if (isOn)
        {
            touching.append(f.centre(surface.points));
        }
    }

    refuseAt
    (
        beyond,
        "The surface is beyond the side plane " + plane.name
      + ", whose normal must point out of the fluid,"
    );
    refuseAt(touching, "The wall touches the side plane " + plane.name);
}

} // End namespace Foam

// ************************************************************************* //
