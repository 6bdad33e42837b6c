/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "wallBridges.H"
#include "splitTets.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Edges and faces of a tetrahedron whose points are all on the wall
template<class Action>
static void forWallSimplices
(
    const backgroundMesh& mesh,
    const tetCell& tet,
    const Action& action
)
{
    for (label i = 0; i < 4; ++i)
    {
        for (label j = i + 1; mesh.onWall(tet[i]) && j < 4; ++j)
        {
            if (mesh.onWall(tet[j]))
            {
                action(sortedSimplex(-1, tet[i], tet[j]));

                for (label k = j + 1; k < 4; ++k)
                {
                    if (mesh.onWall(tet[k]))
                    {
                        action(sortedSimplex(tet[i], tet[j], tet[k]));
                    }
                }
            }
        }
    }
}


//- Edges that bridge, and faces that do while none of their edges does: the
//  others are split with their edges
static simplexSet findBridges
(
    const faceList& wallTriangles,
    const backgroundMesh& mesh
)
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

    simplexSet bridges;
    for (const tetCell& tet : mesh.tets)
    {
        forWallSimplices
        (
            mesh,
            tet,
            [&](const simplex& s)
            {
                const bool onlyFace = s[0] < 0
                 || (
                        wall.find(sortedSimplex(-1, s[0], s[1])) >= 0
                     && wall.find(sortedSimplex(-1, s[1], s[2])) >= 0
                     && wall.find(sortedSimplex(-1, s[0], s[2])) >= 0
                    );

                if (onlyFace && wall.find(s) < 0)
                {
                    bridges.append(s);
                }
            }
        );
    }
    bridges.sort();

    return bridges;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::label Foam::splitWallBridges
(
    const faceList& wallTriangles,
    const vectorField& axes,
    backgroundMesh& mesh
)
{
    const simplexSet bridges(findBridges(wallTriangles, mesh));
    const label firstNewPoint = mesh.points.size();

    DynamicList<point> points;
    DynamicList<scalar> gaps;
    DynamicList<bool> free;

    for (const simplex& s : bridges.simplices())
    {
        scalar gap = GREAT;

        for (const label p : s)
        {
            if (p >= 0)
            {
                gap = min(gap, mesh.gaps[p]);
            }
        }

        points.append(centreOf(s, mesh.points));
        gaps.append(gap);
        free.append(s[0] >= 0 || (axes[s[1]] & axes[s[2]]) > -0.5);
    }

    splitTets(bridges, firstNewPoint, mesh.tets);
    mesh.points.append(points);
    mesh.gaps.append(gaps);
    mesh.free.append(free);

    return bridges.simplices().size();
}


// ************************************************************************* //
