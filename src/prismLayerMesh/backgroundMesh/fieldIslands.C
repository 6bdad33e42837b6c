/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fieldIslands.H"
#include "bitSet.H"
#include "ListOps.H"

#include <queue>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Whether a point disturbs the field
static boolList disturbingPoints
(
    const wallContext& context,
    const envelopeRadii& radii,
    const islandControls& controls
)
{
    boolList disturbs(radii.radius.size());

    #pragma omp parallel for schedule(static, 256)
    forAll(disturbs, p)
    {
        disturbs[p] = isOnConcaveEdge(context.kinds[p])
         || context.kinds[p] == pointKind::empty
         || radii.radius[p] < sheetControls::limitedShare*radii.wanted[p]
         || context.curvature[p]*radii.radius[p] > controls.curvature;
    }

    return disturbs;
}


//- Lengthens the way that is left at each point to the longest way that its
//  neighbours leave: Dijkstra, the longest first
static void spread(const wallContext& context, scalarField& left)
{
    typedef std::pair<scalar, label> entry;
    std::priority_queue<entry> front;
    forAll(left, p)
    {
        if (left[p] >= 0)
        {
            front.push(entry(left[p], p));
        }
    }

    while (!front.empty())
    {
        const entry longest = front.top();
        front.pop();
        const label p = longest.second;

        if (longest.first < left[p])
        {
            continue;
        }

        for (const label q : context.addressing.pointPoints[p])
        {
            const scalar rest =
                left[p] - mag(context.wall.points[q] - context.wall.points[p]);

            if (rest > left[q] && rest >= 0)
            {
                left[q] = rest;
                front.push(entry(rest, q));
            }
        }
    }
}


//- Lengthens the ways of copies as their owners have. Returns whether any
//  process has lengthened one. Collective
static bool lengthen(const columnTeam& team, scalarField& left)
{
    scalarField shortened(-left);
    const bool changed = team.lowerPointsToOwners(shortened);
    left = -shortened;

    return changed;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList findFieldIslands
(
    const wallContext& context,
    const envelopeRadii& radii,
    const columnTeam& team,
    const islandControls& controls
)
{
    const boolList disturbs
    (
        disturbingPoints(context, radii, controls)
    );
    scalarField left(disturbs.size(), -1);
    forAll(disturbs, p)
    {
        if (disturbs[p])
        {
            left[p] = controls.reach*radii.radius[p];
        }
    }

    do
    {
        spread(context, left);
    }
    while (lengthen(team, left));

    return subsetList
    (
        identity(left.size()), [&](const label p) { return left[p] >= 0; }
    );
}


labelListList partsWith
(
    const labelListList& parts,
    const labelUList& points
)
{
    const bitSet isWanted(points);

    DynamicList<labelList> result;
    for (const labelList& part : parts)
    {
        labelList wanted
        (
            subsetList(part, [&](const label p) { return isWanted.test(p); })
        );
        if (wanted.size())
        {
            result.append(std::move(wanted));
        }
    }

    return labelListList(std::move(result));
}

} // End namespace Foam

// ************************************************************************* //
