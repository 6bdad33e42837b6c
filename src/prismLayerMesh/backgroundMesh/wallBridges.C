/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallBridges.H"
#include "ranges.H"

namespace Foam
{

//- Edges and triangles of the wall
static simplexSet simplicesOf(const faceList& wallTriangles)
{
    simplexSet wall;

    for (const face& f : wallTriangles)
    {
        wall.append(sortedSimplex(f[0], f[1], f[2]));

        for (label i = 0; i < 3; ++i)
        {
            wall.append(sortedSimplex(-1, f[i], f[(i + 1) % 3]));
        }
    }
    wall.sort();

    return wall;
}


//- Edges that bridge, and faces that bridge although none of their edges does:
//  other faces are split with their edges
static simplexSet findBridges
(
    const faceList& wallTriangles,
    const backgroundMesh& mesh
)
{
    const simplexSet wall(simplicesOf(wallTriangles));
    simplexSet bridges;

    const auto isBridge = [&](const label a, const label b)
    {
        return mesh.onWall(a) && mesh.onWall(b)
            && wall.find(sortedSimplex(-1, a, b)) < 0;
    };

    for (const tetCell& tet : mesh.tets)
    {
        for (label i = 0; i < 6; ++i)
        {
            const edge e(tet.tetEdge(i));

            if (isBridge(e[0], e[1]))
            {
                bridges.append(sortedSimplex(-1, e[0], e[1]));
            }
        }

        for (label i = 0; i < 4; ++i)
        {
            const triFace f(tet.face(i));
            const simplex s(sortedSimplex(f[0], f[1], f[2]));

            if
            (
                mesh.onWall(s[2])
             && !isBridge(s[0], s[1])
             && !isBridge(s[1], s[2])
             && !isBridge(s[0], s[2])
             && wall.find(s) < 0
            )
            {
                bridges.append(s);
            }
        }
    }
    bridges.sort();

    return bridges;
}


//- Whether an edge is across the tip of an acute concave edge: its ends have a
//  common neighbour on the wall
static bool isTip
(
    const labelListList& pointPoints,
    const label a,
    const label b
)
{
    return anyOf(pointPoints[a], [&](const label p)
    {
        return pointPoints[b].found(p);
    });
}


label splitWallBridges
(
    const faceList& wallTriangles,
    const labelListList& pointPoints,
    const wallSearch& search,
    backgroundMesh& mesh
)
{
    const simplexSet bridges(findBridges(wallTriangles, mesh));
    DynamicList<point> points;
    DynamicList<scalar> gaps;
    DynamicList<bool> free;
    for (const simplex& s : bridges.simplices())
    {
        const scalar gap = mesh.gap(s);
        points.append(centreOf(s, mesh.points));
        gaps.append(gap);
        free.append
        (
            s[0] >= 0
         || isTip(pointPoints, s[1], s[2])
         || search.nearer(points.last(), domainControls::bridgeShare*gap)
        );
    }

    splitAt(bridges, points, gaps, free, mesh);

    return points.size();
}


// * * * * * * * * * * * * * * *  Slit Edges * * * * * * * * * * * * * * * * //

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
            feet.insert
            (
                p,
                mesh.onWall(p)
              ? wallSearch::foot{{}, {}, 0, Zero}
              : search.footOf(mesh.points[p])
            );
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
