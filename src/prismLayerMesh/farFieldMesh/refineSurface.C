/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "refineSurface.H"
#include "improveTriangles.H"
#include "DynamicList.H"
#include "EdgeMap.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Lengths of edges over the size, at most: halves are 2/3 of it, so that they
//  are around it
static const scalar maxLength = 4.0/3;


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
        flipEdges(surface, !project);

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

    // Not before each division: that would not come to an end
    smoothPoints(surface, project);
}


// ************************************************************************* //
