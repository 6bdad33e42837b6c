/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "slitEdges.H"
#include "splitTets.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Finds the points that split edges
class slitCrossings
{
    const wallSearch& search_;
    const backgroundMesh& mesh_;

    //- The projections on the wall, made where they are needed
    mutable Map<wallSearch::foot> feet_;

    const wallSearch::foot& footOf(const label p) const
    {
        if (!feet_.found(p))
        {
            feet_.insert(p, search_.footOf(mesh_.points[p]));
        }

        return feet_[p];
    }

    bool inside(const label p) const
    {
        return mesh_.onWall(p) || mesh_.free[p];
    }

public:

    slitCrossings(const wallSearch& search, const backgroundMesh& mesh)
    :
        search_(search),
        mesh_(mesh)
    {}

    scalar gap(const label a, const label b) const
    {
        return min(mesh_.gaps[a], mesh_.gaps[b]);
    }

    //- Whether the edge from a to b crosses a slit; if so, where
    bool crosses(const label a, const label b, point& x) const
    {
        const vector ab = mesh_.points[b] - mesh_.points[a];

        // From side to side it is two gaps, less what both are away from them
        if (!inside(a) || !inside(b) || mag(ab) < 0.5*gap(a, b))
        {
            return false;
        }

        const wallSearch::foot& footA = footOf(a);
        const wallSearch::foot& footB = footOf(b);

        if ((footA.normal & footB.normal) > clearanceControls::oppositeFrom)
        {
            return false;
        }

        // Distances to both sides change linearly, and are equal in the middle
        const scalar least = domainControls::leastPart*gap(a, b);
        const scalar fromA = max(gap(a, b) - footA.distance, least);
        const scalar fromB = max(gap(a, b) - footB.distance, least);
        x = mesh_.points[a] + fromA/(fromA + fromB)*ab;

        return !search_.nearer(x, domainControls::bridgeShare*gap(a, b));
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

label splitSlitEdges(const wallSearch& search, backgroundMesh& mesh)
{
    const slitCrossings crossings(search, mesh);
    simplexSet edges;
    point x;

    for (const tetCell& tet : mesh.tets)
    {
        for (label i = 0; i < 6; ++i)
        {
            const edge e(tet.tetEdge(i));

            if (crossings.crosses(min(e[0], e[1]), max(e[0], e[1]), x))
            {
                edges.append(sortedSimplex(-1, e[0], e[1]));
            }
        }
    }
    edges.sort();

    DynamicList<point> points;
    DynamicList<scalar> gaps;
    for (const simplex& s : edges.simplices())
    {
        crossings.crosses(s[1], s[2], x);
        points.append(x);
        gaps.append(crossings.gap(s[1], s[2]));
    }

    splitTets(edges, mesh.points.size(), mesh.tets);
    mesh.points.append(points);
    mesh.gaps.append(gaps);
    mesh.free.append(boolList(points.size(), false));

    return points.size();
}

} // End namespace Foam

// ************************************************************************* //
