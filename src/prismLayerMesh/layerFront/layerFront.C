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

} // End namespace Foam

// ************************************************************************* //
