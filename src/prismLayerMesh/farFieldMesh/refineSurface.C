/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "refineSurface.H"
#include "DynamicList.H"
#include "edgeCollapser.H"
#include "EdgeMap.H"
#include "farFieldMeshControls.H"
#include "ListOps.H"
#include "mathematicalConstants.H"
#include "ranges.H"
#include "stageProgress.H"
#include "triPointRef.H"

#include <algorithm>
#include <utility>
#include <vector>

namespace Foam
{

//- The longest edge that is not kept; of equally long ones the same from both
//  sides
static edge longestEdge
(
    const pointField& points,
    const edgeHashSet& kept,
    const face& f
)
{
    edge longest;
    edge ends;
    scalar most = -1;

    for (const edge& e : f.edges())
    {
        const scalar length = magSqr(points[e.start()] - points[e.end()]);
        edge sorted(e);
        sorted.sort();

        const bool longer = length > most || (length == most && sorted < ends);

        if (longer && !kept.found(e))
        {
            most = length;
            longest = e;
            ends = sorted;
        }
    }

    return longest;
}


//- Floors on the sizes at points: the lengths of the kept edges there, falling
//  with the distance along edges. With none an edge that is kept, if it were
//  much longer than the size, would have its triangle divided without end.
static scalarField keptLengths
(
    const wallSurface& surface,
    const edgeHashSet& kept
)
{
    const pointField& points = surface.points;
    scalarField lengths(points.size(), 0);
    for (const edge& e : kept)
    {
        const scalar length = e.mag(points);
        lengths[e.start()] = max(lengths[e.start()], length);
        lengths[e.end()] = max(lengths[e.end()], length);
    }

    for (bool more = kept.size(); more;)
    {
        more = false;

        for (const face& f : surface.faces)
        {
            for (const edge& e : f.edges())
            {
                const scalar fall = farFieldTuned.keptSlope*e.mag(points);
                scalar& a = lengths[e.start()];
                scalar& b = lengths[e.end()];
                more = more || a < b - fall || b < a - fall;
                a = max(a, b - fall);
                b = max(b, a - fall);
            }
        }
    }

    return lengths;
}


namespace
{

//- The wanted lengths of edges
struct wantedLengths
{
    const pointField& points;
    const std::function<scalar(const point&)>& size;
    const scalarField floors;

