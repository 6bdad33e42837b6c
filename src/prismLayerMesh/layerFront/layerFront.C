/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerFront.H"
#include "ListOps.H"
#include "normalSectors.H"
#include "planarFan.H"
#include "sidePatch.H"
#include "sideShape.H"

namespace Foam
{

//- Returns the constraint of a column at x on a side patch
static columnConstraint onSide(const sidePatch& side, const point& x)
{
    if (!side.isCurved())
    {
        return columnConstraint::inPlane(side.origin, side.normal);
    }

    const std::shared_ptr<const sideShape> shape(side.shape);

    const vector normal(side.planeAt(x).normal);

    // What is beside each other in the tangent plane remains so
    return columnConstraint::onSurface
    (
        normal,
        [=](const point& y) { return shape->along(y, normal, mag(y - x)); }
    );
}


//- Returns the constraint of a column at x on two side patches.
//  tangent: unit tangent of the common line of both
static columnConstraint onBothSides
(
    const sidePatch& first,
    const sidePatch& second,
    const point& x,
    const vector& tangent
)
{
    if (!first.isCurved() && !second.isCurved())
    {
        return columnConstraint::onLine(x, tangent);
    }

    const sideCurve curve(first, second, x);

    return columnConstraint::onCurve
    (
        tangent, [curve](const point& y) { return curve.nearest(y); }
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalarField layerFront::smallest(const scalarField& values) const
{
    scalarField result(wallPoints.size() - extraColumnPoints().size(), GREAT);

    forAll(values, c)
    {
        scalar& s = result[wallPoints[c]];
        s = min(s, values[c]);
    }

    return result;
}


labelList layerFront::extraColumnPoints() const
{
    // Each first column stands on the point of its own label
    label nFirst = 0;
    while (nFirst < wallPoints.size() && wallPoints[nFirst] == nFirst)
    {
        ++nFirst;
    }

    return SubList<label>(wallPoints, wallPoints.size() - nFirst, nFirst);
}


void layerFront::complete(wallAddressing ofWall, wallVisibility seenFromWall)
{
    if (isBare())
    {
        addressing = std::move(ofWall);
        visibility = std::move(seenFromWall);
    }
}


void layerFront::setConstraints
(
    const wallAddressing& around,
    const vectorField& sideLines
)
{
    constraints.clear();
    if (around.pointSides.empty())
    {
        return;
    }

    const List<sidePatch>& sides = surface.border.sides;

    constraints.setSize(wallPoints.size());
    forAll(constraints, c)
    {
        const point& x = surface.points[c];
        const labelList own(around.sidesOf(c));

        if (sideLines.size() && mag(sideLines[c]) > 0)
        {
            constraints[c] = onBothSides
            (
                sides[own[0]], sides[own[1]], x, sideLines[c]
            );
        }
        else if (own.size())
        {
            constraints[c] = onSide(sides[own[0]], x);
        }
    }
}


// * * * * * * * * * * * * * *  Make Layer Front * * * * * * * * * * * * * * //

namespace
{

//- The front while it is divided
struct frontBuilder
{
    const wallSurface& wall;
    const wallAddressing& addressing;
    const wallSectors& divided;
    layerFront& front;

    //- The second column of each divided point
    labelList secondColumns = labelList(divided.points.size());


    //- Column of the sector of point k
    label sectorColumn(const label k, const label s) const
    {
        return s ? secondColumns[k] + s - 1 : divided.points[k];
    }


    //- Column of face i around point p of the wall
    label column(const label p, const label i) const
    {
        const label k = divided.indices[p];

        return k < 0 ? p : sectorColumn(k, divided.sectors[k].sector(i));
    }


    //- Face that has no area on the wall
    void addFace(const face& columns)
    {
        front.surface.faces.append(columns);
        front.surface.patchIDs.append(-1);
    }


    void addColumns()
    {
        forAll(divided.points, k)
        {
            secondColumns[k] = front.wallPoints.size();

            for (label s = 1; s < divided.sectors[k].starts.size(); ++s)
            {
                front.wallPoints.append(divided.points[k]);
                front.surface.points.append(wall.points[divided.points[k]]);
            }
        }
    }


    //- The faces of the wall stand on the columns of their sectors
    void moveFaces()
    {
        for (const label p : divided.points)
        {
            const labelList& pFaces = addressing.pointFaces[p];

            forAll(pFaces, i)
            {
                face& f = front.surface.faces[pFaces[i]];
                f[wall.faces[pFaces[i]].find(p)] = column(p, i);
            }
        }
    }


    //- The columns of point p at its edge i: the column of the face before the
    //  edge, then the columns of the sectors that begin at the edge
    labelList columnsAt(const label p, const label i) const
    {
        const label before = addressing.pointFaces[p].rcIndex(i);
        labelList columns(1, column(p, before));
        const label k = divided.indices[p];
        if (k >= 0)
        {
            const normalSectors& sectors = divided.sectors[k];
            forAll(sectors.starts, s)
            {
                if (sectors.starts[s] == i)
                {
                    columns.append(sectorColumn(k, s));
                }
            }
        }

        return columns;
    }


    //- On the edges where sectors of point k meet
    void addEdgeFaces(const label k)
    {
        const label p = divided.points[k];

        forAll(addressing.pointPoints[p], i)
        {
            const labelList here(columnsAt(p, i));
            if (here.size() == 1 || (i == 0 && addressing.isOnBorder(p)))
            {
                continue;
            }

            // What is before the edge seen from p is after it from q
            const label q = addressing.pointPoints[p][i];
            const labelList there
            (
                reverseList
                (
                    columnsAt(q, addressing.pointPoints[q].find(p))
                )
            );
            for (label s = 1; s < here.size(); ++s)
            {
                if (there.size() == 1)
                {
                    addFace(face({there[0], here[s], here[s - 1]}));
                }
                else if (p < q)
                {
                    addFace
                    (
                        face({here[s - 1], there[s - 1], there[s], here[s]})
                    );
                }
            }
        }
    }


    //- The edges of the border stand on the columns of their sectors. At each
    //  divided point there is a further edge, from the last column to the first
    //  one. A fan has such an edge between each two of its columns.
    void moveBorder()
    {
        wallBorder& border = front.surface.border;

        for (edge& e : border.edges)
        {
            e = edge
            (
                column(e.start(), 0),
                column(e.end(), addressing.pointFaces[e.end()].size() - 1)
            );
        }

        forAll(divided.points, k)
        {
            if (addressing.isOnBorder(divided.points[k]))
            {
                const label last = divided.sectors[k].starts.size() - 1;
                const label step = divided.sectors[k].triangles.empty()
                  ? 1 : last;
                for (label s = last; s > 0; s -= step)
                {
                    border.edges.append
                    (
                        edge(sectorColumn(k, s), sectorColumn(k, s - step))
                    );
                    border.edgeSides.append
                    (
                        addressing.sidesOf(divided.points[k])[0]
                    );
                }
            }
        }
    }


    //- Between three or more columns of point k
    void addPointFaces(const label k)
    {
        for (face f : divided.sectors[k].triangles)
        {
            for (label& s : f)
            {
                s = sectorColumn(k, s);
            }

            addFace(f);
        }
    }


    //- What the columns of a divided point must be in front of besides their
    //  faces
    void addPlanes()
    {
        wallVisibility& visibility = front.visibility;

        forAll(divided.points, k)
        {
            forAll(divided.sectors[k].starts, s)
            {
                const label c = sectorColumn(k, s);
                if (visibility.cornerNormals[c].empty())
                {
                    const vector& axis = divided.sectors[k].axes[s];
                    visibility.cornerNormals[c] = vectorField(1, axis);
                    visibility.meanNormals[c] = axis;
                }
                visibility.polygonNormals[c].append
                (
                    divided.sectors[k].planes[s]
                );
                visibility.setCone(c);
            }
        }
    }


    void divide()
    {
        addColumns();
        moveFaces();
        moveBorder();

        forAll(divided.points, k)
        {
            addEdgeFaces(k);
            addPointFaces(k);
        }

        front.addressing = makeWallAddressing(front.surface);
        front.visibility = makeWallVisibility(front.surface, front.addressing);
        addPlanes();
    }
};

} // End anonymous namespace

layerFront makeBareFront
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const scalar smallestAngle,
    const labelUList& single
)
{
    layerFront front;
    front.surface = wall;
    front.wallPoints = identity(wall.points.size());
    front.nWallFaces = wall.faces.size();

    // In two dimensions both ends of an edge are alike, whatever rounding says
    boolList narrow(visibility.narrowCones(smallestAngle));
    if (single.size())
    {
        const boolList isEmpty(visibility.narrowCones(0));
        UIndirectList<bool>(narrow, single) =
            UIndirectList<bool>(isEmpty, single);
    }
    forAll(narrow, p)
    {
        const label q = pointAcross(wall, addressing, p);
        narrow[p] = narrow[p] || (q >= 0 && narrow[q]);
    }

    if (narrow.found(true))
    {
        const wallSectors divided
        (
            divideNarrowPoints(wall, addressing, visibility, narrow)
        );
        front.pointsWithoutDirection = divided.pointsWithoutDirection;

        if (front.pointsWithoutDirection.empty())
        {
            frontBuilder{wall, addressing, divided, front}.divide();
        }
    }

    front.setConstraints
    (
        front.isBare() ? addressing : front.addressing,
        front.isBare() ? visibility.sideLines : front.visibility.sideLines
    );

    return front;
}


labelList pointsWithoutDirection(const wallSurface& wall)
{
    const wallAddressing addressing(makeWallAddressing(wall));
    const wallVisibility visibility(makeWallVisibility(wall, addressing));

    return
        makeBareFront(wall, addressing, visibility, 0).pointsWithoutDirection;
}

} // End namespace Foam

// ************************************************************************* //
