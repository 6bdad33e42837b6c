/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "slitEdges.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The edges inside of the envelope whose ends are nearest to faces that are
//  opposite to each other. The feet of these ends are in feet on return.
static simplexSet oppositeEdges
(
    const wallSearch& search,
    const backgroundMesh& mesh,
    Map<wallSearch::foot>& feet
)
{
    const auto direction = [&](const label p)
    {
        if (!feet.found(p))
        {
            feet.insert(p, search.footOf(mesh.points[p]));
        }

        return feet[p].direction;
    };
    simplexSet edges;

    for (const tetCell& tet : mesh.tets)
    {
        for (label i = 0; i < 6; ++i)
        {
            const edge e(tet.tetEdge(i));
            const label a = e[0], b = e[1];

            // From side to side it is two gaps, less what both ends are away
            if
            (
                mesh.inside(a) && mesh.inside(b)
             && e.mag(mesh.points) >= 0.5*min(mesh.gaps[a], mesh.gaps[b])
             && (direction(a) & direction(b)) <= domainControls::slitCosine
            )
            {
                edges.append(sortedSimplex(-1, a, b));
            }
        }
    }
    edges.sort();

    return edges;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

label splitSlitEdges(const wallSearch& search, backgroundMesh& mesh)
{
    Map<wallSearch::foot> feet;
    const simplexSet candidates(oppositeEdges(search, mesh, feet));
    simplexSet edges;
    DynamicList<point> points;
    DynamicList<scalar> gaps;

    for (const simplex& s : candidates.simplices())
    {
        // Distances to both sides change linearly, and are equal in the middle
        const scalar gap = mesh.gap(s);
        const scalar least = domainControls::leastPart*gap;
        const scalar fromA = max(gap - feet[s[1]].distance, least);
        const scalar fromB = max(gap - feet[s[2]].distance, least);
        const vector ab = mesh.points[s[2]] - mesh.points[s[1]];
        const point x = mesh.points[s[1]] + fromA/(fromA + fromB)*ab;

        if (!search.nearer(x, domainControls::bridgeShare*gap))
        {
            edges.append(s);
            points.append(x);
            gaps.append(gap);
        }
    }
    edges.sort();

    splitAt(edges, points, gaps, boolList(points.size(), false), mesh);

    return points.size();
}

} // End namespace Foam

// ************************************************************************* //
