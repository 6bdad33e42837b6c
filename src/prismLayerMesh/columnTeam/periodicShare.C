/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "periodicShare.H"
#include "EdgeMap.H"
#include "ListOps.H"
#include "ranges.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Constraints * * * * * * * * * * * * * * * * //

//- The constraint of a column that must stay on a side, too
static columnConstraint alsoOn
(
    const sidePlane& side,
    const label other,
    const UList<sidePatch>& sides,
    const point& x
)
{
    return other < 0
      ? columnConstraint::inPlane(side.origin, side.normal)
      : columnConstraint::onLine
        (
            x, normalised(side.normal ^ sides[other].normal)
        );
}


//- Lets a column see the reflections of its normals, too: so that the axis of
//  its cone is in the plane
static void seeReflections
(
    const sidePlane& side,
    wallVisibility& visibility,
    const label c
)
{
    DynamicList<vector> further(visibility.polygonNormals[c]);
    for (const vector& n : visibility.cornerNormals[c])
    {
        further.append(side.reflected(n));
    }
    for (const vector& n : visibility.polygonNormals[c])
    {
        further.append(side.reflected(n));
    }
    visibility.polygonNormals[c] = vectorField(further);
}


labelList constrainToCyclicSides
(
    const wallSurface& given,
    const periodicWall& wall,
    layerFront& whole
)
{
    const List<sidePatch>& sides = given.border.sides;
    whole.constraints.setSize(whole.wallPoints.size());
    const Map<labelPair> pointSides(given.border.pointSides());
    forAll(whole.wallPoints, c)
    {
        const label p = whole.wallPoints[c];
        const auto found = pointSides.cfind(p);
        if (!found.found())
        {
            continue;
        }

        const labelPair& on = found.val();
        const label cyclic =
            sides[on.first()].type == "cyclic" ? on.first() : on.second();
        if (sides[cyclic].type == "cyclic")
        {
            const label other =
                on.first() == on.second() ? -1
              : cyclic == on.first() ? on.second() : on.first();
            whole.constraints[c] =
                alsoOn(sides[cyclic], other, sides, wall.surface.points[p]);
            seeReflections(sides[cyclic], whole.visibility, c);
            if (other >= 0 && sides[other].type == "cyclic")
            {
                seeReflections(sides[other], whole.visibility, c);
            }
            whole.visibility.setCone(c);
        }
    }
    const labelList blind(whole.pointsUnder(whole.visibility.emptyCones()));

    return subsetList(blind, [&](const label p) { return p < wall.nPoints; });
}


// * * * * * * * * * * * * * * Periodic Share  * * * * * * * * * * * * * * * //

namespace
{

//- Finds the own column that a column of the whole front is the image of
struct ownColumnFinder
{
    const periodicWall& wall;
    const layerFront& whole;

    //- Columns of points that have several, ascending
    Map<labelList> several{};

    ownColumnFinder(const periodicWall& w, const layerFront& front)
    :
        wall(w),
        whole(front)
    {
        const labelList extra(front.extraColumnPoints());
        const label first = front.wallPoints.size() - extra.size();
        forAll(extra, i)
        {
            labelList& columns = several(extra[i]);
            if (columns.empty())
            {
                columns.append(extra[i]);
            }
            columns.append(first + i);
        }
    }

    labelList columnsOn(const label p) const
    {
        return several.lookup(p, labelList(1, p));
    }

    //- The place, among the columns on a point, of a column that stands on an
    //  image of a corner of a face of the given wall
    label placeAt
    (
        const labelUList& columns,
        const label baseFace,
        const label corner
    ) const
    {
        forAll(columns, i)
        {
            for
            (
                const label facei
              : whole.addressing.pointFaces[columns[i]]
            )
            {
                if
                (
                    facei < whole.nWallFaces
                 && wall.baseFace(facei) == baseFace
                 && whole.surface.faces[facei][corner] == columns[i]
                )
                {
                    return i;
                }
            }
        }

        return -1;
    }

    //- Whether columns stand on images of the faces that the own columns are on
    bool areEqual(const labelUList& columns, const labelUList& own) const
    {
        forAll(own, i)
        {
            for
            (
                const label facei
              : whole.addressing.pointFaces[columns[i]]
            )
            {
                if (facei >= whole.nWallFaces)
                {
                    continue;
                }
                const label corner =
                    whole.surface.faces[facei].find(columns[i]);
                if (placeAt(own, wall.baseFace(facei), corner) != i)
                {
                    return false;
                }
            }
        }

        return own.size();
    }

    //- The columns on the base of a point, for those on the point. Around both
    //  points they are in the same order, but may begin elsewhere. Empty if
    //  they are others.
    labelList ownColumns(const label p) const
    {
        const labelList columns(columnsOn(p));
        labelList own(columnsOn(wall.bases[p]));
        if (own.size() != columns.size())
        {
            return labelList();
        }
        if (own.size() == 1)
        {
            return own;
        }

        for (const label facei : whole.addressing.pointFaces[columns[0]])
        {
            if (facei < whole.nWallFaces)
            {
                const label corner =
                    whole.surface.faces[facei].find(columns[0]);
                const label i = placeAt(own, wall.baseFace(facei), corner);
                own = i < 0 ? labelList() : rotateList(own, -i);
                return areEqual(columns, own) ? own : labelList();
            }
        }

        return labelList();
    }
};

} // End anonymous namespace


