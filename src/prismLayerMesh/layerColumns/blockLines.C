/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnLines.H"
#include "isolatedProcess.H"
#include "ListOps.H"
#include "monotoneField.H"
#include "returnMemory.H"
#include "stageProgress.H"
#include "throwingErrors.H"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The lines of the blocks, and how they come from their processes
class blockwiseLines
{
    const dividedWall& wall_;
    const columnStarts& starts_;
    const fieldControls& controls_;

    //- Columns at each point of the wall
    labelListList columns_;

    //- Not set before a block is: a child process begins with all memory that
    //  was set
    columnLines made_;

    labelList columnsAt(const labelUList& points) const;

    //- The lines of the columns of a block, and of others around them
    columnLines makeBlock(const labelList& own) const;

    //- Write, and read, those of the columns of a block
    void write(const columnLines& lines, label nColumns, std::FILE* out) const;
    bool read(const labelUList& columns, std::FILE* in);

    //- Sets the lines of columns
    void set(const labelUList& columns, const columnLines& lines);

public:

    blockwiseLines
    (
        const dividedWall& wall,
        const columnStarts& starts,
        const fieldControls& controls
    );

    //- Make a block in a process of its own. Returns the reason why there is
    //  none, empty if there is one.
    string makeIsolated(const labelList& own);

    //- Makes the lines of a block straight
    void makeStraight(const labelList& own);

    columnLines release() { return std::move(made_); }
};


blockwiseLines::blockwiseLines
(
    const dividedWall& wall,
    const columnStarts& starts,
    const fieldControls& controls
)
:
    wall_(wall),
    starts_(starts),
    controls_(controls),
    columns_
    (
        invertOneToMany(wall.context.wall.points.size(), starts.wallPoints)
    ),
    made_
    {
        gradientLines
        {
            starts.nSamples(), pointField(starts.arcLengths.size()),
            scalarField(starts.arcLengths.size())
        },
        scalarField(starts.wallPoints.size())
    }
{}


labelList blockwiseLines::columnsAt(const labelUList& points) const
{
    DynamicList<label> columns(points.size());
    for (const label p : points)
    {
        columns.append(columns_[p]);
    }

    return labelList(std::move(columns));
}


columnLines blockwiseLines::makeBlock(const labelList& own) const
{
    const fieldBlock block
    (
        makeFieldBlock
        (
            wall_.context.wall, wall_.context.addressing, wall_.envelope, own,
            wall_.controls
        )
    );
    const backgroundMesh mesh
    (
        makeBackgroundMesh(block, wall_.context.search())
    );
    const monotoneField field
    (
        makeMonotoneField(mesh, cotangentWeights(mesh), controls_)
    );

    const labelList columns(columnsAt(block.points));
    const labelList local(invert(columns_.size(), block.points));
    const label n = starts_.nSamples();
    columnStarts starts;
    starts.wallPoints.setSize(columns.size());
    starts.directions = vectorField(starts_.directions, columns);
    starts.arcLengths.setSize(n*columns.size());
    forAll(columns, i)
    {
        starts.wallPoints[i] = local[starts_.wallPoints[columns[i]]];
        SubList<scalar>(starts.arcLengths, n, n*i) =
            SubList<scalar>(starts_.arcLengths, n, n*columns[i]);
    }

    return makeColumnLines(mesh, field.values, starts);
}


void blockwiseLines::write
(
    const columnLines& made,
    const label nColumns,
    std::FILE* out
) const
{
    const size_t n = nColumns*starts_.nSamples();
    std::fwrite(made.slopes.cdata(), sizeof(scalar), nColumns, out);
    std::fwrite(made.lines.energies.cdata(), sizeof(scalar), n, out);
    std::fwrite(made.lines.points.cdata(), sizeof(point), n, out);
}


