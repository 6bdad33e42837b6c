/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshCell.H"
#include "cellPredicates.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

meshCell::meshCell(const polyhedralMesh& mesh, const boolList& onWall)
:
    mesh_(mesh),
    onWall_(onWall),
    corners_(mesh.points())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void meshCell::set(const label celli)
{
    labels_.clear();
    starts_.clear();
    nTriangles_ = nQuads_ = 0;

    for (const label facei : mesh_.cellFaces(celli))
    {
        const face& f = mesh_.faces()[facei];
        const label n = f.size();
        const bool outwards = mesh_.owner(facei) == celli;

        starts_.append(labels_.size());
        nTriangles_ += n == 3;
        nQuads_ += n == 4;

        for (label k = 0; k < n; ++k)
        {
            labels_.append(f[outwards ? k : n - 1 - k]);
        }
    }

    starts_.append(labels_.size());
}


bool meshCell::lies(const label* p) const
{
    bool onSide = false;
    label n = 0;

    for (label k = 0; k < 3; ++k)
    {
        n += onWall_[p[k]] + onWall_[p[k + 3]];
        onSide = onSide || (onWall_[p[k]] && onWall_[p[k + 3]]);
    }

    return onSide && n == 2;
}


meshCellVerdict meshCell::operator()(const label celli)
{
    set(celli);

    label p[6];
    const bool isPrism = asPrism(p);

    if (!isPrism && !asWedge(p))
    {
        return cornersVerdict(celli);
    }

    const point* points[6];

    for (label k = 0; k < 6; ++k)
    {
        points[k] = &mesh_.points()[p[k]];
    }

    if (!isPrism)
    {
        return {meshCellShape::wedge, isPositiveCollapsedPrism(points)};
    }

    return lies(p)
      ? meshCellVerdict{meshCellShape::lyingPrism, isPositiveLyingPrism(points)}
      : meshCellVerdict{meshCellShape::prism, isPositivePrism(points)};
}

} // End namespace Foam

// ************************************************************************* //
