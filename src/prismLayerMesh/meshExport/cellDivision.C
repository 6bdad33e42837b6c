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


void cellDivision::divideFace
(
    const label facei,
    const label celli,
    faceList triangles
)
{
    const label owner = mesh_.owner(facei);
    for (face& f : triangles)
    {
        if (owner != celli)
        {
            f.flip();
        }
    }
    trianglesOf_.set(facei, triangles);

    for (const label beside : {owner, mesh_.across(facei, owner)})
    {
        if (beside >= 0)
        {
            wholeOf_[beside] = -1;
            pending_.append(beside);
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


label cellDivision::prismTop
(
    const label facei,
    const label celli,
    Map<label>& above
) const
{
    const face& lower = mesh_.faces()[facei];
    const label top = mesh_.opposite(facei, celli);
    if (top < 0 || mesh_.cellFaces(celli).size() != lower.size() + 2)
    {
        return -1;
    }
    const face& upper = mesh_.faces()[top];

    for (const label sidei : mesh_.cellFaces(celli))
    {
        const face& side = mesh_.faces()[sidei];
        if (sidei == facei || sidei == top)
        {
            continue;
        }
        if (side.size() != 4 || trianglesOf_.found(sidei))
        {
            return -1;
        }
        for (label k = 0; k < 4; ++k)
        {
            if (lower.found(side[k]) && upper.found(side.nextLabel(k)))
            {
                above.set(side[k], side.nextLabel(k));
            }
        }
    }

    return
        upper.size() == lower.size() && above.size() == lower.size()
      ? top : -1;
}


faceList cellDivision::raised
(
    const label facei,
    const label celli,
    const Map<label>& above
) const
{
    faceList triangles(partsOf(facei, celli));
    for (face& f : triangles)
    {
        f = face({above[f[0]], above[f[2]], above[f[1]]});
    }

    return triangles;
}


void cellDivision::dividePolygon(const label facei)
{
    DynamicList<label> faces;
    faces.append(facei);
    divideFace
    (
        facei,
        mesh_.owner(facei),
        splitPolygon(mesh_.points(), mesh_.faces()[facei])
    );

    while (faces.size())
    {
        const label lower = faces.remove();
        const label owner = mesh_.owner(lower);
        for (const label celli : {owner, mesh_.across(lower, owner)})
        {
            Map<label> above;
            const label top = celli < 0 ? -1 : prismTop(lower, celli, above);
            if (top >= 0 && !trianglesOf_.found(top))
            {
                divideFace(top, celli, raised(lower, celli, above));
                faces.append(top);
            }
        }
    }
}


bool cellDivision::isOnPolygon(const label celli) const
{
    return anyOf(mesh_.cellFaces(celli), [&](const label facei)
    {
        return mesh_.faces()[facei].size() > 4;
    });
}


bool cellDivision::dividePrism(const label celli)
{
    for (const label facei : mesh_.cellFaces(celli))
    {
        Map<label> above;
        const label top = trianglesOf_.found(facei)
          ? prismTop(facei, celli, above) : -1;
        if (top < 0)
        {
            continue;
        }
        const faceList upper(raised(facei, celli, above));
        const faceList given(partsOf(top, celli));
        labelListList prisms;
        for (const face& f : partsOf(facei, celli))
        {
            prisms.append
            (
                labelList
                ({
                    f[0], f[2], f[1], above[f[0]], above[f[2]], above[f[1]]
                })
            );
        }
        const bool alike = given.size() == 1 || allOf(upper, [&](const face& f)
        {
            return anyOf(given, [&](const face& g)
            {
                return face::compare(f, g) != 0;
            });
        });
        const bool positive = allOf(prisms, [&](const labelList& prism)
        {
            return isPositive(elementShape::prism, prism, mesh_.points());
        });

        if (alike && positive)
        {
            if (!trianglesOf_.found(top))
            {
                divideFace(top, celli, upper);
            }
            wholeOf_[celli] = whole_.size();
            nPrismsOf_.set(celli, prisms.size());
            for (const labelList& prism : prisms)
            {
                whole_.append(elementShape::prism, prism);
            }
            return true;
        }
    }

    return false;
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


//- The two triangles of a quadrilateral on the diagonal from point k, 0 or 1
static faceList trianglesOn(const label k, const face& f)
{
    return faceList
    ({
        face({f[k], f[k + 1], f[k + 2]}), face({f[k], f[k + 2], f[(k + 3)%4]})
    });
}


//- Number of the first digits of a way, to the base 3, that are not 2
static label nDiagonals(label way, const label nDigits)
{
    label n = 0;
    for (label i = 0; i < nDigits; ++i, way /= 3)
    {
        n += way % 3 < 2;
    }

    return n;
}


bool cellDivision::divideAlong
(
    const label celli,
    const labelUList& quads,
    label way
)
{
    Map<faceList> chosen;
    for (const label facei : quads)
    {
        if (way % 3 < 2)
        {
            chosen.set(facei, trianglesOn(way % 3, mesh_.faces()[facei]));
            trianglesOf_.set(facei, chosen[facei]);
        }
        way /= 3;
    }
    const bool divided = divideCell(celli);

    for (const label facei : chosen.sortedToc())
    {
        trianglesOf_.erase(facei);
        if (divided)
        {
            divideFace(facei, mesh_.owner(facei), chosen[facei]);
        }
    }

    return divided;
}


bool cellDivision::divideQuads(const label celli)
{
    DynamicList<label> quads;
    label nWays = 1;
    for (const label facei : mesh_.cellFaces(celli))
    {
        if
        (
            mesh_.faces()[facei].size() == 4 && !trianglesOf_.found(facei)
         && quads.size() < maxDivided
        )
        {
            quads.append(facei);
            nWays *= 3;
        }
    }
    for (label n = 1; n <= quads.size(); ++n)
    {
        for (label way = 0; way < nWays; ++way)
        {
            if
            (
                nDiagonals(way, quads.size()) == n
             && divideAlong(celli, quads, way)
            )
            {
                return true;
            }
        }
    }

    return false;
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
        if (mesh.faces()[facei].size() > 4 && !trianglesOf_.found(facei))
        {
            dividePolygon(facei);
        }
    }

    // Quadrilaterals are divided last, as their other cells are then divided,
    // too, and have no choice of the diagonal
    DynamicList<label> hard;
    while (pending_.size() || hard.size())
    {
        const bool easy = pending_.size();
        const label celli = easy ? pending_.remove() : hard.remove();

        if (wholeOf_[celli] >= 0 || apexOf_[celli] >= 0)
        {
            continue;
        }
        if (easy)
        {
            const bool divided =
                (isOnPolygon(celli) && dividePrism(celli)) || divideCell(celli);
            if (!divided)
            {
                hard.append(celli);
            }
        }
        else if (!dividePrism(celli) && !divideQuads(celli))
        {
            refuse(celli);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label cellDivision::nDivided() const
{
    label n = 0;
    forAll(wholeOf_, celli)
    {
        n += wholeOf_[celli] < 0 || nPrismsOf_.found(celli);
    }

    return n;
}


void cellDivision::appendCell
(
    const label celli,
    const label firstApex,
    elementList& cells
) const
{
    if (wholeOf_[celli] >= 0)
    {
        const label first = wholeOf_[celli];
        for (label i = first; i < first + nPrismsOf_.lookup(celli, 1); ++i)
        {
            cells.append(whole_.shape(i), whole_.points(i));
        }
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
