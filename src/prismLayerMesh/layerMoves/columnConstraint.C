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
    columnConstraint constraint;
    constraint.kind_ = kind::inPlane;
    constraint.origin_ = origin;
    constraint.normal_ = normal;

    return constraint;
}


columnConstraint columnConstraint::onSurface(const nearestPoint& nearest)
{
    columnConstraint constraint;
    constraint.kind_ = kind::onSurface;
    constraint.nearest_ = nearest;

    return constraint;
}


columnConstraint columnConstraint::fixed()
{
    columnConstraint constraint;
    constraint.kind_ = kind::fixed;

    return constraint;
}


vector columnConstraint::allowed(const vector& direction) const
{
    return kind_ == kind::inPlane
      ? direction - (direction & normal_)*normal_
      : direction;
}


point columnConstraint::allowedPoint(const point& x) const
{
    return kind_ == kind::inPlane ? x - ((x - origin_) & normal_)*normal_
      : kind_ == kind::onSurface ? nearest_(x)
      : x;
}

} // End namespace Foam

// ************************************************************************* //
