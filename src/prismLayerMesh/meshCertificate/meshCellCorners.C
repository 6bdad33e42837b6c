/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshCell.H"
#include "cell.H"
#include "ranges.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

label meshCell::sideOf(const label i, const boundBox& bounds) const
{
    for (label side = 0; side < 6; ++side)
    {
        const scalar at = (side % 2 ? bounds.max() : bounds.min())[side/2];
        label n = 0;
        for (label k = 0; k < nPoints(i); ++k)
        {
            n += mesh_.points()[corner(i, k)][side/2] == at;
        }

        if (n == nPoints(i))
        {
            return side;
        }
    }

    return -1;
}


bool meshCell::asBox(const label celli, bool& positive) const
{
    const boundBox bounds(corners_.bounds());
    const vector span(bounds.span());
    scalar area = 0;
    positive = cmptMin(span) > 0;

    for (label i = 0; i < nFaces(); ++i)
    {
        const label side = sideOf(i, bounds);
        if (side < 0)
        {
            return false;
        }
        const label facei = mesh_.cellFaces(celli)[i];
        const scalar outwards =
            (side % 2 ? 1 : -1)*mesh_.outwardArea(facei, celli)[side/2];
        positive = positive && outwards > 0;
        area += outwards;
    }

    // A closed surface covers the box a whole number of times
    const scalar once = 2
       *(span.x()*span.y() + span.y()*span.z() + span.z()*span.x());
    positive = positive && area < 1.5*once;

    return true;
}


bool meshCell::hasPositivePyramids(const label celli) const
{
    const cell faces(mesh_.cellFaces(celli));
    const point centre(faces.centre(mesh_.points(), mesh_.faces()));

    return allOf(faces, [&](const label facei)
    {
        return mesh_.pyramidVolume(facei, celli, centre) > 0;
    });
}


bool meshCell::isPositivePolyhedron(const label celli)
{
    set(celli);
    corners_.set(labels_, starts_);

    return corners_.facts().closed && hasPositivePyramids(celli);
}


meshCellVerdict meshCell::cornersVerdict(const label celli)
{
    corners_.set(labels_, starts_);
    const cellCorners::factsOfAll corners(corners_.facts());
    if (!corners.closed)
    {
        return {meshCellShape::other, false};
    }

    // Only a cell with more points, or points within its edges, may be refined
    bool positiveBox = false;
    if (!corners.positive && (corners.within || corners.nPoints > 8))
    {
        return asBox(celli, positiveBox)
          ? meshCellVerdict{meshCellShape::box, positiveBox}
          : meshCellVerdict
            {
                meshCellShape::polyhedron, hasPositivePyramids(celli)
            };
    }

    const auto is = [&](const label nFacesOfShape, const label nPointsOfShape)
    {
        return corners.simple && nFaces() == nFacesOfShape
         && corners.nPoints == nPointsOfShape;
    };

    return
    {
        is(4, 4) && nTriangles_ == 4 ? meshCellShape::tetrahedron
      : is(6, 8) && nQuads_ == 6 ? meshCellShape::hexahedron
      : meshCellShape::other,
        corners.positive
    };
}

} // End namespace Foam

// ************************************************************************* //
