/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "meshCell.H"
#include "cellPredicates.H"
#include "tetSigns.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::meshCell::meshCell(const polyhedralMesh& mesh, const boolList& onWall)
:
    mesh_(mesh),
    onWall_(onWall)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::meshCell::set(const label celli)
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


bool Foam::meshCell::closes(const faceCorner* c, const label n)
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


Foam::meshCellVerdict Foam::meshCell::prismVerdict(const label* p) const
{
    const point* points[6];
    label nOnWall = 0;

    for (label k = 0; k < 6; ++k)
    {
        points[k] = &mesh_.points()[p[k]];
        nOnWall += onWall_[p[k]];
    }

    bool lies = false;

    for (label k = 0; k < 3; ++k)
    {
        lies = lies || (nOnWall == 2 && onWall_[p[k]] && onWall_[p[k + 3]]);
    }

    if (lies)
    {
        return {meshCellShape::lyingPrism, isPositiveLyingPrism(points)};
    }

    return {meshCellShape::prism, isPositivePrism(points)};
}


Foam::meshCellVerdict Foam::meshCell::cornersVerdict()
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

    if (points_.empty())
    {
        return {meshCellShape::other, false};
    }

    const tetSigns positive(points_.begin(), points_.size());
    const auto at = [this](const label p) -> const point&
    {
        return mesh_.points()[p];
    };

    bool valid = true;
    bool simple = true;
    label nPoints = 0;

    for (label i = 0, n = 0; i < corners_.size(); i += n, ++nPoints)
    {
        const faceCorner* c = &corners_[i];

        for (n = 1; i + n < corners_.size() && c[n].at == c->at; ++n)
        {}

        simple = simple && n == 3;
        valid = valid && closes(c, n);

        if (valid && n == 3)
        {
            const label third = c[1].prev == c->next ? c[1].next : c[2].next;

            valid =
                positive(at(c->at), at(c->prev), at(c->next), at(third));
        }
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


Foam::meshCellVerdict Foam::meshCell::operator()(const label celli)
{
    set(celli);

    label p[6];

    if (asPrism(p))
    {
        return prismVerdict(p);
    }

    if (asWedge(p))
    {
        const point* points[6];

        for (label k = 0; k < 6; ++k)
        {
            points[k] = &mesh_.points()[p[k]];
        }

        return {meshCellShape::wedge, isPositiveCollapsedPrism(points)};
    }

    return cornersVerdict();
}


// ************************************************************************* //
