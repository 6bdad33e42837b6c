/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "refineSurface.H"
#include "DynamicList.H"
#include "EdgeMap.H"
#include "mathematicalConstants.H"
#include "triPointRef.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Lengths of edges over the size, at most: halves are 2/3 of it, so that they
//  are around it
static const scalar maxLength = 4.0/3;

//- Triangles in a plane: sine of the angle between them, at most
static const scalar flat = 1e-9;

//- Angles opposite to an edge that is flipped: more than 180 degrees together
//  [rad]
static const scalar flipGain = 1e-6;

//- Flips of all triangles before each division, more than it ever takes
static const label maxSweeps = 100;


//- The corner opposite to the longest edge; of equal ones always the same edge,
//  from whichever side
static label longestEdge(const pointField& points, const face& f)
{
    label longest = 0;
    scalar most = -1;
    edge best;

    for (label k = 0; k < 3; ++k)
    {
        edge e(f[(k + 1) % 3], f[(k + 2) % 3]);
        e.sort();
        const scalar length = magSqr(points[e.start()] - points[e.end()]);

        if
        (
            length > most
         || (
                length == most
             && labelPair(e.start(), e.end())
              < labelPair(best.start(), best.end())
            )
        )
        {
            most = length;
            longest = k;
            best = e;
        }
    }

    return longest;
}


static edge edgeOpposite(const face& f, const label k)
{
    return edge(f[(k + 1) % 3], f[(k + 2) % 3]);
}


//- Edges to divide, each with the label of its midpoint
static EdgeMap<label> markEdges
(
    const wallSurface& surface,
    const std::function<scalar(const point&)>& size
)
{
    const pointField& points = surface.points;
    EdgeMap<label> marked;

    for (const face& f : surface.faces)
    {
        for (label k = 0; k < 3; ++k)
        {
            const edge e(edgeOpposite(f, k));

            if (e.mag(points) > maxLength*size(e.centre(points)))
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
            bool divided = false;
            for (label k = 0; k < 3; ++k)
            {
                divided = divided || marked.found(edgeOpposite(f, k));
            }

            more =
                (
                    divided
                 && marked.insert
                    (
                        edgeOpposite(f, longestEdge(points, f)), -1
                    )
                )
             || more;
        }
    }

    return marked;
}


//- A triangle divided at its marked edges, the longest first
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
        const edge e(edgeOpposite(f, k));

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


static scalar angleAt(const point& x, const point& a, const point& b)
{
    return ::atan2(mag((a - x) ^ (b - x)), (a - x) & (b - x));
}


//- Whether triangles (c d b), (d c a) are better than (a b c), (b a d): in
//  the same place, and Delaunay
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
     && (!inPlane || mag(n1 ^ n2) < flat)
     && (m1 & n1) > 0 && (m1 & n2) > 0 && (m2 & n1) > 0 && (m2 & n2) > 0
     && angleAt(points[c], points[a], points[b])
      + angleAt(points[d], points[a], points[b])
      > constant::mathematical::pi + flipGain;
}


//- Flips each edge at most once, and touches each triangle once. Returns
//  whether there were flips.
static bool flipEdges(wallSurface& surface, const bool inPlane)
{
    EdgeMap<labelPair> sides;

    forAll(surface.faces, facei)
    {
        for (label k = 0; k < 3; ++k)
        {
            const edge e(edgeOpposite(surface.faces[facei], k));

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

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::refineSurface
(
    wallSurface& surface,
    const std::function<scalar(const point&)>& size,
    const std::function<point(const point&)>& project
)
{
    for (bool divided = true; divided;)
    {
        for (label i = 0; i < maxSweeps && flipEdges(surface, !project); ++i)
        {}

        EdgeMap<label> marked(markEdges(surface, size));
        divided = marked.size();

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
    }
}


// ************************************************************************* //
