/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallTopologyDefects.H"
#include "disjointSets.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static bool haveSamePoints(const face& f, const face& g)
{
    return
        f.size() == g.size()
     && std::is_permutation(f.begin(), f.end(), g.begin());
}


//- For each face its neighbours over edges with two faces, and whether they
//  are oriented otherwise
static List<DynamicList<std::pair<label, bool>>> neighbours
(
    const wallSides& sides,
    const label nFaces
)
{
    List<DynamicList<std::pair<label, bool>>> result(nFaces);

    for (label e = 0; e < sides.nEdges(); ++e)
    {
        const SubList<wallSide> both(sides.on(e));

        if (both.size() == 2)
        {
            const wallSide& s = both[0];
            const wallSide& t = both[1];
            result[s.facei].append({t.facei, s.up == t.up});
            result[t.facei].append({s.facei, s.up == t.up});
        }
    }

    return result;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void findDuplicateFaces
(
    const wallSurface& wall,
    const wallSides& sides,
    defectList& defects
)
{
    bitSet duplicate(wall.faces.size());

    // Duplicates meet at an edge, where the sides are in the order of faces
    for (label e = 0; e < sides.nEdges(); ++e)
    {
        const SubList<wallSide> all(sides.on(e));

        forAll(all, i)
        {
            const label f = all[i].facei;

            for (label j = 0; j < i; ++j)
            {
                const label g = all[j].facei;

                if (f != g && haveSamePoints(wall.faces[f], wall.faces[g]))
                {
                    duplicate.set(f);
                }
            }
        }
    }

    for (const label facei : duplicate)
    {
        defects.addFace(wallDefect::kind::duplicateFace, facei);
    }
}


bool findBadEdges
(
    const wallSides& sides,
    defectList& defects,
    const bool mayBeOpen
)
{
    bool oriented = true;

    for (label e = 0; e < sides.nEdges(); ++e)
    {
        const SubList<wallSide> all(sides.on(e));

        if (all.size() == 1)
        {
            if (!mayBeOpen)
            {
                defects.addEdge(wallDefect::kind::openEdge, all[0]);
            }
        }
        else if (all.size() > 2)
        {
            defects.addEdge(wallDefect::kind::nonManifoldEdge, all[0]);
        }
        else if (all[0].up == all[1].up)
        {
            oriented = false;
        }
    }

    return oriented;
}


namespace
{

//- Where the walk over the faces is
struct faceWalk
{
    bitSet visited, turned, flipped;

    explicit faceWalk(const label nFaces)
    :
        visited(nFaces),
        turned(nFaces),
        flipped(nFaces)
    {}
};

} // End anonymous namespace


//- The faces that are joined to a seed. Marks those that are turned against the
//  seed, and one of each two for which it depends on the way.
template<class Neighbours>
static labelList walkFrom
(
    const label seed,
    const Neighbours& adjacent,
    faceWalk& walk
)
{
    DynamicList<label> component;
    component.append(seed);
    walk.visited.set(seed);

    for (label i = 0; i < component.size(); ++i)
    {
        const label f = component[i];

        for (const auto& next : adjacent[f])
        {
            const bool turn = (walk.turned.test(f) != next.second);

            if (walk.visited.set(next.first))
            {
                walk.turned.set(next.first, turn);
                component.append(next.first);
            }
            else if (walk.turned.test(next.first) != turn)
            {
                walk.flipped.set(max(f, next.first));
            }
        }
    }

    return labelList(std::move(component));
}


bitSet findTurnedFaces(const wallSides& sides, const label nFaces)
{
    const auto adjacent(neighbours(sides, nFaces));
    faceWalk walk(nFaces);

    for (label seed = 0; seed < nFaces; ++seed)
    {
        if (walk.visited.test(seed))
        {
            continue;
        }

        const labelList component(walkFrom(seed, adjacent, walk));
        label nTurned = 0;
        for (const label f : component)
        {
            nTurned += walk.turned.test(f);
        }

        const bool minority = (2*nTurned <= component.size());
        for (const label f : component)
        {
            if (walk.turned.test(f) == minority)
            {
                walk.flipped.set(f);
            }
        }
    }

    return walk.flipped;
}


void findFlippedFaces
(
    const wallSurface& wall,
    const wallSides& sides,
    defectList& defects
)
{
    for (const label facei : findTurnedFaces(sides, wall.faces.size()))
    {
        defects.addFace(wallDefect::kind::flippedFace, facei);
    }
}


labelList countFans(const wallSurface& wall, const wallSides& sides)
{
    labelList starts(wall.faces.size() + 1, Zero);
    forAll(wall.faces, facei)
    {
        starts[facei + 1] = starts[facei] + wall.faces[facei].size();
    }

    disjointSets corners(starts.last());

    for (label e = 0; e < sides.nEdges(); ++e)
    {
        const wallSide& s = sides.on(e)[0];
        const face& f = wall.faces[s.facei];

        for (const wallSide& t : sides.on(e))
        {
            const face& g = wall.faces[t.facei];

            for (const label p : {s.low, s.high})
            {
                corners.join
                (
                    starts[s.facei] + f.find(p),
                    starts[t.facei] + g.find(p)
                );
            }
        }
    }

    labelList nFans(wall.points.size(), Zero);
    forAll(wall.faces, facei)
    {
        const face& f = wall.faces[facei];

        forAll(f, i)
        {
            const label corner = starts[facei] + i;
            nFans[f[i]] += (corners.find(corner) == corner);
        }
    }

    return nFans;
}


void findNonManifoldPoints
(
    const wallSurface& wall,
    const wallSides& sides,
    defectList& defects
)
{
    const labelList nFans(countFans(wall, sides));

    forAll(nFans, p)
    {
        if (nFans[p] > 1)
        {
            defects.add(wallDefect::kind::nonManifoldPoint, p, wall.points[p]);
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
