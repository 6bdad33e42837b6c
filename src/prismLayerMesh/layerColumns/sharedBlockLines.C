/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sharedBlocks.H"
#include "blockLines.H"
#include "returnMemory.H"
#include "stageProgress.H"

#include <atomic>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Reasons of the blocks of all processes
static blockFailures failuresOfAll
(
    const blockFailures& own,
    const columnTeam& team
)
{
    message reasons;
    forAll(own, i)
    {
        if (own[i].size())
        {
            reasons.addValue(i);
            reasons.addText(own[i]);
        }
    }

    blockFailures all(own.size());
    for (const message& m : team.exchange(List<message>(team.size(), reasons)))
    {
        messageReader reader(m);
        while (!reader.atEnd())
        {
            const label i = reader.value<label>();
            all[i] = reader.text();
        }
    }

    return all;
}


//- Adds lines to the messages for the owners of their columns.
//  points: points of the whole wall under the columns
static void addForOwners
(
    const columnTeam& team,
    const labelUList& columns,
    const labelUList& points,
    const columnLines& lines,
    List<message>& toOwners
)
{
    const label n = lines.lines.nSamples;
    forAll(columns, i)
    {
        message& toOwner = toOwners[team.owner(points[i])];
        toOwner.addValue(columns[i]);
        toOwner.addValue(lines.slopes[i]);
        toOwner.addList(SubList<scalar>(lines.lines.energies, n, n*i));
        toOwner.addList(SubList<point>(lines.lines.points, n, n*i));
    }
}


//- Sets the lines of own columns that others and this process have made
static void setFromMakers
(
    const columnTeam& team,
    const List<message>& received,
    columnLines& lines
)
{
    const label n = lines.lines.nSamples;
    for (const message& m : received)
    {
        messageReader reader(m);
        while (!reader.atEnd())
        {
            const label c = team.columnHere(reader.value<label>());
            lines.isSet[c] = true;
            lines.slopes[c] = reader.value<scalar>();
            SubList<scalar>(lines.lines.energies, n, n*c) =
                reader.list<scalar>();
            SubList<point>(lines.lines.points, n, n*c) = reader.list<point>();
        }
    }
}


//- Makes the lines of a block, and adds them to the messages for owners
static void makeLines
(
    const sharedWall& wall,
    const blockWithWall& block,
    const fieldControls& controls,
    string& failure,
    List<message>& toOwners
)
{
    const labelList& points = wall.blocks[block.blocki];
    const labelList own(block.part.localPoints(points));
    const columnLines lines
    (
        linesOfBlock
        (
            dividedWall
            {
                block.part.wall, block.radii, labelListList(1, own),
                wall.controls, wall.mesh, wall.maxStretch
            },
            block.starts, own, controls, failure
        )
    );

    const label nPoints = block.part.points.size();
    const labelList local(block.starts.columnsOn(own, nPoints));
    const labelList columns(UIndirectList<label>(block.columns, local));
    labelList under(UIndirectList<label>(block.starts.wallPoints, local));
    inplaceRenumber(block.part.points, under);

    #pragma omp critical
    addForOwners(wall.team, columns, under, lines, toOwners);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

columnLines makeColumnLines
(
    const sharedWall& wall,
    const fieldControls& controls,
    string& failure
)
{
    const columnTeam& team = wall.team;
    List<message> toOwners(team.size());
    blockFailures failures(wall.blocks.size());
    {
        const List<blockWithWall> blocks(blocksOfProcess(wall));

        // Child processes begin with all memory of this one
        returnMemory();
        std::atomic<label> nMade(0);
        #pragma omp parallel for schedule(dynamic, 1)
        forAll(blocks, i)
        {
            makeLines
            (
                wall, blocks[i], controls, failures[blocks[i].blocki],
                toOwners
            );
            tellProgress("blocks of the field", ++nMade, blocks.size());
        }
    }

    columnLines lines
    (
        noLines(wall.front.wallPoints.size(), wall.spacing.nLayers)
    );
    setFromMakers(team, team.exchange(toOwners), lines);
    failure = summary(wall.blocks, failuresOfAll(failures, team));

    return lines;
}

} // End namespace Foam

// ************************************************************************* //
