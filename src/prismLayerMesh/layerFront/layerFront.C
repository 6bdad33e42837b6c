/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "layerFront.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::layerFront::smallest(const scalarField& values) const
{
    scalarField result(wallPoints.size() - extraColumnPoints().size(), GREAT);

    forAll(values, c)
    {
        scalar& s = result[wallPoints[c]];
        s = min(s, values[c]);
    }

    return result;
}


Foam::labelList Foam::layerFront::extraColumnPoints() const
{
    // Each first column stands on the point of its own label
    label nFirst = 0;
    while (nFirst < wallPoints.size() && wallPoints[nFirst] == nFirst)
    {
        ++nFirst;
    }

    return SubList<label>(wallPoints, wallPoints.size() - nFirst, nFirst);
}


// ************************************************************************* //
