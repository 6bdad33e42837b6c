/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnLines.H"
#include "bitSet.H"
#include "diffusionTensor.H"
#include "harmonicField.H"
#include "isolatedProcess.H"
#include "ListOps.H"
#include "Map.H"
#include "returnMemory.H"
#include "stageProgress.H"
#include "throwingErrors.H"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace Foam
{

//- Why each of the blocks has no field; empty if it has one
typedef List<string> blockFailures;


namespace
{

//- A wall, or the part of one that a block depends on
struct blockGround
{
    const wallSurface& wall;
    const envelopeRadii& radii;
    const columnStarts& starts;
    const dividedWall& how;

    //- The points that need a field
    labelList needed;
};

} // End anonymous namespace


//- Lines of so many columns, none of which is set. Memory is not touched before
//  they are set: a child process begins with all touched memory.
static columnLines noLines(const label nColumns, const label nSamples)
{
    return columnLines
    {
        gradientLines
        {
            nSamples, pointField(nColumns*nSamples),
            scalarField(nColumns*nSamples)
        },
        scalarField(nColumns), boolList(nColumns, false)
    };
}


//- The lines of the first nColumns columns of a block
static columnLines makeLines
(
    const blockGround& ground,
    const labelList& own,
    const label nColumns,
    const fieldControls& controls
)
{
    const columnStarts& all = ground.starts;
    const fieldBlock block
    (
        makeFieldBlock
        (
            ground.wall, ground.radii, own, ground.needed,
            ground.how.controls, ground.how.mesh, ground.how.maxStretch
        )
    );
    const backgroundMesh mesh(makeBackgroundMesh(block));
    const monotoneField field
    (
        makeMonotoneField(mesh, cotangentWeights(mesh), controls)
    );

    const label nPoints = ground.wall.points.size();
    const labelList columns(all.columnsOn(block.points, nPoints));
    labelList points(UIndirectList<label>(all.wallPoints, columns));
    inplaceRenumber(invert(nPoints, block.points), points);
    const columnLines made
    (
        makeColumnLines
        (
            mesh, field.values,
            columnStarts
            {
                points, vectorField(all.directions, columns),
                all.spacing.at(columns)
            }
        )
    );

    columnLines first(noLines(nColumns, all.spacing.nLayers));
    const label n = nColumns*all.spacing.nLayers;
    first.slopes = SubList<scalar>(made.slopes, nColumns);
    first.lines.energies = SubList<scalar>(made.lines.energies, n);
    first.lines.points = SubList<point>(made.lines.points, n);

    return first;
}


static columnLines straightLines
(
    const wallSurface& wall,
    const columnStarts& starts,
    const labelUList& columns
)
{
    const labelList points(UIndirectList<label>(starts.wallPoints, columns));

    return columnLines
    {
        makeStraightLines
        (
            pointField(wall.points, points),
            vectorField(starts.directions, columns),
            requestedHeights(starts.spacing.at(columns))
        ),
        scalarField(columns.size(), 0), boolList(columns.size(), true)
    };
}


//- The lines of the columns on the points of a block, in their order. The block
//  is made in a process of its own. If it fails, the lines are straight, their
//  slopes are 0, and failure says why. Several threads may call this.
static columnLines linesOfBlock
(
    const blockGround& ground,
    const labelList& own,
    const fieldControls& controls,
    string& failure
)
{
    const columnStarts& starts = ground.starts;
    const labelList columns(starts.columnsOn(own, ground.wall.points.size()));
    const label nColumns = columns.size();
    columnLines lines(noLines(nColumns, starts.spacing.nLayers));
    failure.clear();

    const auto work = [&](pipeWriter& out)
    {
        const throwingErrors throwing;
        string reason;
        columnLines made;
        try
        {
            made = makeLines(ground, own, nColumns, controls);
            if (!std::isfinite(sum(made.slopes) + sum(mag(made.lines.points))))
            {
                reason = "its lines are not finite";
            }
        }
        catch (const Foam::error& e)
        {
            reason = e.message();
        }
        out(reason, made.slopes, made.lines.energies, made.lines.points);
    };
    const auto receive = [&](pipeReader& in)
    {
        in(failure, lines.slopes, lines.lines.energies, lines.lines.points);
    };

    if (isolatedProcess(work, receive) != processEnd::complete)
    {
        failure = "the process that made it crashed";
    }
    lines.isSet = true;

    return failure.empty()
      ? lines : straightLines(ground.wall, starts, columns);
}


//- Sets the lines of some columns
static void setLines
(
    const labelUList& columns,
    const columnLines& some,
    columnLines& lines
)
{
    const label n = lines.lines.nSamples;
    forAll(columns, i)
    {
        const label c = columns[i];
        lines.isSet[c] = true;
        lines.slopes[c] = some.slopes[i];
        SubList<scalar>(lines.lines.energies, n, n*c) =
            SubList<scalar>(some.lines.energies, n, n*i);
        SubList<point>(lines.lines.points, n, n*c) =
            SubList<point>(some.lines.points, n, n*i);
    }
}


//- The number of blocks that failed, the number of their points, and the first
//  reason; empty if none did
static string summary(const labelListList& parts, const blockFailures& failures)
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
            reasons(i, own[i]);
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
        toOwner
        (
            columns[i], lines.slopes[i],
            SubList<scalar>(lines.lines.energies, n, n*i),
            SubList<point>(lines.lines.points, n, n*i)
        );
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
            const label c = team.columns.here(reader.value<label>());
            lines.isSet[c] = true;
            lines.slopes[c] = reader.value<scalar>();
            SubList<scalar>(lines.lines.energies, n, n*c) =
                reader.list<scalar>();
            SubList<point>(lines.lines.points, n, n*c) = reader.list<point>();
        }
    }
}


