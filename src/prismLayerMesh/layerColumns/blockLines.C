/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "blockwiseLines.H"
#include "returnMemory.H"
#include "stageProgress.H"

#include <algorithm>
#include <atomic>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The number of parts that failed, with their points, and the first reason;
//  empty if none did
static string summary
(
    const labelListList& parts,
    const List<string>& failures
)
{
    string first;
    label nFailed = 0;
    label nPoints = 0;

    forAll(parts, i)
    {
        if (failures[i].size())
        {
            first = first.empty() ? failures[i] : first;
            nPoints += parts[i].size();
            ++nFailed;
        }
    }

    return nFailed
      ? name(nFailed) + " of " + name(parts.size()) + " blocks of the wall, "
      + name(nPoints) + " points: " + first
      : string();
}


//- Reasons of the blocks of all processes
static List<string> failuresOfAll
(
    const List<string>& own,
    const columnTeam& team
)
{
    if (team.isAlone())
    {
        return own;
    }

    message reasons;
    forAll(own, i)
    {
        if (own[i].size())
        {
            reasons.addValue(i);
            reasons.addText(own[i]);
        }
    }

    List<string> all(own.size());
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


//- The blocks that this process makes, the largest first, so that threads and
//  processes end together
static labelList blocksOfProcess
(
    const labelListList& parts,
    const columnTeam& team
)
{
    labelList order(identity(parts.size()));
    std::stable_sort
    (
        order.begin(),
        order.end(),
        [&](const label i, const label j)
        {
            return parts[i].size() > parts[j].size();
        }
    );

    DynamicList<label> own;
    for (label k = team.rank(); k < order.size(); k += team.size())
    {
        own.append(order[k]);
    }

    return labelList(std::move(own));
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

columnLines makeColumnLines
(
    const dividedWall& wall,
    const columnStarts& starts,
    const fieldControls& controls,
    string& failure,
    const columnTeam& team
)
{
    // Child processes begin with all memory of this one
    returnMemory();
    const label nColumns =
        team.isAlone() ? starts.wallPoints.size() : team.nColumnsHere();
    blockwiseLines lines(wall, starts, controls, nColumns, team);
    List<string> failures(wall.parts.size());
    const labelList order(blocksOfProcess(wall.parts, team));

    std::atomic<label> nMade(0);
    #pragma omp parallel for schedule(dynamic, 1)
    forAll(order, k)
    {
        const labelList& own = wall.parts[order[k]];
        failures[order[k]] = lines.makeIsolated(own);
        if (failures[order[k]].size())
        {
            lines.makeStraight(own);
        }
        tellProgress("blocks of the field", ++nMade, order.size());
    }

    lines.exchange();
    failure = summary(wall.parts, failuresOfAll(failures, team));

    return lines.release();
}

} // End namespace Foam

// ************************************************************************* //
