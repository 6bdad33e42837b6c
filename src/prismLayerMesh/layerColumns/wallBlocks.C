/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallBlocks.H"
#include "bitSet.H"
#include "columnLines.H"
#include "limitGradient.H"
#include "ListOps.H"

#include <algorithm>

namespace Foam
{

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


labelList findFieldIslands
(
    const wallUnderShare& under,
    const envelopeRadii& radii,
    const columnTeam& team,
    const islandControls& controls
)
{
    const boolList disturbs(disturbingPoints(under, radii, controls));

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
     || team.points.nWhole(wall.points.size()) <= controls.largeWall
    )
    {
        return blocks;
    }

    const pointField points(team.points.onMaster(wall.points));
    const scalarField radius(team.points.onMaster(radii.radius));
    blocks.isDivided = team.any
    (
        team.isMaster() && hasBlocks(points, radius, controls)
    );
    if (blocks.isDivided)
    {
        const boolList isIn(inIslands(under, radii, team));
        const labelList needed(findIndices(isIn, true));
        blocks.points = divideWall(points, radius, needed, controls);
        broadcast(team, blocks.points);
    }

    return blocks;
}


// * * * * * * * * * * * * * * *  Shared Blocks  * * * * * * * * * * * * * * //

//- Boxes that are the smallest ones around the boxes of all processes.
//  Collective
static List<boundBox> united
(
    const columnTeam& team,
    const List<boundBox>& boxes
)
{
    const List<boundBox> all(team.gather(boxes));

    List<boundBox> result(boxes);
    forAll(all, k)
    {
        boundBox& box = result[k % boxes.size()];
        box.min() = min(box.min(), all[k].min());
        box.max() = max(box.max(), all[k].max());
    }

    return result;
}


//- The labels in the share of own points of a block
static labelList ownPoints(const dividedWall& wall, const labelUList& block)
{
    DynamicList<label> own;
    for (const label whole : block)
    {
        if (wall.team.owner(whole) == wall.team.rank())
        {
            own.append(wall.team.columns.here(whole));
        }
    }

    return labelList(std::move(own));
}


//- How far each block goes beyond its points [m]. Collective
static scalarList reaches(const dividedWall& wall)
{
    scalarList largest(wall.blocks.size(), Zero);
    forAll(largest, i)
    {
        for (const label p : ownPoints(wall, wall.blocks[i]))
        {
            largest[i] = max(largest[i], wall.radii.radius[p]);
        }
    }
    const scalarList all(wall.team.gather(largest));
    forAll(all, k)
    {
        scalar& r = largest[k % largest.size()];
        r = max(r, all[k]);
    }
    for (scalar& r : largest)
    {
        r *= wall.controls.reach;
    }

    return largest;
}


//- The boxes of all that blocks depend on, see makeFieldBlock. Collective
static List<boundBox> boxesOfBlocks(const dividedWall& wall)
{
    const scalarList reach(reaches(wall));
    List<boundBox> boxes(reach.size(), boundBox::invertedBox);
    forAll(boxes, i)
    {
        boxes[i].add
        (
            wall.front.surface.points, ownPoints(wall, wall.blocks[i])
        );
    }
    boxes = united(wall.team, boxes);

    const boolList counted(countedWallFaces(wall.front, wall.team));
    forAll(boxes, i)
    {
        labelList inside(facesIn(wall.wall, widened(boxes[i], reach[i])));
        inplaceSubsetList
        (
            inside, [&](const label facei) { return counted[facei]; }
        );
        boxes[i] = boxOfFaces(wall.wall, inside);
    }
    boxes = united(wall.team, boxes);

    forAll(boxes, i)
    {
        boxes[i] = widened(boxes[i], reach[i]);
    }

    return boxes;
}


//- Labels in the whole front of all further columns, ascending, and the points
//  of the whole wall under them. Collective
static List<labelPair> furtherColumns(const dividedWall& wall)
{
    const labelList& wallPoints = wall.front.wallPoints;
    DynamicList<labelPair> own;
    forAll(wallPoints, c)
    {
        if (wallPoints[c] != c && wall.team.isOwn(c))
        {
            own.append
            (
                labelPair
                (
                    wall.team.wholeColumn(c),
                    wall.team.wholeColumn(wallPoints[c])
                )
            );
        }
    }
    List<labelPair> all(wall.team.gather(own));
    std::sort(all.begin(), all.end());

    return all;
}


