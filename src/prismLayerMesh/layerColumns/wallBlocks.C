/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallBlocks.H"
#include "bitSet.H"
#include "limitGradient.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Whether a point disturbs the field
static boolList disturbingPoints
(
    const wallUnderShare& under,
    const envelopeRadii& radii,
    const islandControls& controls
)
{
    boolList disturbs(radii.radius.size());

    #pragma omp parallel for schedule(static, 256)
    forAll(disturbs, p)
    {
        disturbs[p] = isOnConcaveEdge(under.kinds[p])
         || under.kinds[p] == pointKind::empty
         || radii.radius[p] < sheetControls::limitedShare*radii.wanted[p]
         || under.curvature[p]*radii.radius[p] > controls.curvature;
    }

    return disturbs;
}


//- On the master: whether each point of the whole wall needs a field.
//  Collective
static boolList inIslands
(
    const wallUnderShare& under,
    const envelopeRadii& radii,
    const columnTeam& team
)
{
    boolList isIn(under.wall.points.size(), false);
    UIndirectList<bool>(isIn, findFieldIslands(under, radii, team)) = true;

    return team.points.onMaster(isIn);
}


//- Gives the lists of the master to all. Collective
static void broadcast(const columnTeam& team, labelListList& lists)
{
    labelList sizes(lists.size());
    DynamicList<label> items;
    forAll(lists, i)
    {
        sizes[i] = lists[i].size();
        items.append(lists[i]);
    }
    team.broadcast(sizes);
    labelList all(std::move(items));
    team.broadcast(all);

    lists.setSize(sizes.size());
    label start = 0;
    forAll(lists, i)
    {
        lists[i] = SubList<label>(all, sizes[i], start);
        start += sizes[i];
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList findFieldIslands
(
    const wallUnderShare& under,
    const envelopeRadii& radii,
    const columnTeam& team,
    const islandControls& controls
)
{
    const boolList disturbs
    (
        disturbingPoints(under, radii, controls)
    );

    // Ways along the wall from the borders of islands, negative inside
    scalarField beyond(disturbs.size(), VSMALL);
    forAll(disturbs, p)
    {
        if (disturbs[p])
        {
            beyond[p] = -controls.reach*radii.radius[p];
        }
    }

    do
    {
        limitGradient(under.wall, under.addressing, 1, beyond);
    }
    while (team.points.lower(beyond));

    return subsetList
    (
        identity(beyond.size()), [&](const label p) { return beyond[p] <= 0; }
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


wallBlocks makeWallBlocks
(
    const wallUnderShare& under,
    const envelopeRadii& radii,
    const columnTeam& team
)
{
    const blockControls controls;
    const wallSurface& wall = under.wall;
    wallBlocks blocks;

    if
    (
        wall.border.sides.size()
     || team.points.nWhole(wall.points.size()) <= controls.maxPoints
    )
    {
        return blocks;
    }

    const pointField points(team.points.onMaster(wall.points));
    const scalarField radius(team.points.onMaster(radii.radius));
    const labelListList parts
    (
        team.isMaster()
      ? divideWall(points, radius, controls) : labelListList()
    );
    blocks.isDivided = team.any(parts.size());
    if (blocks.isDivided)
    {
        const boolList needed(inIslands(under, radii, team));
        blocks.points = partsWith(parts, findIndices(needed, true));
        broadcast(team, blocks.points);
    }

    return blocks;
}

} // End namespace Foam

// ************************************************************************* //
