/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "snappyCase.H"
#include "boxSides.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool snappyCase::hasBaffles() const
{
    return walls.baffles().size();
}


bool snappyCase::isCrossed() const
{
    const boundBox bounds(walls.surface.points, false);

    return
        box.isBox && walls.surface.points.size()
     && !widened(box.bounds, 1e-4*bounds.mag()).contains(bounds);
}


scalar snappyCase::widthAt(const label level) const
{
    return rounded(box.width/pow(2.0, level));
}


scalar rounded(const scalar x)
{
    const scalar unit = pow(10.0, floor(log10(mag(x) + VSMALL)) - 3);

    return std::round(x/unit)*unit;
}


void addFilled(dictionary& dict, const word& key, const dictionary& sub)
{
    if (sub.size())
    {
        dict.add(key, sub);
    }
}

} // End namespace Foam

// ************************************************************************* //
