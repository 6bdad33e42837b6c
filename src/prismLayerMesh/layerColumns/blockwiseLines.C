/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "blockwiseLines.H"
#include "isolatedProcess.H"
#include "ListOps.H"
#include "monotoneField.H"
#include "throwingErrors.H"

#include <cmath>

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

blockwiseLines::blockwiseLines
(
    const dividedWall& wall,
    const columnStarts& starts,
    const fieldControls& controls,
    const label nColumns,
    const columnTeam& team
)
:
    wall_(wall),
    starts_(starts),
    controls_(controls),
    team_(team),
    columns_
    (
        invertOneToMany(wall.context.wall.points.size(), starts.wallPoints)
    ),
    made_
    {
        gradientLines
        {
            starts.nSamples(), pointField(nColumns*starts.nSamples()),
            scalarField(nColumns*starts.nSamples())
        },
        scalarField(nColumns)
    },
    toOwners_(team.size())
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
            wall_.context, wall_.radii, own, wall_.controls, wall_.mesh,
            wall_.maxStretch
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

    if (!team_.isAlone())
    {
        #pragma omp critical
        addForOwners(columns, lines);

        return;
    }

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


void blockwiseLines::addForOwners
(
    const labelUList& columns,
    const columnLines& lines
)
{
    const label n = starts_.nSamples();

    forAll(columns, i)
    {
        message& toOwner =
            toOwners_[team_.owner(starts_.wallPoints[columns[i]])];
        toOwner.addValue(columns[i]);
        toOwner.addValue(lines.slopes[i]);
        toOwner.addList(SubList<scalar>(lines.lines.energies, n, n*i));
        toOwner.addList(SubList<point>(lines.lines.points, n, n*i));
    }
}


void blockwiseLines::exchange()
{
    if (team_.isAlone())
    {
        return;
    }

    const label n = starts_.nSamples();
    const List<message> received(team_.exchange(toOwners_));
    toOwners_.clear();
    for (const message& m : received)
    {
        messageReader reader(m);
        while (!reader.atEnd())
        {
            const label c = team_.columnHere(reader.value<label>());
            made_.slopes[c] = reader.value<scalar>();
            SubList<scalar>(made_.lines.energies, n, n*c) =
                reader.list<scalar>();
            SubList<point>(made_.lines.points, n, n*c) = reader.list<point>();
        }
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

} // End namespace Foam

// ************************************************************************* //