//- The points of all blocks, in the whole wall
static bitSet pointsOfBlocks(const dividedWall& wall)
{
    bitSet points;
    for (const labelList& block : wall.blocks)
    {
        points.set(block);
    }

    return points;
}


//- Makes n blocks, as many at once as there are threads
template<class Make>
static void makeBlocks(const label n, const Make& make)
{
    // Child processes begin with all memory of this one
    returnMemory();
    std::atomic<label> nMade(0);
    #pragma omp parallel for schedule(dynamic, 1)
    for (label i = 0; i < n; ++i)
    {
        make(i);
        tellProgress("blocks of the field", ++nMade, n);
    }
}


//- The lines of all blocks of the wall of the only process
static void setLinesOfAll
(
    const dividedWall& wall,
    const fieldControls& controls,
    blockFailures& failures,
    columnLines& lines
)
{
    const labelList& wallPoints = wall.front.wallPoints;
    const columnStarts starts
    {
        wallPoints, wall.front.visibility.axes(), wall.spacing.at(wallPoints)
    };
    const blockGround ground
    {
        wall.wall, wall.radii, starts, wall, pointsOfBlocks(wall).toc()
    };
    const labelList order(largestFirst(wall.blocks));
    makeBlocks(order.size(), [&](const label k)
    {
        const labelList& own = wall.blocks[order[k]];
        setLines
        (
            starts.columnsOn(own, wall.wall.points.size()),
            linesOfBlock(ground, own, controls, failures[order[k]]),
            lines
        );
    });
}


//- The lines of own columns, in blocks that all processes make. Collective
static void setLinesOfShare
(
    const dividedWall& wall,
    const fieldControls& controls,
    blockFailures& failures,
    columnLines& lines
)
{
    List<message> toOwners(wall.team.size());
    const bitSet needed(pointsOfBlocks(wall));
    {
        const List<blockWithWall> blocks(blocksOfProcess(wall));
        makeBlocks(blocks.size(), [&](const label i)
        {
            const blockWithWall& block = blocks[i];
            const wallSurface& part = block.part.surface;
            const labelList own
            (
                block.part.localPoints(wall.blocks[block.blocki])
            );
            const blockGround ground
            {
                part, block.radii, block.starts, wall,
                subsetList
                (
                    identity(part.points.size()),
                    [&](const label p)
                    {
                        return needed.test(block.part.points[p]);
                    }
                )
            };
            const columnLines made
            (
                linesOfBlock
                (
                    ground, own, controls, failures[block.blocki]
                )
            );

            const labelList local
            (
                block.starts.columnsOn(own, part.points.size())
            );
            const labelList columns(UIndirectList<label>(block.columns, local));
            labelList points
            (
                UIndirectList<label>(block.starts.wallPoints, local)
            );
            inplaceRenumber(block.part.points, points);

            #pragma omp critical
            addForOwners(wall.team, columns, points, made, toOwners);
        });
    }
    setFromMakers(wall.team, wall.team.exchange(toOwners), lines);
}


labelList largestFirst(const labelListList& parts)
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

    return order;
}


columnLines makeColumnLines
(
    const dividedWall& wall,
    const fieldControls& controls,
    string& failure
)
{
    columnLines lines
    (
        noLines(wall.front.wallPoints.size(), wall.spacing.nLayers)
    );
    blockFailures failures(wall.blocks.size());
    if (wall.team.isAlone())
    {
        setLinesOfAll(wall, controls, failures, lines);
    }
    else
    {
        setLinesOfShare(wall, controls, failures, lines);
    }
    failure = summary(wall.blocks, failuresOfAll(failures, wall.team));

    return lines;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelList columnStarts::columnsOn
(
    const labelUList& points,
    const label nWallPoints
) const
{
    Map<DynamicList<label>> further;
    for (label c = nWallPoints; c < wallPoints.size(); ++c)
    {
        further(wallPoints[c]).append(c);
    }

    DynamicList<label> columns(points.size());
    for (const label p : points)
    {
        columns.append(p);
        if (further.found(p))
        {
            columns.append(further[p]);
        }
    }

    return labelList(std::move(columns));
}


columnLines makeColumnLines
(
    const backgroundMesh& mesh,
    const scalarField& isotropic,
    const columnStarts& starts,
    const linesFor use
)
{
    return columnLines
    {
        makeGradientLines
        (
            mesh, isotropic, starts.wallPoints, starts.directions,
            requestedHeights(starts.spacing), use
        ),
        scalarField(mag(scaledGradients(mesh, isotropic)), starts.wallPoints),
        boolList(starts.wallPoints.size(), true)
    };
}

} // End namespace Foam

// ************************************************************************* //
