/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSurface.H"
#include "CompactListList.H"
#include "pointOrder.H"
#include "ranges.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A corner of a face at a point: the points after and before it
struct wallCorner
{
    label next;
    label previous;
    label facei;
};

} // End anonymous namespace


typedef CompactListList<wallCorner> wallCorners;


//- The corners at each point
static wallCorners makeCorners(const wallSurface& wall)
{
    labelList nCorners(wall.points.size(), Zero);

    for (const face& f : wall.faces)
    {
        for (const label p : f)
        {
            ++nCorners[p];
        }
    }

    wallCorners corners(nCorners);
    labelList next(SubList<label>(corners.offsets(), nCorners.size()));

    forAll(wall.faces, facei)
    {
        const face& f = wall.faces[facei];

        forAll(f, i)
        {
            corners.m()[next[f[i]]++] =
                {f[f.fcIndex(i)], f[f.rcIndex(i)], facei};
        }
    }

    return corners;
}


//- Returns the corner that begins at an edge on which none ends. If there is no
//  such edge, returns the corner whose next point is before the others.
static label firstCorner
(
    const UList<wallCorner>& corners,
    const pointField& points
)
{
    label first = 0;

    forAll(corners, i)
    {
        const bool follows = anyOf(corners, [&](const wallCorner& other)
        {
            return other.previous == corners[i].next;
        });

        if (!follows)
        {
            return i;
        }
        if (isBefore(points[corners[i].next], points[corners[first].next]))
        {
            first = i;
        }
    }

    return first;
}


//- Sorts corners so that each begins at the edge on which the one before ends.
//  The first one does not depend on the labels of points and faces.
static void sortByRotation
(
    UList<wallCorner>& corners,
    const pointField& points
)
{
    std::swap(corners[0], corners[firstCorner(corners, points)]);

    for (label i = 1; i < corners.size(); ++i)
    {
        for (label j = i; j < corners.size(); ++j)
        {
            if (corners[j].next == corners[i - 1].previous)
            {
                std::swap(corners[i], corners[j]);
                break;
            }
        }
    }
}


//- The face that runs from a to b; -1 if there is none
static label faceAlong(const wallCorners& corners, const label a, const label b)
{
    for (const wallCorner& corner : corners[a])
    {
        if (corner.next == b)
        {
            return corner.facei;
        }
    }

    return -1;
}


static void setEdges(const wallCorners& corners, wallAddressing& addressing)
{
    DynamicList<edge> edges(corners.m().size()/2);
    DynamicList<labelPair> edgeFaces(corners.m().size()/2);

    forAll(corners, a)
    {
        for (const wallCorner& corner : corners[a])
        {
            const label b = corner.next;
            const label other = faceAlong(corners, b, a);

            if (a < b || other < 0)
            {
                edges.append(edge(a, b));
                edgeFaces.append(labelPair(corner.facei, other));
            }
        }
    }

    addressing.edges.transfer(edges);
    addressing.edgeFaces.transfer(edgeFaces);
}


static void setPointSides(const wallSurface& wall, wallAddressing& addressing)
{
    if (wall.border.edges.empty())
    {
        return;
    }

    addressing.pointSides.setSize(wall.points.size(), labelPair(-1, -1));

    const Map<labelPair> sides(wall.border.pointSides());
    forAllConstIters(sides, iter)
    {
        addressing.pointSides[iter.key()] = iter.val();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelList wallAddressing::sidesOf(const label p) const
{
    if (!isOnBorder(p))
    {
        return labelList();
    }

    const labelPair& sides = pointSides[p];

    return sides.first() == sides.second()
      ? labelList({sides.first()})
      : labelList({sides.first(), sides.second()});
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

wallAddressing makeWallAddressing(const wallSurface& wall)
{
    wallCorners corners(makeCorners(wall));

    wallAddressing addressing;
    setEdges(corners, addressing);

    addressing.pointFaces.setSize(corners.size());
    addressing.pointPoints.setSize(corners.size());

    #pragma omp parallel for schedule(static, 256)
    for (label p = 0; p < corners.size(); ++p)
    {
        UList<wallCorner> around(corners[p]);
        if (around.empty())
        {
            continue;
        }
        sortByRotation(around, wall.points);

        labelList& faces = addressing.pointFaces[p];
        labelList& points = addressing.pointPoints[p];
        faces.setSize(around.size());
        points.setSize(around.size());

        forAll(around, i)
        {
            faces[i] = around[i].facei;
            points[i] = around[i].next;
        }

        // On a border the last edge begins no corner
        if (around.last().previous != points[0])
        {
            points.append(around.last().previous);
        }
    }

    setPointSides(wall, addressing);

    return addressing;
}

} // End namespace Foam

// ************************************************************************* //
