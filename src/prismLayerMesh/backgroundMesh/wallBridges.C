/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "wallBridges.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Points of a simplex in ascending order; an edge has -1 first
typedef FixedList<label, 3> simplex;


static bool before(const simplex& a, const simplex& b)
{
    return std::lexicographical_compare
    (
        a.begin(), a.end(), b.begin(), b.end()
    );
}


static simplex sortedSimplex(const label a, const label b, const label c)
{
    simplex s;
    s[0] = a;
    s[1] = b;
    s[2] = c;
    std::sort(s.begin(), s.end());

    return s;
}


//- A set of simplices in ascending order
class simplexSet
{
    DynamicList<simplex> simplices_;

public:

    void append(const simplex& s)
    {
        simplices_.append(s);
    }

    void sort()
    {
        std::sort(simplices_.begin(), simplices_.end(), before);
        simplices_.setSize
        (
            std::unique(simplices_.begin(), simplices_.end())
          - simplices_.begin()
        );
    }

    //- Position of s, -1 where it is not in the set
    label find(const simplex& s) const
    {
        const auto found = std::lower_bound
        (
            simplices_.begin(), simplices_.end(), s, before
        );

        return found != simplices_.end() && *found == s
          ? found - simplices_.begin() : -1;
    }

    const DynamicList<simplex>& simplices() const
    {
        return simplices_;
    }
};


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


//- Split a tetrahedron at its first bridge, and the parts at theirs. The order
//  of the bridges is the same for all tetrahedra, so a face is split in the
//  same way from both sides.
static void split
(
    const backgroundMesh& mesh,
    const simplexSet& bridges,
    const label firstNewPoint,
    const tetCell& tet,
    DynamicList<tetCell>& parts
)
{
    label first = -1;

    forWallSimplices
    (
        mesh,
        tet,
        [&](const simplex& s)
        {
            const label i = bridges.find(s);
            if (i >= 0 && (first < 0 || i < first))
            {
                first = i;
            }
        }
    );

    if (first < 0)
    {
        parts.append(tet);
        return;
    }

    // One part for each point of the bridge, which the new one replaces there
    for (const label p : bridges.simplices()[first])
    {
        if (p >= 0)
        {
            tetCell part(tet);
            part[tet.find(p)] = firstNewPoint + first;
            split(mesh, bridges, firstNewPoint, part, parts);
        }
    }
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
        point centre(Zero);
        scalar gap = GREAT;
        label n = 0;

        for (const label p : s)
        {
            if (p >= 0)
            {
                centre += mesh.points[p];
                gap = min(gap, mesh.gaps[p]);
                ++n;
            }
        }

        points.append(centre/n);
        gaps.append(gap);
        free.append(n == 3 || (axes[s[1]] & axes[s[2]]) > -0.5);
    }

    mesh.points.append(points);
    mesh.gaps.append(gaps);
    mesh.free.append(free);

    DynamicList<tetCell> tets(mesh.tets.size());
    for (const tetCell& tet : mesh.tets)
    {
        split(mesh, bridges, firstNewPoint, tet, tets);
    }
    mesh.tets.transfer(tets);

    return bridges.simplices().size();
}


// ************************************************************************* //
