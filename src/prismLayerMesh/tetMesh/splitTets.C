/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "splitTets.H"
#include "boolList.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The first of the set among edges and faces of a tetrahedron, or -1; inSet
//  says which points have simplices there
static label firstSimplex
(
    const simplexSet& simplices,
    const boolList& inSet,
    const tetCell& tet
)
{
    label first = -1;

    const auto look = [&](const simplex& s)
    {
        const label i = simplices.find(s);
        first = i >= 0 && (first < 0 || i < first) ? i : first;
    };
    const auto has = [&](const label i)
    {
        return tet[i] < inSet.size() && inSet[tet[i]];
    };

    for (label i = 0; i < 4; ++i)
    {
        for (label j = i + 1; has(i) && j < 4; ++j)
        {
            if (has(j))
            {
                look(sortedSimplex(-1, tet[i], tet[j]));

                for (label k = j + 1; k < 4; ++k)
                {
                    if (has(k))
                    {
                        look(sortedSimplex(tet[i], tet[j], tet[k]));
                    }
                }
            }
        }
    }

    return first;
}


//- Split a tetrahedron at its first simplex, and the parts at theirs. The order
//  of the simplices is the same for all tetrahedra, so a face is split in the
//  same way from both sides.
static void split
(
    const simplexSet& simplices,
    const boolList& inSet,
    const label firstNewPoint,
    const tetCell& tet,
    DynamicList<tetCell>& parts
)
{
    const label first = firstSimplex(simplices, inSet, tet);

    if (first < 0)
    {
        parts.append(tet);
        return;
    }

    // One part for each point of the simplex, which the new one replaces there
    for (const label p : simplices.simplices()[first])
    {
        if (p >= 0)
        {
            tetCell part(tet);
            part[tet.find(p)] = firstNewPoint + first;
            split(simplices, inSet, firstNewPoint, part, parts);
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::simplexSet::sort()
{
    std::sort(simplices_.begin(), simplices_.end(), before);
    simplices_.setSize
    (
        std::unique(simplices_.begin(), simplices_.end()) - simplices_.begin()
    );
}


Foam::label Foam::simplexSet::find(const simplex& s) const
{
    const auto found = std::lower_bound
    (
        simplices_.begin(), simplices_.end(), s, before
    );

    return found != simplices_.end() && *found == s
      ? found - simplices_.begin() : -1;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::simplex Foam::sortedSimplex(const label a, const label b, const label c)
{
    simplex s;
    s[0] = a;
    s[1] = b;
    s[2] = c;
    std::sort(s.begin(), s.end());

    return s;
}


bool Foam::before(const simplex& a, const simplex& b)
{
    return std::lexicographical_compare
    (
        a.begin(), a.end(), b.begin(), b.end()
    );
}


Foam::point Foam::centreOf(const simplex& s, const pointField& points)
{
    point sum(Zero);
    label n = 0;

    for (const label p : s)
    {
        if (p >= 0)
        {
            sum += points[p];
            ++n;
        }
    }

    return sum/n;
}


void Foam::splitTets
(
    const simplexSet& simplices,
    const label firstNewPoint,
    tetCellList& tets
)
{
    boolList inSet(firstNewPoint, false);
    for (const simplex& s : simplices.simplices())
    {
        for (const label p : s)
        {
            if (p >= 0)
            {
                inSet[p] = true;
            }
        }
    }

    DynamicList<tetCell> parts(tets.size());
    for (const tetCell& tet : tets)
    {
        split(simplices, inSet, firstNewPoint, tet, parts);
    }
    tets.transfer(parts);
}


// ************************************************************************* //
