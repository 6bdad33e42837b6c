/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshCell.H"
#include "cellPredicates.H"
#include "tetSigns.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

meshCell::meshCell(const polyhedralMesh& mesh, const boolList& onWall)
:
    mesh_(mesh),
    onWall_(onWall)
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


bool meshCell::closes(const faceCorner* c, const label n)
{
    for (label i = 0; i < n; ++i)
    {
        label nBeside = 0;

        for (label j = 0; j < n; ++j)
        {
            nBeside += c[j].prev == c[i].next;
        }

        if (nBeside != 1)
        {
            return false;
        }
    }

    return n > 1;
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


void meshCell::collectCorners()
{
    corners_.clear();
    points_.clear();

    for (label i = 0; i < nFaces(); ++i)
    {
        const label n = nPoints(i);

        for (label k = 0; k < n; ++k)
        {
            corners_.append
            (
                faceCorner
                {
                    corner(i, k), corner(i, k + 1), corner(i, k + n - 1)
                }
            );
        }
    }

    std::sort
    (
        corners_.begin(), corners_.end(),
        [](const faceCorner& a, const faceCorner& b) { return a.at < b.at; }
    );

    for (const faceCorner& c : corners_)
    {
        points_.append(&mesh_.points()[c.at]);
    }
}


bool meshCell::isPositiveAt
(
    const tetSigns& positive,
    const faceCorner* c,
    const label n
) const
{
    if (!closes(c, n))
    {
        return false;
    }
    if (n > 3)
    {
        return true;
    }

    const pointField& x = mesh_.points();
    const label third = c[1].prev == c->next ? c[1].next : c[2].next;

    return positive(x[c->at], x[c->prev], x[c->next], x[third]);
}


meshCellVerdict meshCell::cornersVerdict()
{
    collectCorners();

    if (points_.empty())
    {
        return {meshCellShape::other, false};
    }

    const tetSigns positive(points_.begin(), points_.size());
    bool valid = true;
    bool simple = true;
    label nPoints = 0;

    for (label i = 0, n = 0; i < corners_.size(); i += n, ++nPoints)
    {
        const faceCorner* c = &corners_[i];

        for (n = 1; i + n < corners_.size() && c[n].at == c->at; ++n)
        {}

        simple = simple && n == 3;
        valid = valid && isPositiveAt(positive, c, n);
    }

    const auto is = [&](const label nFacesOfShape, const label nPointsOfShape)
    {
        return simple && nFaces() == nFacesOfShape && nPoints == nPointsOfShape;
    };

    return
    {
        is(4, 4) && nTriangles_ == 4 ? meshCellShape::tetrahedron
      : is(6, 8) && nQuads_ == 6 ? meshCellShape::hexahedron
      : meshCellShape::other,
        valid
    };
}


meshCellVerdict meshCell::operator()(const label celli)
{
    set(celli);

    label p[6];
    const bool isPrism = asPrism(p);

    if (!isPrism && !asWedge(p))
    {
        return cornersVerdict();
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