//- Values of some columns of the whole front, from their owners. Collective
template<class Type>
static List<Type> valuesOf
(
    const columnTeam& team,
    const labelUList& columns,
    const labelUList& points,
    const UList<Type>& values,
    const label nEach = 1
)
{
    labelList owners(points);
    for (label& p : owners)
    {
        p = team.owner(p);
    }

    return team.columns.at(columns, owners, values, nEach);
}


//- As valuesOf, for a spacing on points of the wall
static layerSpacing spacingOf
(
    const columnTeam& team,
    const labelUList& points,
    const layerSpacing& spacing
)
{
    layerSpacing some;
    some.nLayers = spacing.nLayers;
    some.firstThickness =
        valuesOf(team, points, points, spacing.firstThickness);
    some.ratio = valuesOf(team, points, points, spacing.ratio);
    some.thickness = valuesOf(team, points, points, spacing.thickness);
    some.layersAsked = valuesOf(team, points, points, spacing.layersAsked);
    if (team.any(spacing.given.size()))
    {
        some.given = valuesOf
        (
            team, points, points, spacing.given, spacing.nLayers
        );
    }

    return some;
}


//- The process that makes each of the blocks, the largest first. The master has
//  more in memory than the others: it comes last.
static labelList makersOfBlocks(const dividedWall& wall)
{
    const label n = wall.team.size();
    labelList makers(wall.blocks.size());
    forAll(makers, k)
    {
        makers[k] = n - 1 - k % n;
    }

    return makers;
}


//- The part of the wall for each block of this process. Collective
static List<surfacePart> partsOfBlocks(const dividedWall& wall)
{
    const List<boundBox> boxes(boxesOfBlocks(wall));
    const labelList order(largestFirst(wall.blocks));
    const labelList makers(makersOfBlocks(wall));
    List<partRequest> requests(order.size());
    forAll(order, k)
    {
        requests[k].process = makers[k];
        requests[k].boxes = List<boundBox>(1, boxes[order[k]]);
    }

    return wallPartsInBoxes(wall.front, wall.team, requests);
}


//- Sets the columns on the points of a part
static void setColumns(const UList<labelPair>& further, blockWithWall& block)
{
    block.columns = block.part.points;
    DynamicList<label> points(identity(block.columns.size()));
    for (const labelPair& two : further)
    {
        const label p = findSortedIndex(block.part.points, two.second());
        if (p >= 0)
        {
            block.columns.append(two.first());
            points.append(p);
        }
    }
    block.starts.wallPoints = std::move(points);
}


//- Sets the data of parts from the owners of their points. Collective
static void setData(const dividedWall& wall, List<blockWithWall>& blocks)
{
    const columnTeam& team = wall.team;
    DynamicList<label> points, columns, under;
    for (const blockWithWall& block : blocks)
    {
        points.append(block.part.points);
        columns.append(block.columns);
        under.append
        (
            UIndirectList<label>(block.part.points, block.starts.wallPoints)
        );
    }
    const auto ofPoints = [&](const scalarField& values)
    {
        return scalarField(valuesOf(team, points, points, values));
    };
    const envelopeRadii radii
    {
        ofPoints(wall.radii.wanted), ofPoints(wall.radii.room),
        ofPoints(wall.radii.radius), ofPoints(wall.radii.edgeLengths)
    };
    const layerSpacing spacing(spacingOf(team, points, wall.spacing));
    const vectorField directions
    (
        valuesOf(team, columns, under, wall.front.visibility.axes())
    );

    label nPoints = 0, nColumns = 0;
    for (blockWithWall& block : blocks)
    {
        const label n = block.part.points.size();
        const labelList here(identity(n, nPoints));
        block.radii = radii.at(here);
        block.starts.spacing = spacing.at
        (
            labelList(UIndirectList<label>(here, block.starts.wallPoints))
        );
        block.starts.directions = SubList<vector>
        (
            directions, block.columns.size(), nColumns
        );
        nPoints += n;
        nColumns += block.columns.size();
    }
}


List<blockWithWall> blocksOfProcess(const dividedWall& wall)
{
    const List<labelPair> further(furtherColumns(wall));
    List<surfacePart> parts(partsOfBlocks(wall));
    const labelList own(findIndices(makersOfBlocks(wall), wall.team.rank()));
    const labelList labels
    (
        UIndirectList<label>(largestFirst(wall.blocks), own)
    );

    List<blockWithWall> blocks(labels.size());
    forAll(blocks, i)
    {
        blocks[i].blocki = labels[i];
        blocks[i].part = std::move(parts[i]);
        setColumns(further, blocks[i]);
    }
    setData(wall, blocks);

    return blocks;
}

} // End namespace Foam

// ************************************************************************* //
