/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerFront.H"
#include "sideCurve.H"
#include "sideShape.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Returns the constraint of a column at x on a side patch
static columnConstraint onSide(const sidePatch& side, const point& x)
{
    if (!side.isCurved())
    {
        return columnConstraint::inPlane(side.origin, side.normal);
    }

    const std::shared_ptr<const sideShape> shape(side.shape);

    const vector normal(side.planeAt(x).normal);

    // What is beside each other in the tangent plane remains so
    return columnConstraint::onSurface
    (
        normal,
        [=](const point& y) { return shape->along(y, normal, mag(y - x)); }
    );
}


//- Returns the constraint of a column at x on two side patches.
//  tangent: unit tangent of the common line of both
static columnConstraint onBothSides
(
    const sidePatch& first,
    const sidePatch& second,
    const point& x,
    const vector& tangent
)
{
    if (!first.isCurved() && !second.isCurved())
    {
        return columnConstraint::onLine(x, tangent);
    }

    const sideCurve curve(first, second, x);

    return columnConstraint::onCurve
    (
        tangent, [curve](const point& y) { return curve.nearest(y); }
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalarField layerFront::smallest(const scalarField& values) const
{
    scalarField result(wallPoints.size() - extraColumnPoints().size(), GREAT);

    forAll(values, c)
    {
        scalar& s = result[wallPoints[c]];
        s = min(s, values[c]);
    }

    return result;
}


labelList layerFront::extraColumnPoints() const
{
    // Each first column stands on the point of its own label
    label nFirst = 0;
    while (nFirst < wallPoints.size() && wallPoints[nFirst] == nFirst)
    {
        ++nFirst;
    }

    return SubList<label>(wallPoints, wallPoints.size() - nFirst, nFirst);
}


void layerFront::complete
(
    wallAddressing ofWall,
    wallVisibility seenFromWall
)
{
    if (isBare())
    {
        addressing = std::move(ofWall);
        visibility = std::move(seenFromWall);
    }
}


void layerFront::setConstraints
(
    const wallAddressing& around,
    const vectorField& sideLines
)
{
    constraints.clear();
    if (around.pointSides.empty())
    {
        return;
    }

    const List<sidePatch>& sides = surface.border.sides;

    constraints.setSize(wallPoints.size());
    forAll(constraints, c)
    {
        const point& x = surface.points[c];
        const labelList own(around.sidesOf(c));

        if (sideLines.size() && mag(sideLines[c]) > 0)
        {
            constraints[c] = onBothSides
            (
                sides[own[0]], sides[own[1]], x, sideLines[c]
            );
        }
        else if (own.size())
        {
            constraints[c] = onSide(sides[own[0]], x);
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
