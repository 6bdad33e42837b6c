/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cyclicSides.H"
#include "DynamicList.H"
#include "edgeHashes.H"
#include "linePointRef.H"
#include "ranges.H"
#include "sideParts.H"
#include "splitAtSidePatches.H"
#include "stageProgress.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Refuses a border on one side of a pair without its image on the other one
static void refuseBorder
(
    const wallSurface& wall,
    const label from,
    const label to,
    const UList<point>& places
)
{
    const List<sidePatch>& sides = wall.border.sides;
    refuseAt
    (
        places,
        "The wall ends on the cyclic side patch " + sides[from].name
      + ", but its image does not end on the partner " + sides[to].name,
        "Both ends must have the same points. Cut a surface that is periodic,"
        " by repair stitch"
    );
}


//- Refuses edges of the border on the first side without an image
static void checkEdges
(
    const wallSurface& wall,
    const sidePair& pair,
    const Map<label>& images
)
{
    edgeHashSet second;
    forAll(wall.border.edges, i)
    {
        if (wall.border.edgeSides[i] == pair.second)
        {
            second.insert(wall.border.edges[i]);
        }
    }

    DynamicList<point> lone;
    forAll(wall.border.edges, i)
    {
        const edge& e = wall.border.edges[i];
        if
        (
            wall.border.edgeSides[i] == pair.first
         && !second.found(edge(images[e.start()], images[e.end()]))
        )
        {
            lone.append(e.centre(wall.points));
        }
    }
    refuseBorder(wall, pair.first, pair.second, lone);
}


Map<label> imagesOnBorder
(
    const wallSurface& wall,
    const sidePair& pair,
    const scalar tolerance
)
{
    const labelList first(wall.border.pointsOn(pair.first));
    const labelList second(wall.border.pointsOn(pair.second));
    const pointField atFirst(wall.points, first);
    const pointField atSecond(wall.points, second);

    // From both sides: each point must have one
    const rigidMotion back(pair.toSecond.inverse());
    const labelList images
    (
        imagesAmong(atSecond, atFirst, pair.toSecond, tolerance)
    );
    const labelList originals(imagesAmong(atFirst, atSecond, back, tolerance));

    Map<label> result(2*first.size());
    DynamicList<point> lone, loneImages;
    forAll(first, i)
    {
        const label j = images[i];
        if (j >= 0 && originals[j] == i)
        {
            result.insert(first[i], second[j]);
        }
        else
        {
            lone.append(atFirst[i]);
        }
    }
    forAll(second, j)
    {
        const label i = originals[j];
        if (i < 0 || images[i] != j)
        {
            loneImages.append(atSecond[j]);
        }
    }
    refuseBorder(wall, pair.first, pair.second, lone);
    refuseBorder(wall, pair.second, pair.first, loneImages);
    checkEdges(wall, pair, result);

    return result;
}


// * * * * * * * * * * * * * *  Align Cyclic Sides * * * * * * * * * * * * * //

//- A point moves towards an image that is nearer than this share of the edges
static const scalar nearShare = 0.5;

//- A point is added to an edge that is nearer than this share of its length
static const scalar offShare = 0.1;


namespace
{

//- The border of a wall on both sides of a pair, while it is aligned
struct borderAligner
{
    wallSurface& wall;
    const sidePair& pair;
    const scalar tolerance;
    cyclicAlignment& done;

    //- The points of the border on a side that have no image, or are none
    labelList lonePoints(const label side) const
    {
        const label other = side == pair.first ? pair.second : pair.first;
        const labelList own(wall.border.pointsOn(side));
        const labelList places
        (
            imagesAmong
            (
                pointField(wall.points, wall.border.pointsOn(other)),
                pointField(wall.points, own), motionFrom(side),
                touchShare*tolerance
            )
        );
        DynamicList<label> lone;
        forAll(own, i)
        {
            if (places[i] < 0)
            {
                lone.append(own[i]);
            }
        }

        return labelList(std::move(lone));
    }

    rigidMotion motionFrom(const label side) const
    {
        return side == pair.first ? pair.toSecond : pair.toSecond.inverse();
    }

    //- Whether a point is on further sides, where it cannot move
    bool isCorner(const Map<labelPair>& sides, const label p) const
    {
        return sides[p].first() != sides[p].second();
    }

    //- The shortest edge of the border at each of its points
    Map<scalar> shortestEdges() const
    {
        Map<scalar> shortest;
        for (const edge& e : wall.border.edges)
        {
            for (const label p : {e.first(), e.second()})
            {
                const scalar length = e.mag(wall.points);
                shortest.set(p, min(length, shortest.lookup(p, GREAT)));
            }
        }

        return shortest;
    }

