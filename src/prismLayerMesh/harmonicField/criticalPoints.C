/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "criticalPoints.H"
#include "disjointSets.H"
#include "DynamicList.H"
#include "ListOps.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

namespace
{

//- Parts of the link of a point with smaller, and with larger values
struct linkParts
{
    label nSmaller = 0;
    label nLarger = 0;
};

} // End anonymous namespace


static linkParts partsOfLink
(
    const backgroundMesh& mesh,
    const scalarField& field,
    const labelUList& tets,
    const label p
)
{
    // Positions of the link's points
    DynamicList<label> link;
    const auto position = [&](const label q)
    {
        const label i = link.find(q);

        if (i < 0)
        {
            link.append(q);
        }

        return i < 0 ? link.size() - 1 : i;
    };
    const auto larger = [&](const label q)
    {
        return field[q] > field[p] || (field[q] == field[p] && q > p);
    };

    DynamicList<labelPair> sides;
    for (const label t : tets)
    {
        const tetCell& tet = mesh.tets[t];

        for (label i = 0; i < 4; ++i)
        {
            for (label j = i + 1; j < 4; ++j)
            {
                if (tet[i] != p && tet[j] != p)
                {
                    sides.append
                    (
                        labelPair(position(tet[i]), position(tet[j]))
                    );
                }
            }
        }
    }

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

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::criticalPoints Foam::findCriticalPoints
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


// ************************************************************************* //
