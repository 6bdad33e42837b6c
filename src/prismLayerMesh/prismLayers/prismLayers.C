/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "prismLayers.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::prismLayers::root(const label c) const
{
    const label further = c - nWallPoints();

    return further < 0 ? c : extraColumnPoints[further];
}


Foam::label Foam::prismLayers::pointLabel(const label c, const label i) const
{
    const label further = extraColumnPoints.size() ? c - nWallPoints() : -1;

    return
        further < 0 ? index(c, i)
      : i ? index(c, i) - (further + 1)
      : index(extraColumnPoints[further], 0);
}


Foam::pointField Foam::prismLayers::meshPoints() const
{
    pointField result(points);

    for (label c = nWallPoints(); c < nColumns(); ++c)
    {
        for (label i = 1; i <= nLayers; ++i)
        {
            result[pointLabel(c, i)] = (*this)(c, i);
        }
    }
    result.setSize(points.size() - extraColumnPoints.size());

    return result;
}


Foam::pointField Foam::prismLayers::outerPoints() const
{
    pointField outer(nColumns());
    forAll(outer, c)
    {
        outer[c] = (*this)(c, nLayers);
    }

    return outer;
}


// ************************************************************************* //