    //- The nearest of some points to x, -1 if there are none
    label nearestOf(const labelUList& points, const point& x) const
    {
        label nearest = -1;
        for (const label p : points)
        {
            if
            (
                nearest < 0
             || magSqr(wall.points[p] - x) < magSqr(wall.points[nearest] - x)
            )
            {
                nearest = p;
            }
        }

        return nearest;
    }

    //- The edge of the border on a side that x is near to, -1 if there is none
    label edgeNear(const label side, const point& x) const
    {
        label nearest = -1;
        scalar least = GREAT;
        forAll(wall.border.edges, i)
        {
            if (wall.border.edgeSides[i] != side)
            {
                continue;
            }
            const linePointRef line(wall.border.edges[i].line(wall.points));
            const scalar distance = line.nearestDist(x).distance();
            if
            (
                distance < least
             && distance < max(tolerance, offShare*line.mag())
            )
            {
                nearest = i;
                least = distance;
            }
        }

        return nearest;
    }

    void move(const label p, const point& to)
    {
        done.largestMove = max(done.largestMove, mag(to - wall.points[p]));
        wall.points[p] = to;
    }

    //- Points and images that are near to each other meet half way. If one of
    //  both cannot move, the other one moves to it.
    void joinNearPoints()
    {
        const Map<labelPair> sides(wall.border.pointSides());
        const Map<scalar> shortest(shortestEdges());
        const rigidMotion back(pair.toSecond.inverse());
        const labelList first(lonePoints(pair.first));
        const labelList second(lonePoints(pair.second));
        for (const label p : first)
        {
            const label q = nearestOf(second, pair.toSecond(wall.points[p]));
            if (q < 0 || nearestOf(first, back(wall.points[q])) != p)
            {
                continue;
            }

            const point image(pair.toSecond(wall.points[p]));
            const scalar distance = mag(wall.points[q] - image);
            const bool isFixed = isCorner(sides, p) || isCorner(sides, q);
            const scalar most =
                isFixed ? tolerance
              : max(tolerance, nearShare*min(shortest[p], shortest[q]));
            if (distance < most && edgeNear(pair.second, image) >= 0)
            {
                if (distance > tolerance)
                {
                    move(p, 0.5*(wall.points[p] + back(wall.points[q])));
                    ++done.nMoved;
                }
                move(q, pair.toSecond(wall.points[p]));
            }
        }
    }

    //- Divides edges of the border and the faces beside them
    void divide(const EdgeMap<label>& points)
    {
        splitAtEdges(points, wall);
        wallBorder& border = wall.border;
        DynamicList<edge> edges;
        DynamicList<label> edgeSides;
        forAll(border.edges, i)
        {
            const edge& e = border.edges[i];
            const label p = points.lookup(e, -1);
            edges.append(p < 0 ? e : edge(e.first(), p));
            edgeSides.append(border.edgeSides[i]);
            if (p >= 0)
            {
                edges.append(edge(p, e.second()));
                edgeSides.append(border.edgeSides[i]);
            }
        }
        border.edges = std::move(edges);
        border.edgeSides = std::move(edgeSides);
    }

    //- Adds the images of lone points of one side to edges of the other side,
    //  at most one to each edge. False if there was none to add.
    bool addImages(const label from, const label to)
    {
        EdgeMap<label> points;
        for (const label p : lonePoints(from))
        {
            const point image(motionFrom(from)(wall.points[p]));
            const label i = edgeNear(to, image);
            const label added = wall.points.size();
            if (i >= 0 && points.insert(wall.border.edges[i], added))
            {
                wall.points.append(image);
                ++done.nAdded;
            }
        }
        divide(points);

        return points.size();
    }
};

} // End anonymous namespace


cyclicAlignment alignCyclicSides(wallSurface& wall, const scalar tolerance)
{
    cyclicAlignment done;
    for (const sidePair& pair : pairsOf(wall.border.sides))
    {
        borderAligner aligner{wall, pair, tolerance, done};
        aligner.joinNearPoints();
        const label most = wall.border.edges.size();
        for (const bool forwards : {true, false})
        {
            const label from = forwards ? pair.first : pair.second;
            const label to = forwards ? pair.second : pair.first;
            repeatUntilStable
            (
                "adding points to cyclic sides", most,
                [&]() { return aligner.addImages(from, to); }
            );
        }

        const Map<label> images(imagesOnBorder(wall, pair, tolerance));
        forAllConstIters(images, iter)
        {
            wall.points[iter.val()] = pair.toSecond(wall.points[iter.key()]);
        }
    }

    return done;
}

} // End namespace Foam

// ************************************************************************* //
