/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "criticalPoints.H"
#include "disjointSets.H"
#include "DynamicList.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Parts of the link of a point with smaller, and with larger values
struct linkParts
{
    label nSmaller = 0;
    label nLarger = 0;
};

} // End anonymous namespace


//- The edges of tetrahedra that are opposite to a point, by positions in a list
//  of their points
static List<labelPair> edgesOfLink
(
    const backgroundMesh& mesh,
    const labelUList& tets,
    const label p,
    DynamicList<label>& link
)
{
    const auto position = [&](const label q)
    {
        const label i = link.find(q);

        if (i < 0)
        {
            link.append(q);
        }

        return i < 0 ? link.size() - 1 : i;
    };

    DynamicList<labelPair> sides;
    for (const label t : tets)
    {
        const tetCell& tet = mesh.tets[t];

        for (label i = 0; i < 6; ++i)
        {
            const edge e(tet.tetEdge(i));

            if (!e.found(p))
            {
                sides.append(labelPair(position(e[0]), position(e[1])));
            }
        }
    }

    return List<labelPair>(std::move(sides));
}


static linkParts partsOfLink
(
    const backgroundMesh& mesh,
    const scalarField& field,
    const labelUList& tets,
    const label p
)
{
    const auto larger = [&](const label q)
    {
        return field[q] > field[p] || (field[q] == field[p] && q > p);
    };

    DynamicList<label> link;
    const List<labelPair> sides(edgesOfLink(mesh, tets, p, link));
    disjointSets parts(link.size());
    for (const labelPair& side : sides)
    {
        if (larger(link[side.first()]) == larger(link[side.second()]))
        {
            parts.join(side.first(), side.second());
        }
    }

    linkParts result;
    forAll(link, i)
    {
        if (parts.find(i) == i)
        {
            ++(larger(link[i]) ? result.nLarger : result.nSmaller);
        }
    }

    return result;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

criticalPoints findCriticalPoints
(
    const backgroundMesh& mesh,
    const scalarField& field
)
{
    labelListList pointTets;
    invertManyToMany(mesh.points.size(), mesh.tets, pointTets);
    DynamicList<label> minima, maxima, saddles;

    forAll(pointTets, p)
    {
        if (mesh.free[p] && pointTets[p].size())
        {
            const linkParts parts(partsOfLink(mesh, field, pointTets[p], p));

            if (parts.nSmaller == 0)
            {
                minima.append(p);
            }
            else if (parts.nLarger == 0)
            {
                maxima.append(p);
            }
            else if (parts.nSmaller > 1 || parts.nLarger > 1)
            {
                saddles.append(p);
            }
        }
    }

    return
    {
        labelList(std::move(minima)),
        labelList(std::move(maxima)),
        labelList(std::move(saddles))
    };
}

} // End namespace Foam

// ************************************************************************* //
