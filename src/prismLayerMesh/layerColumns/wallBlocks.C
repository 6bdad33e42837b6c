/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallBlocks.H"
#include "fieldIslands.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- On the master: whether each point of the whole wall needs a field.
//  Collective
static boolList inIslands
(
    const wallContext& context,
    const envelopeRadii& radii,
    const columnTeam& team
)
{
    boolList isIn(context.wall.points.size(), false);
    UIndirectList<bool>(isIn, findFieldIslands(context, radii, team)) = true;

    return team.pointsOnMaster(isIn);
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

wallBlocks makeWallBlocks
(
    const wallContext& context,
    const envelopeRadii& radii,
    const columnTeam& team
)
{
    const blockControls controls;
    const wallSurface& wall = context.wall;
    wallBlocks blocks;

    if
    (
        wall.border.sides.size()
     || team.nWallPoints(wall.points.size()) <= controls.maxPoints
    )
    {
        return blocks;
    }

    const pointField points(team.pointsOnMaster(wall.points));
    const scalarField radius(team.pointsOnMaster(radii.radius));
    const labelListList parts
    (
        team.isMaster()
      ? divideWall(points, radius, controls) : labelListList()
    );
    blocks.isDivided = team.any(parts.size());
    if (blocks.isDivided)
    {
        const boolList needed(inIslands(context, radii, team));
        blocks.points = partsWith(parts, findIndices(needed, true));
        broadcast(team, blocks.points);
    }

    return blocks;
}

} // End namespace Foam

// ************************************************************************* //
