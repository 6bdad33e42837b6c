/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "refineSurface.H"
#include "farFieldMeshControls.H"
#include "DynamicList.H"
#include "EdgeMap.H"
#include "stageProgress.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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

        const bool longer =
            length > most || (length == most && sorted < ends);

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
    const scalarField lengths(keptLengths(surface, kept));
    EdgeMap<label> marked;

    for (const face& f : surface.faces)
    {
        for (const edge& e : f.edges())
        {
            const scalar floor = 0.5*(lengths[e.start()] + lengths[e.end()]);

            if
            (
                !kept.found(e)
             && e.mag(points)
              > farFieldTuned.maxLength*max(size(e.centre(points)), floor)
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

    // Not before each division: that would not come to an end
    smoothPoints(surface, project);
}

} // End namespace Foam

// ************************************************************************* //
