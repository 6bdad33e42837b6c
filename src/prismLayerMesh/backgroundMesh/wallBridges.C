/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallBridges.H"
#include "ranges.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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

} // End namespace Foam

// ************************************************************************* //
