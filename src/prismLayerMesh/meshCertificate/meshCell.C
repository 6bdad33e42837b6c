/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshCell.H"
#include "cell.H"
#include "cellPredicates.H"
#include "layerGeometry.H"
#include "ranges.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool cellCorners::closes(const faceCorner* c, const label n)
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


bool cellCorners::isPositiveAt
(
    const tetSigns& positive,
    const faceCorner* c
) const
{
    const label third = c[1].prev == c->next ? c[1].next : c[2].next;

    return positive(x_[c->at], x_[c->prev], x_[c->next], x_[third]);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void cellCorners::set(const labelUList& labels, const labelUList& starts)
{
    corners_.clear();
    points_.clear();

    for (label i = 0; i + 1 < starts.size(); ++i)
    {
        const label end = starts[i + 1];

        for (label k = starts[i]; k < end; ++k)
        {
            const label next = k + 1 < end ? k + 1 : starts[i];
            const label prev = k > starts[i] ? k - 1 : end - 1;
            corners_.append(faceCorner{labels[k], labels[next], labels[prev]});
        }
    }

    std::sort
    (
        corners_.begin(), corners_.end(),
        [](const faceCorner& a, const faceCorner& b) { return a.at < b.at; }
    );

    for (const faceCorner& c : corners_)
    {
        points_.append(&x_[c.at]);
    }
}


cellCorners::factsOfAll cellCorners::facts() const
{
    factsOfAll all;
    if (corners_.empty())
    {
        all.closed = false;
        return all;
    }
    const tetSigns positive(points_.begin(), points_.size());

    for (label i = 0, n = 0; i < corners_.size(); i += n, ++all.nPoints)
    {
        const faceCorner* c = &corners_[i];
        for (n = 1; i + n < corners_.size() && c[n].at == c->at; ++n)
        {}

        all.closed = all.closed && closes(c, n);
        all.simple = all.simple && n == 3;
        all.within = all.within || n == 2;
        all.positive = all.positive && all.closed && n > 2
         && (n > 3 || isPositiveAt(positive, c));
    }

    return all;
}


boundBox cellCorners::bounds() const
{
    boundBox bounds(boundBox::invertedBox);
    for (const point* p : points_)
    {
        bounds.add(*p);
    }

    return bounds;
}


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
    geometry_.clear();
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
        geometry_.append
        (
            faceGeometry
            (
                UIndirectList<point>
                (
                    mesh_.points(),
                    SubList<label>(labels_, n, starts_.last())
                )
            )
        );
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


bool meshCell::asBox(bool& positive) const
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
        const scalar outwards =
            (side % 2 ? 1 : -1)*geometry_[i].area[side/2];
        positive = positive && outwards > 0;
        area += outwards;
    }

    // A closed surface covers the box a whole number of times
    const scalar once = 2
       *(span.x()*span.y() + span.y()*span.z() + span.z()*span.x());
    positive = positive && area < 1.5*once;

    return true;
}


bool meshCell::hasPositivePyramids() const
{
    const point centre(cellGeometry(geometry_).centre);
    const pointField& x = mesh_.points();
    for (label i = 0; i < nFaces(); ++i)
    {
        const bool isPositive =
            nPoints(i) > 3
          ? geometry_[i].pyramid3(centre) > 0
          : orientation
            (
                x[corner(i, 0)], x[corner(i, 1)], x[corner(i, 2)], centre
            ) < 0;
        if (!isPositive)
        {
            return false;
        }
    }

    return true;
}


scalar meshCell::volume() const
{
    // An apex nearby: differences of large volumes are not precise
    const point& apex = mesh_.points()[labels_[0]];
    scalar sum = 0;
    for (const faceGeometry& f : geometry_)
    {
        sum += f.pyramid3(apex)/3;
    }

    return sum;
}


bool meshCell::hasVolume() const
{
    scalar area = 0;
    for (const faceGeometry& f : geometry_)
    {
        area += mag(f.area);
    }

    return
        volume()
      > roundingVolume(boundBox(mesh_.points(), labels_, false), area);
}


bool meshCell::isPositivePolyhedron(const label celli)
{
    set(celli);
    corners_.set(labels_, starts_);

    return corners_.facts().closed && hasPositivePyramids();
}


