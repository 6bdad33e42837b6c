/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ranges.H"
#include "refineSurface.H"
#include "farFieldMeshControls.H"
#include "EdgeMap.H"
#include "ListOps.H"
#include "mathematicalConstants.H"
#include "stageProgress.H"
#include "triPointRef.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void flipEdges(wallSurface& surface, const bool inPlane)
{
    repeatUntilStable
    (
        "flipping edges of triangles", farFieldTuned.maxSweeps,
        [&]() { return flipOnce(surface, inPlane); }
    );
}


void smoothPoints
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

} // End namespace Foam

// ************************************************************************* //
