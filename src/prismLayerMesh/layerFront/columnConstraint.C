/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnConstraint.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

columnConstraint columnConstraint::inPlane
(
    const point& origin,
    const vector& normal
)
{
    return columnConstraint(kind::inPlane, origin, normal);
}


columnConstraint columnConstraint::onLine
(
    const point& origin,
    const vector& direction
)
{
    return columnConstraint(kind::onLine, origin, direction);
}


columnConstraint columnConstraint::onSurface
(
    const vector& normal,
    const nearestPoint& nearest
)
{
    return columnConstraint(kind::inPlane, Zero, normal, nearest);
}


columnConstraint columnConstraint::onCurve
(
    const vector& tangent,
    const nearestPoint& nearest
)
{
    return columnConstraint(kind::onLine, Zero, tangent, nearest);
}


columnConstraint columnConstraint::fixed()
{
    return columnConstraint(kind::fixed, Zero, Zero);
}


vector columnConstraint::allowed(const vector& direction) const
{
    const vector along = (direction & direction_)*direction_;

    return kind_ == kind::inPlane ? direction - along
      : kind_ == kind::onLine ? along
      : direction;
}


point columnConstraint::allowedPoint(const point& x) const
{
    if (nearest_)
    {
        return nearest_(x);
    }

    const vector along = ((x - origin_) & direction_)*direction_;

    return kind_ == kind::inPlane ? x - along
      : kind_ == kind::onLine ? origin_ + along
      : x;
}

} // End namespace Foam

// ************************************************************************* //