    scalar operator()(const edge& e) const
    {
        return max
        (
            size(e.centre(points)), 0.5*(floors[e.start()] + floors[e.end()])
        );
    }
};

} // End anonymous namespace


//- The edges to divide: those that are too long, and the longest edge of each
//  triangle that has one of them (Rivara)
static EdgeMap<label> markEdges
(
    const wallSurface& surface,
    const edgeHashSet& kept,
    const std::function<scalar(const point&)>& size
)
{
    const pointField& points = surface.points;
    const wantedLengths wanted{points, size, keptLengths(surface, kept)};
    EdgeMap<label> marked;

    for (const face& f : surface.faces)
    {
        for (const edge& e : f.edges())
        {
            if
            (
                !kept.found(e)
             && e.mag(points) > farFieldTuned.maxLength*wanted(e)
            )
            {
                marked.insert(e, -1);
            }
        }
    }

    for (bool more = true; more;)
    {
        more = false;

        for (const face& f : surface.faces)
        {
            const bool divided =
                marked.found(f.faceEdge(0))
             || marked.found(f.faceEdge(1))
             || marked.found(f.faceEdge(2));

            more =
                (divided && marked.insert(longestEdge(points, kept, f), -1))
             || more;
        }
    }

    return marked;
}


//- Divides a triangle at its marked edges, the longest first. The marked edges
//  have the labels of their midpoints.
static void divide
(
    const pointField& points,
    const EdgeMap<label>& marked,
    const face& f,
    const label patchi,
    DynamicList<face>& faces,
    DynamicList<label>& patchIDs
)
{
    label first = -1;
    scalar most = -1;

    for (label k = 0; k < 3; ++k)
    {
        const edge e(f.faceEdge((k + 1) % 3));

        if (marked.found(e) && e.mag(points) > most)
        {
            most = e.mag(points);
            first = k;
        }
    }

    if (first < 0)
    {
        faces.append(f);
        patchIDs.append(patchi);
        return;
    }

    const label a = f[first];
    const label b = f[(first + 1) % 3];
    const label c = f[(first + 2) % 3];
    const label middle = marked[edge(b, c)];

    divide(points, marked, face({a, b, middle}), patchi, faces, patchIDs);
    divide(points, marked, face({a, middle, c}), patchi, faces, patchIDs);
}


// * * * * * * * * * * * * * *  Improve Triangles  * * * * * * * * * * * * * //

static scalar angleAt(const point& x, const point& a, const point& b)
{
    return ::atan2(mag((a - x) ^ (b - x)), (a - x) & (b - x));
}


//- Whether the triangles (c d b), (d c a) are in the same place as (a b c),
//  (b a d), and Delaunay
static bool isBetterFlipped
(
    const pointField& points,
    const label a,
    const label b,
    const label c,
    const label d,
    const bool inPlane
)
{
    const vector n1(triPointRef(points[a], points[b], points[c]).unitNormal());
    const vector n2(triPointRef(points[b], points[a], points[d]).unitNormal());
    const vector m1(triPointRef(points[c], points[d], points[b]).areaNormal());
    const vector m2(triPointRef(points[d], points[c], points[a]).areaNormal());

    return
        (n1 & n2) > 0
     && (!inPlane || mag(n1 ^ n2) < farFieldTuned.flat)
     && (m1 & n1) > 0 && (m1 & n2) > 0 && (m2 & n1) > 0 && (m2 & n2) > 0
     && angleAt(points[c], points[a], points[b])
      + angleAt(points[d], points[a], points[b])
      > constant::mathematical::pi + farFieldTuned.flipGain;
}


//- Flips each edge at most once, and touches each triangle once. Returns
//  whether there were flips.
static bool flipOnce(wallSurface& surface, const bool inPlane)
{
    EdgeMap<labelPair> sides;

    forAll(surface.faces, facei)
    {
        for (label k = 0; k < 3; ++k)
        {
            const face& f = surface.faces[facei];
            const edge e(f.faceEdge((k + 1) % 3));

            if (!sides.insert(e, labelPair(3*facei + k, -1)))
            {
                sides[e].second() = 3*facei + k;
            }
        }
    }

    boolList touched(surface.faces.size(), false);
    bool flipped = false;

    forAllConstIters(sides, iter)
    {
        const label i = iter.val().first();
        const label j = iter.val().second();

        if
        (
            j < 0 || touched[i/3] || touched[j/3]
         || surface.patchIDs[i/3] != surface.patchIDs[j/3]
        )
        {
            continue;
        }

        face& f = surface.faces[i/3];
        face& g = surface.faces[j/3];
        const label c = f[i % 3];
        const label a = f[(i + 1) % 3];
        const label b = f[(i + 2) % 3];
        const label d = g[j % 3];

        if
        (
            isBetterFlipped(surface.points, a, b, c, d, inPlane)
         && !sides.found(edge(c, d))
        )
        {
            f = face({c, d, b});
            g = face({d, c, a});
            touched[i/3] = touched[j/3] = flipped = true;
        }
    }

    return flipped;
}


//- Whether triangles are all around each point
static boolList findInner(const wallSurface& surface)
{
    boolList isInner(surface.points.size(), true);
    for (const edge& e : outline(surface.faces))
    {
        isInner[e.start()] = isInner[e.end()] = false;
    }

    return isInner;
}


//- Whether the triangles of each inner point are of one patch, and in a plane
static boolList findFree
(
    const wallSurface& surface,
    const boolList& isInner,
    const bool inPlane
)
{
    boolList isFree(isInner);
    labelList first(surface.points.size(), -1);
    const vectorField normals(surface.faceNormals());

    forAll(surface.faces, facei)
    {
        for (const label p : surface.faces[facei])
        {
            if (first[p] < 0)
            {
                first[p] = facei;
            }

            isFree[p] =
                isFree[p]
             && surface.patchIDs[facei] == surface.patchIDs[first[p]]
             && (
                    !inPlane
                 || mag(normals[facei] ^ normals[first[p]])
                  < farFieldTuned.flat
                );
        }
    }

    return isFree;
}


//- Whether one of the triangles is turned over against its normal
static bool isTurned
(
    const wallSurface& surface,
    const labelUList& faces,
    const UList<vector>& normals
)
{
    return anyOf(faces, [&](const label facei)
    {
        const face& f = surface.faces[facei];

        return (f.areaNormal(surface.points) & normals[facei]) <= 0;
    });
}


//- Moves each free point to the mean of its neighbours, unless that would turn
//  a triangle over
static void smoothOnce
(
    wallSurface& surface,
    const boolList& isInner,
    const std::function<point(const point&)>& project
)
{
    const boolList isFree(findFree(surface, isInner, !project));
    const vectorField normals(surface.faceNormals());
    const labelListList pointFaces
    (
        invertManyToMany<face, labelList>(surface.points.size(), surface.faces)
    );

    forAll(pointFaces, p)
    {
        if (!isFree[p])
        {
            continue;
        }

        const point from(surface.points[p]);
        vector move(Zero);

        // In a plane differences are exact, sums of coordinates are not
        for (const label facei : pointFaces[p])
        {
            for (const label q : surface.faces[facei])
            {
                move += (surface.points[q] - from)/(2*pointFaces[p].size());
            }
        }

        surface.points[p] = project ? project(from + move) : from + move;

        if (isTurned(surface, pointFaces[p], normals))
        {
            surface.points[p] = from;
        }
    }
}


//- Flips edges between triangles of one patch until the triangles are Delaunay.
//  inPlane: flips only edges between triangles in a plane; if false, flips all
//  edges, and the surface must be smooth
static void flipEdges(wallSurface& surface, const bool inPlane)
{
    repeatUntilStable
    (
        "flipping edges of triangles", farFieldTuned.maxSweeps,
        [&]() { return flipOnce(surface, inPlane); }
    );
}


//- Moves points whose triangles are of one patch and in a plane to the mean of
//  their neighbours, and flips edges, several times in turn. Points on an edge
//  with one face stay. If project is not empty it moves a point to a curved
//  surface, and the surface is smooth.
static void smoothPoints
(
    wallSurface& surface,
    const std::function<point(const point&)>& project
)
{
    const boolList isInner(findInner(surface));

    for (label i = 0; i < farFieldTuned.nSmoothings; ++i)
    {
        smoothOnce(surface, isInner, project);
        flipEdges(surface, !project);
    }
}


//- Collapses edges that are much shorter than the wanted lengths, the shortest
//  first, where a point between triangles of one patch in a plane can go.
//  Returns whether there were any.
static bool collapseOnce
(
    wallSurface& surface,
    const std::function<scalar(const point&)>& size,
    const bool inPlane
)
{
    const edgeHashSet kept(outline(surface.faces));
    const wantedLengths wanted
    {
        surface.points, size, keptLengths(surface, kept)
    };
    const boolList isFree(findFree(surface, findInner(surface), inPlane));
    std::vector<std::pair<scalar, labelPair>> shorts;
    for (const face& f : surface.faces)
    {
        for (const edge& e : f.edges())
        {
            const scalar length = e.mag(surface.points);
            if
            (
                isFree[e.start()]
             && length < farFieldTuned.minLength*wanted(e)
            )
            {
                shorts.emplace_back(length, labelPair(e.start(), e.end()));
            }
        }
    }
    std::sort(shorts.begin(), shorts.end());

    edgeCollapser collapser(surface);
    for (const auto& one : shorts)
    {
        collapser.collapse(one.second.first(), one.second.second());
    }

    return collapser.finish();
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void refineSurface
(
    wallSurface& surface,
    const std::function<scalar(const point&)>& size,
    const std::function<point(const point&)>& project
)
{
    const edgeHashSet kept(outline(surface.faces));

    const auto divideOnce = [&]()
    {
        flipEdges(surface, !project);

        EdgeMap<label> marked(markEdges(surface, kept, size));

        DynamicList<point> points(surface.points);
        for (const edge& e : marked.sortedToc())
        {
            const point middle(e.centre(surface.points));
            marked[e] = points.size();
            points.append(project ? project(middle) : middle);
        }

        DynamicList<face> faces(2*surface.faces.size());
        DynamicList<label> patchIDs(2*surface.faces.size());

        forAll(surface.faces, facei)
        {
            divide
            (
                surface.points, marked, surface.faces[facei],
                surface.patchIDs[facei], faces, patchIDs
            );
        }

        surface.points.transfer(points);
        surface.faces.transfer(faces);
        surface.patchIDs.transfer(patchIDs);

        return marked.size() > 0;
    };
    repeatUntilStable
    (
        "dividing long edges", farFieldTuned.maxDivisions, divideOnce
    );

    repeatUntilStable
    (
        "collapsing short edges", farFieldTuned.maxCollapses,
        [&]()
        {
            flipEdges(surface, !project);
            return collapseOnce(surface, size, !project);
        }
    );

    // Not before each division: that would not come to an end
    smoothPoints(surface, project);
}

} // End namespace Foam

// ************************************************************************* //
