/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "columnConstraint.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::columnConstraint Foam::columnConstraint::inPlane
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


Foam::columnConstraint Foam::columnConstraint::onSurface
(
    const nearestPoint& nearest
)
{
    columnConstraint constraint;
    constraint.kind_ = kind::onSurface;
    constraint.nearest_ = nearest;

    return constraint;
}


Foam::columnConstraint Foam::columnConstraint::fixed()
{
    columnConstraint constraint;
    constraint.kind_ = kind::fixed;

    return constraint;
}


Foam::vector Foam::columnConstraint::allowed(const vector& direction) const
{
    return kind_ == kind::inPlane
      ? direction - (direction & normal_)*normal_
      : direction;
}


Foam::point Foam::columnConstraint::allowedPoint(const point& x) const
{
    return kind_ == kind::inPlane ? x - ((x - origin_) & normal_)*normal_
      : kind_ == kind::onSurface ? nearest_(x)
      : x;
}


// ************************************************************************* //
