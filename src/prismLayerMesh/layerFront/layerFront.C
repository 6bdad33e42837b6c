/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerFront.H"

namespace Foam
{

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


void layerFront::setConstraints()
{
    constraints.clear();
    if (addressing.pointSides.empty())
    {
        return;
    }

    constraints.setSize(wallPoints.size());
    forAll(constraints, c)
    {
        const point& x = surface.points[c];
        const labelList sides(addressing.sidesOf(c));
        const vectorField& lines = visibility.sideLines;

        if (lines.size() && mag(lines[c]) > 0)
        {
            constraints[c] = columnConstraint::onLine(x, lines[c]);
        }
        else if (sides.size())
        {
            const sidePatch& side = surface.border.sides[sides[0]];
            constraints[c] =
                columnConstraint::inPlane(side.origin, side.normal);
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
