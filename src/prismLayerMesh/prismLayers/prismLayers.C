/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismLayers.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelList prismLayers::columnsOf(const labelUList& stacks) const
{
    DynamicList<label> columns(4*stacks.size());
    for (const label facei : stacks)
    {
        columns.append(faces[facei]);
    }
    inplaceUniqueSort(columns);

    return labelList(std::move(columns));
}


label prismLayers::root(const label c) const
{
    const label further = c - nWallPoints();

    return further < 0 ? c : extraColumnPoints[further];
}


label prismLayers::pointLabel(const label c, const label i) const
{
    const label further = extraColumnPoints.size() ? c - nWallPoints() : -1;

    return
        further < 0 ? index(c, i)
      : i ? index(c, i) - (further + 1)
      : index(extraColumnPoints[further], 0);
}


pointField prismLayers::meshPoints() const
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


pointField prismLayers::outerPoints() const
{
    pointField outer(nColumns());
    forAll(outer, c)
    {
        outer[c] = (*this)(c, nLayers);
    }

    return outer;
}

} // End namespace Foam

// ************************************************************************* //