bool blockwiseLines::read(const labelUList& columns, std::FILE* in)
{
    const label n = starts_.nSamples();
    columnLines lines;
    lines.slopes.setSize(columns.size());
    lines.lines.energies.setSize(n*columns.size());
    lines.lines.points.setSize(n*columns.size());
    const auto take = [&](auto& values)
    {
        return std::fread
        (
            values.data(), sizeof(values[0]), values.size(), in
        ) == size_t(values.size());
    };

    if
    (
        !take(lines.slopes)
     || !take(lines.lines.energies) || !take(lines.lines.points)
    )
    {
        return false;
    }
    set(columns, lines);

    return true;
}


void blockwiseLines::set(const labelUList& columns, const columnLines& lines)
{
    const label n = starts_.nSamples();

    forAll(columns, i)
    {
        const label c = columns[i];
        made_.slopes[c] = lines.slopes[i];
        SubList<scalar>(made_.lines.energies, n, n*c) =
            SubList<scalar>(lines.lines.energies, n, n*i);
        SubList<point>(made_.lines.points, n, n*c) =
            SubList<point>(lines.lines.points, n, n*i);
    }
}


void blockwiseLines::makeStraight(const labelList& own)
{
    const label n = starts_.nSamples();
    const labelList columns(columnsAt(own));
    scalarField arcLengths(n*columns.size());
    forAll(columns, i)
    {
        SubList<scalar>(arcLengths, n, n*i) =
            SubList<scalar>(starts_.arcLengths, n, n*columns[i]);
    }

    const labelList points
    (
        UIndirectList<label>(starts_.wallPoints, columns)
    );
    const columnLines straight
    {
        makeStraightLines
        (
            pointField(wall_.context.wall.points, points),
            vectorField(starts_.directions, columns), arcLengths
        ),
        scalarField(columns.size(), 0)
    };
    set(columns, straight);
}


string blockwiseLines::makeIsolated(const labelList& own)
{
    const labelList columns(columnsAt(own));
    string failure;

    // First the length of the reason why there are no lines, then what there is
    const auto work = [&](std::FILE* out)
    {
        const throwingErrors throwing;
        string reason;
        columnLines made;
        try
        {
            made = makeBlock(own);
            if (!std::isfinite(sum(made.slopes) + sum(mag(made.lines.points))))
            {
                reason = "its lines are not finite";
            }
        }
        catch (const Foam::error& e)
        {
            reason = e.message();
        }

        const size_t length = reason.size();
        std::fwrite(&length, sizeof(length), 1, out);
        std::fwrite(reason.data(), 1, length, out);
        if (reason.empty())
        {
            write(made, columns.size(), out);
        }
    };
    const auto receive = [&](std::FILE* in)
    {
        size_t length = 0;
        if (std::fread(&length, sizeof(length), 1, in) != 1)
        {
            return false;
        }
        failure.resize(length);

        return std::fread(&failure[0], 1, length, in) == length
            && (length > 0 || read(columns, in));
    };

    return isolatedProcess(work, receive) == processEnd::complete
      ? failure : string("the process that made it crashed");
}

} // End anonymous namespace


//- The number of parts that failed, with their points, and the first reason;
//  empty if none did
static string summary(const labelListList& parts, const UList<string>& failures)
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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

columnLines makeColumnLines
(
    const dividedWall& wall,
    const columnStarts& starts,
    const fieldControls& controls,
    string& failure
)
{
    // Child processes begin with all memory of this one
    returnMemory();
    blockwiseLines lines(wall, starts, controls);
    List<string> failures(wall.parts.size());

    // The largest first, so that threads end together
    labelList order(identity(wall.parts.size()));
    std::stable_sort
    (
        order.begin(),
        order.end(),
        [&](const label i, const label j)
        {
            return wall.parts[i].size() > wall.parts[j].size();
        }
    );

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

    failure = summary(wall.parts, failures);

    return lines.release();
}

} // End namespace Foam

// ************************************************************************* //
