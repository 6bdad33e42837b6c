/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellDivision.H"
#include "cellPredicates.H"
#include "hexMatcher.H"
#include "innerPoint.H"
#include "planeOutlines.H"
#include "prismMatcher.H"
#include "pyrMatcher.H"
#include "ranges.H"
#include "tetMatcher.H"

#include <array>
#include <vector>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Finds the shape of cells, and their points in the order of that shape
class shapeOfCell
{
    tetMatcher tet_;
    pyrMatcher pyramid_;
    prismMatcher prism_;
    hexMatcher hex_;

    const std::pair<elementShape, cellMatcher*> matchers_[4] =
    {
        {elementShape::hexahedron, &hex_},
        {elementShape::prism, &prism_},
        {elementShape::tetrahedron, &tet_},
        {elementShape::pyramid, &pyramid_}
    };

public:

    //- Appends a cell if it has the shape of an element, and is positive.
    //  Returns whether it is so.
    bool append
    (
        const polyhedralMesh& mesh,
        const labelList& owner,
        const label celli,
        elementList& elements
    )
    {
        const labelList faces(mesh.cellFaces(celli));

        for (const auto& matcher : matchers_)
        {
            cellMatcher& shape = *matcher.second;

            if
            (
                shape.nFacePerCell() == faces.size()
             && shape.faceSizeMatch(mesh.faces(), faces)
             && shape.matchShape(false, mesh.faces(), owner, celli, faces)
             && isPositive(matcher.first, shape.vertLabels(), mesh.points())
            )
            {
                elements.append(matcher.first, shape.vertLabels());
                return true;
            }
        }

        return false;
    }
};

} // End anonymous namespace


typedef std::array<int, 4> cornerPoints;

//- The tetrahedra at the corners of an element
static const std::vector<cornerPoints>& cornersOf(const elementShape shape)
{
    static const std::vector<cornerPoints> corners[] =
    {
        {{0, 1, 2, 3}},
        {{0, 1, 3, 4}, {1, 2, 0, 4}, {2, 3, 1, 4}, {3, 0, 2, 4}},
        {
            {0, 1, 2, 3}, {1, 2, 0, 4}, {2, 0, 1, 5},
            {3, 5, 4, 0}, {4, 3, 5, 1}, {5, 4, 3, 2}
        },
        {
            {0, 1, 3, 4}, {1, 2, 0, 5}, {2, 3, 1, 6}, {3, 0, 2, 7},
            {4, 7, 5, 0}, {5, 4, 6, 1}, {6, 5, 7, 2}, {7, 6, 4, 3}
        }
    };

    return corners[int(shape) - int(elementShape::tetrahedron)];
}


bool isPositive
(
    const elementShape shape,
    const UList<label>& labels,
    const pointField& points
)
{
    return allOf(cornersOf(shape), [&](const cornerPoints& c)
    {
        return orientation
        (
            points[labels[c[0]]], points[labels[c[1]]],
            points[labels[c[2]]], points[labels[c[3]]]
        ) > 0;
    });
}


