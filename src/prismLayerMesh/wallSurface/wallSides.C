/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSides.H"
#include "CompactListList.H"
#include "disjointSets.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Visit (low, high, face, up) of every side
template<class Visitor>
static void visitSides(const faceList& faces, const Visitor& visit)
{
    forAll(faces, facei)
    {
        const face& f = faces[facei];

        forAll(f, i)
        {
            const label a = f[i];
            const label b = f[f.fcIndex(i)];

            if (a != b)
            {
                visit(wallSide{min(a, b), max(a, b), facei, a < b});
            }
        }
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool hasRepeatedPoint(const face& f)
{
    for (label i = 0; i < f.size(); ++i)
    {
        if (f[i] == f[f.fcIndex(i)])
        {
            return true;
        }
    }

    return false;
}


wallSides makeWallSides(const faceList& faces, const label nPoints)
{
    // A counting sort on low leaves runs of a few sides to be sorted by high
    labelList nSides(nPoints, Zero);
    visitSides(faces, [&](const wallSide& s) { ++nSides[s.low]; });

    CompactListList<wallSide> byLow(nSides);
    List<wallSide>& sides = byLow.m();
    labelList next(SubList<label>(byLow.offsets(), nPoints));
    visitSides(faces, [&](const wallSide& s) { sides[next[s.low]++] = s; });

    DynamicList<label> edgeStarts(sides.size()/2 + 1);

    for (label p = 0; p < nPoints; ++p)
    {
        UList<wallSide> run(byLow[p]);

        std::stable_sort
        (
            run.begin(),
            run.end(),
            [](const wallSide& s, const wallSide& t)
            {
                return s.high < t.high;
            }
        );

        forAll(run, i)
        {
            if (i == 0 || run[i].high != run[i - 1].high)
            {
                edgeStarts.append(byLow.index(p, i));
            }
        }
    }

    edgeStarts.append(sides.size());

    wallSides result;
    result.sides.transfer(sides);
    result.edgeStarts.transfer(edgeStarts);

    return result;
}


label findComponents
(
    const wallSides& sides,
    const label nFaces,
    labelList& componentOfFace,
    const label maxOnEdge
)
{
    disjointSets sets(nFaces);

    for (label e = 0; e < sides.nEdges(); ++e)
    {
        if (sides.on(e).size() > maxOnEdge)
        {
            continue;
        }

        for (const wallSide& s : sides.on(e))
        {
            sets.join(sides.on(e)[0].facei, s.facei);
        }
    }

    componentOfFace.setSize(nFaces);
    label nComponents = 0;

    for (label i = 0; i < nFaces; ++i)
    {
        // The representative of a set is its first member
        const label first = sets.find(i);
        componentOfFace[i] =
            (first == i ? nComponents++ : componentOfFace[first]);
    }

    return nComponents;
}

} // End namespace Foam

// ************************************************************************* //
