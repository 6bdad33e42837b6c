/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "splitTets.H"
#include "boolList.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Returns for each simplex its position in the order in which tetrahedra are
//  split: the shortest edges first, then the faces
static labelList splitOrder
(
    const simplexSet& simplices,
    const pointField& points
)
{
    scalarField lengths(simplices.simplices().size(), GREAT);
    forAll(lengths, i)
    {
        const simplex& s = simplices.simplices()[i];

        if (s[0] < 0)
        {
            lengths[i] = magSqr(points[s[2]] - points[s[1]]);
        }
    }

    return invert(lengths.size(), sortedOrder(lengths));
}


//- Returns the edge or face of a tetrahedron at which it is split first, as its
//  position in the set, or -1. inSet marks the points of the set.
static label firstSimplex
(
    const simplexSet& simplices,
    const labelUList& order,
    const boolList& inSet,
    const tetCell& tet
)
{
    DynamicList<label, 4> p;
    for (const label q : tet)
    {
        if (q < inSet.size() && inSet[q])
        {
            p.append(q);
        }
    }

    label first = -1;
    const auto look = [&](const simplex& s)
    {
        const label i = simplices.find(s);
        first = i >= 0 && (first < 0 || order[i] < order[first]) ? i : first;
    };

    for (label i = 0; i < p.size(); ++i)
    {
        for (label j = 0; j < i; ++j)
        {
            look(sortedSimplex(-1, p[i], p[j]));

            for (label k = 0; k < j; ++k)
            {
                look(sortedSimplex(p[i], p[j], p[k]));
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
    const labelUList& order,
    const boolList& inSet,
    const label firstNewPoint,
    const tetCell& tet,
    DynamicList<tetCell>& parts
)
{
    const label first = firstSimplex(simplices, order, inSet, tet);

    if (first < 0)
    {
        parts.append(tet);
        return;
    }

    DynamicList<tetCell, 4> own;
    appendParts(tet, simplices.simplices()[first], firstNewPoint + first, own);

    for (const tetCell& part : own)
    {
        split(simplices, order, inSet, firstNewPoint, part, parts);
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

simplex sortedSimplex(const label a, const label b, const label c)
{
    simplex s({a, b, c});
    std::sort(s.begin(), s.end());

    return s;
}


point centreOf(const simplex& s, const pointField& points)
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


void splitTets
(
    const simplexSet& simplices,
    const pointField& points,
    const label firstNewPoint,
    tetCellList& tets
)
{
    const labelList order(splitOrder(simplices, points));
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
        split(simplices, order, inSet, firstNewPoint, tet, parts);
    }
    tets.transfer(parts);
}

} // End namespace Foam

// ************************************************************************* //