//- Smallest distance of a point behind the planes of triangles over the mean of
//  all these distances; negative if it is before a plane
static scalar depth
(
    const UList<face>& triangles,
    const pointField& points,
    const point& x
)
{
    scalar least = GREAT;
    scalar sum = 0;
    for (const face& f : triangles)
    {
        const vector normal(normalised(f.areaNormal(points)));
        const scalar distance = normal & (points[f[0]] - x);
        least = min(least, distance);
        sum += mag(distance);
    }

    return least*triangles.size()/(sum + VSMALL);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void cellDivision::setWhole()
{
    shapeOfCell shape;
    labelList owner(mesh_.faces().size());
    forAll(owner, facei)
    {
        owner[facei] = mesh_.owner(facei);
    }

    forAll(wholeOf_, celli)
    {
        if (shape.append(mesh_, owner, celli, whole_))
        {
            wholeOf_[celli] = whole_.size() - 1;
        }
        else
        {
            pending_.append(celli);
        }
    }
}


void cellDivision::divideFace(const label facei, const faceList& triangles)
{
    trianglesOf_.set(facei, triangles);

    const label owner = mesh_.owner(facei);
    for (const label celli : {owner, mesh_.across(facei, owner)})
    {
        if (celli >= 0)
        {
            wholeOf_[celli] = -1;
            pending_.append(celli);
        }
    }
}


faceList cellDivision::partsOf(const label facei, const label celli) const
{
    const auto found = trianglesOf_.cfind(facei);
    faceList parts
    (
        found.found() ? *found : faceList(1, mesh_.faces()[facei])
    );
    if (mesh_.owner(facei) != celli)
    {
        for (face& part : parts)
        {
            part.flip();
        }
    }

    return parts;
}


bool cellDivision::isSeen
(
    const label facei,
    const label celli,
    const point& apex
) const
{
    return allOf(trianglesOf(facei, celli), [&](const face& f)
    {
        const pointField& x = mesh_.points();

        return orientation(x[f[0]], x[f[2]], x[f[1]], apex) > 0;
    });
}


faceList cellDivision::trianglesOf(const label facei, const label celli) const
{
    DynamicList<face> triangles;
    for (const face& f : partsOf(facei, celli))
    {
        // Those of both diagonals of a quadrilateral
        for (label k = 0; k < (f.size() == 3 ? 1 : 4); ++k)
        {
            triangles.append(face({f[k], f.nextLabel(k), f.prevLabel(k)}));
        }
    }

    return faceList(std::move(triangles));
}


bool cellDivision::findApex(const label celli, point& apex) const
{
    const UList<label> faces(mesh_.cellFaces(celli));
    DynamicList<face> triangles;
    for (const label facei : faces)
    {
        triangles.append(trianglesOf(facei, celli));
    }
    apex = mesh_.centre(celli);

    if
    (
        depth(triangles, mesh_.points(), apex) < leastDepth
     && !findInnerPoint(triangles, mesh_.points(), apex)
    )
    {
        return false;
    }

    return allOf(faces, [&](const label facei)
    {
        return isSeen(facei, celli, apex);
    });
}


bool cellDivision::divideCell(const label celli)
{
    point apex;
    if (!findApex(celli, apex))
    {
        return false;
    }
    apexOf_[celli] = apices_.size();
    apices_.append(apex);

    return true;
}


bool cellDivision::divideQuads(const label celli)
{
    DynamicList<label> quads;
    List<faceList> triangles[2];
    for (const label facei : mesh_.cellFaces(celli))
    {
        const face& f = mesh_.faces()[facei];
        if (f.size() == 4 && !trianglesOf_.found(facei))
        {
            const faceList better(splitPolygon(mesh_.points(), f));

            // The other diagonal begins at point 0 or 1
            const label k = better[0].found(f[0]) && better[1].found(f[0]);
            quads.append(facei);
            triangles[0].append(better);
            triangles[1].append
            (
                faceList
                ({
                    face({f[k], f[k + 1], f[k + 2]}),
                    face({f[k], f[k + 2], f[(k + 3)%4]})
                })
            );
        }
    }
    const label nWays = 1 << min(quads.size(), maxDivided);

    for (label way = 0; way < nWays && apexOf_[celli] < 0; ++way)
    {
        forAll(quads, i)
        {
            const label diagonal = i < maxDivided ? (way >> i) & 1 : 0;
            trianglesOf_.set(quads[i], triangles[diagonal][i]);
        }
        divideCell(celli);
    }
    const bool divided = apexOf_[celli] >= 0;

    for (const label facei : quads)
    {
        const faceList chosen(trianglesOf_[facei]);
        trianglesOf_.erase(facei);
        if (divided && !isSeen(facei, celli, apices_.last()))
        {
            divideFace(facei, chosen);
        }
    }

    return divided;
}


void cellDivision::refuse(const label celli) const
{
    FatalErrorInFunction
        << "Cell " << celli << " at " << mesh_.centre(celli) << " is no"
        << " tetrahedron, pyramid, prism or hexahedron with positive corners,"
        << nl << "and from no point inside of the cell all its faces are seen:"
        << " the cell cannot be divided" << exit(FatalError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

cellDivision::cellDivision(const polyhedralMesh& mesh)
:
    mesh_(mesh),
    wholeOf_(mesh.nCells(), -1),
    apexOf_(mesh.nCells(), -1)
{
    setWhole();

    forAll(mesh.faces(), facei)
    {
        const face& f = mesh.faces()[facei];
        if (f.size() > 4)
        {
            divideFace(facei, splitPolygon(mesh.points(), f));
        }
    }

    // Quadrilaterals are divided last, as their other cells are then divided,
    // too, and have no choice of the diagonal
    DynamicList<label> hard;
    while (pending_.size() || hard.size())
    {
        if (pending_.size())
        {
            const label celli = pending_.remove();
            if (apexOf_[celli] < 0 && !divideCell(celli))
            {
                hard.append(celli);
            }
        }
        else
        {
            const label celli = hard.remove();
            if (apexOf_[celli] < 0 && !divideQuads(celli))
            {
                refuse(celli);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void cellDivision::appendCell
(
    const label celli,
    const label firstApex,
    elementList& cells
) const
{
    const label i = wholeOf_[celli];
    if (i >= 0)
    {
        cells.append(whole_.shape(i), whole_.points(i));
        return;
    }
    const label apex = firstApex + apexOf_[celli];

    for (const label facei : mesh_.cellFaces(celli))
    {
        for (const face& f : partsOf(facei, celli))
        {
            // Seen from the apex, a face is the other way round
            labelList points(f.size() + 1, apex);
            forAll(f, k)
            {
                points[k] = f[f.size() - 1 - k];
            }
            cells.append
            (
                f.size() == 3
              ? elementShape::tetrahedron : elementShape::pyramid,
                points
            );
        }
    }
}


void cellDivision::appendFace(const label facei, elementList& faces) const
{
    for (const face& f : partsOf(facei, mesh_.owner(facei)))
    {
        faces.append
        (
            f.size() == 3
          ? elementShape::triangle : elementShape::quadrilateral,
            f
        );
    }
}

} // End namespace Foam

// ************************************************************************* //