meshCellVerdict meshCell::cornersVerdict()
{
    corners_.set(labels_, starts_);
    const cellCorners::factsOfAll corners(corners_.facts());
    if (!corners.closed)
    {
        return {meshCellShape::other, false};
    }

    // As merged tetrahedra, of which corners say too little
    bool positiveBox = false;
    if (!corners.simple && polyhedralMesh::isOfTriangles(nTriangles_, nFaces()))
    {
        return asBox(positiveBox)
          ? meshCellVerdict{meshCellShape::box, positiveBox}
          : meshCellVerdict
            {
                meshCellShape::polyhedron, hasPositivePyramids()
            };
    }

    // Only a cell with more points, or points within its edges, may be refined
    if (!corners.positive && (corners.within || corners.nPoints > 8))
    {
        return asBox(positiveBox)
          ? meshCellVerdict{meshCellShape::box, positiveBox}
          : meshCellVerdict
            {
                meshCellShape::polyhedron, hasPositivePyramids()
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


// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

const Enum<meshCellShape> meshCellShapeName
({
    {meshCellShape::prism, "prism"},
    {meshCellShape::lyingPrism, "lyingPrism"},
    {meshCellShape::hexahedron, "hexahedron"},
    {meshCellShape::wedge, "wedge"},
    {meshCellShape::tetrahedron, "tetrahedron"},
    {meshCellShape::box, "box"},
    {meshCellShape::other, "other"},
    {meshCellShape::polyhedron, "polyhedron"}
});


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label meshCell::faceOf(const label n, label i) const
{
    while (nPoints(i) != n)
    {
        ++i;
    }

    return i;
}


bool meshCell::isTriangle
(
    const label i,
    const label a,
    const label b,
    const label c
) const
{
    for (label k = 0; k < 3; ++k)
    {
        if (corner(i, k) == a)
        {
            return corner(i, k + 1) == b && corner(i, k + 2) == c;
        }
    }

    return false;
}


bool meshCell::readSide(const label i, label* p, label* above) const
{
    for (label k = 0; k < 3; ++k)
    {
        for (label j = 0; j < 4; ++j)
        {
            if
            (
                corner(i, j) == p[k]
             && corner(i, j + 1) == p[(k + 1)%3]
             && p[k + 3] < 0
            )
            {
                above[(k + 1)%3] = corner(i, j + 2);
                p[k + 3] = corner(i, j + 3);

                return true;
            }
        }
    }

    return false;
}


bool meshCell::asPrism(label* p) const
{
    if (nFaces() != 5 || nTriangles_ != 2 || nQuads_ != 3)
    {
        return false;
    }

    const label lower = faceOf(3);
    const label upper = faceOf(3, lower + 1);

    // From inside, the order is the reverse
    for (label k = 0; k < 3; ++k)
    {
        p[k] = corner(lower, 2 - k);
        p[k + 3] = -1;
    }

    label above[3];

    for (label i = 0; i < 5; ++i)
    {
        if (nPoints(i) == 4 && !readSide(i, p, above))
        {
            return false;
        }
    }

    for (label k = 0; k < 3; ++k)
    {
        for (label j = 0; j < 3; ++j)
        {
            if (above[k] != p[k + 3] || p[k + 3] == p[j])
            {
                return false;
            }
        }
    }

    return isTriangle(upper, p[3], p[4], p[5]);
}


bool meshCell::asWedge(label* p) const
{
    if (nFaces() != 4 || nTriangles_ != 2 || nQuads_ != 2)
    {
        return false;
    }

    const label a = faceOf(4);
    const label b = faceOf(4, a + 1);

    // The point between the two common edges
    for (label i = 0; i < 4; ++i)
    {
        for (label j = 0; j < 4; ++j)
        {
            if
            (
                corner(a, i) == corner(b, j)
             && corner(a, i + 1) == corner(b, j + 3)
             && corner(a, i + 3) == corner(b, j + 1)
            )
            {
                // A prism of which two lower points are one
                p[0] = p[1] = corner(a, i + 1);
                p[2] = corner(a, i);
                p[3] = corner(a, i + 2);
                p[4] = corner(b, j + 2);
                p[5] = corner(a, i + 3);

                const label s = faceOf(3);
                const label t = faceOf(3, s + 1);

                return
                    (isTriangle(s, p[3], p[4], p[5])
                  && isTriangle(t, p[0], p[4], p[3]))
                 || (isTriangle(t, p[3], p[4], p[5])
                  && isTriangle(s, p[0], p[4], p[3]));
            }
        }
    }

    return false;
}

} // End namespace Foam

// ************************************************************************* //