//- For each of some columns of the whole front the own column; -1 if points
//  have other columns than their images
static labelList ownColumnsOf
(
    const periodicWall& wall,
    const layerFront& whole,
    const labelUList& columns
)
{
    const ownColumnFinder finder(wall, whole);
    labelList own(columns);
    forAll(columns, c)
    {
        const label p = whole.wallPoints[columns[c]];
        if (!wall.isBase(p))
        {
            const labelList onBase(finder.ownColumns(p));
            own[c] = onBase.size()
              ? onBase[finder.columnsOn(p).find(columns[c])] : -1;
        }
    }

    return own;
}


//- The only process owns the points of the given wall
static labelList ownersOf(const periodicWall& wall)
{
    labelList owners(wall.surface.points.size(), 1);
    SubList<label>(owners, wall.nPoints) = 0;

    return owners;
}


labelList pointsWithOtherColumns
(
    const periodicWall& wall,
    const layerFront& whole
)
{
    const labelList columns(columnsInShare(whole, ownersOf(wall), 0));
    const labelList own(ownColumnsOf(wall, whole, columns));
    labelHashSet bases;
    forAll(columns, c)
    {
        if (own[c] < 0)
        {
            bases.insert(wall.bases[whole.wallPoints[columns[c]]]);
        }
    }

    return bases.sortedToc();
}


//- The edges of the border of counted faces, and their sides
static void setBorder
(
    const wallSurface& given,
    const boolList& isCounted,
    layerFront& front,
    const labelUList& pointOfColumn
)
{
    EdgeMap<label> sideOf;
    forAll(given.border.edges, i)
    {
        sideOf.insert(given.border.edges[i], given.border.edgeSides[i]);
    }
    const Map<labelPair> pointSides(given.border.pointSides());

    wallBorder& border = front.surface.border;
    border.sides = given.border.sides;
    border.edges = outline(subset(isCounted, front.surface.faces));
    border.edgeSides.setSize(border.edges.size());
    forAll(border.edges, i)
    {
        const label p = pointOfColumn[border.edges[i].start()];
        const label q = pointOfColumn[border.edges[i].end()];
        border.edgeSides[i] =
            p == q ? pointSides[p].first() : sideOf[edge(p, q)];
    }
}


//- It counts the faces of the given wall, and those between their columns
static void setCounted
(
    const periodicWall& wall,
    const layerFront& whole,
    frontShare& share
)
{
    const labelList& columns = share.columns.whole;
    const auto isGiven = [&](const label c)
    {
        return whole.wallPoints[columns[c]] < wall.nPoints;
    };
    forAll(share.faces.isOwn, i)
    {
        const label facei = share.faces.whole[i];
        share.faces.isOwn[i] =
            facei < whole.nWallFaces
          ? facei < wall.nFaces : allOf(share.front.surface.faces[i], isGiven);
    }
}


frontShare makePeriodicShare
(
    const wallSurface& given,
    const periodicWall& wall,
    const layerFront& whole
)
{
    // Two rings around all points of the given wall
    frontShare share
    (
        makeFrontShare
        (
            whole, whole.addressing, whole.visibility, ownersOf(wall), 2, 0
        )
    );
    share.owners = pointOwners();

    // The only process gives its own columns to their images
    const labelList& columns = share.columns.whole;
    share.ownColumns = ownColumnsOf(wall, whole, columns);
    share.motions = wall.motions;
    share.motionOfColumn = UIndirectList<label>
    (
        wall.motionOfPoint, whole.pointsUnder(columns)
    )();
    forAll(columns, c)
    {
        share.columns.isOwn[c] = wall.isBase(whole.wallPoints[columns[c]]);
    }
    const labelList images(findIndices(share.columns.isOwn, false));
    labelList sent(images.size());
    forAll(images, i)
    {
        sent[i] = findSortedIndex(columns, share.ownColumns[images[i]]);
    }
    share.columns.received = labelListList(1, images);
    share.columns.sent = labelListList(1, sent);
    share.points = sharedLabels();

    setCounted(wall, whole, share);
    share.faces.nWhole =
        countOf(share.faces.isOwn, [](const bool own) { return own; });
    setBorder
    (
        given, share.faces.isOwn, share.front, whole.pointsUnder(columns)
    );

    return share;
}


layerFront givenFront
(
    const wallSurface& given,
    const frontShare& share,
    labelList& columns
)
{
    const layerFront& from = share.front;
    const labelList faces(findIndices(share.faces.isOwn, true));
    bitSet isUsed(from.wallPoints.size());
    for (const label facei : faces)
    {
        isUsed.set(from.surface.faces[facei]);
    }
    columns = isUsed.toc();

    layerFront front;
    front.surface = partOf(from.surface, columns, faces);
    labelList newColumns(from.wallPoints.size(), -1);
    forAll(columns, i)
    {
        newColumns[columns[i]] = i;
    }
    front.surface.border = from.surface.border;
    for (edge& e : front.surface.border.edges)
    {
        e = edge(newColumns[e.start()], newColumns[e.end()]);
    }
    front.wallPoints =
        UIndirectList<label>(from.wallPoints, columns)();
    inplaceRenumber(newColumns, front.wallPoints);
    front.nWallFaces = given.faces.size();
    front.addressing = makeWallAddressing(front.surface);
    front.visibility = makeWallVisibility(front.surface, front.addressing);
    front.setConstraints(front.addressing, front.visibility.sideLines);

    return front;
}

} // End namespace Foam

// ************************************************************************* //
