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
    nSamples_(starts.spacing.nLayers),
    made_
    {
        gradientLines
        {
            nSamples_, pointField(nColumns*nSamples_),
            scalarField(nColumns*nSamples_)
        },
        scalarField(nColumns)
    },
    toOwners_(team.size())
{
    const label nPoints = wall.wall.points.size();
    for (label c = nPoints; c < starts.wallPoints.size(); ++c)
    {
        furtherColumns_(starts.wallPoints[c]).append(c);
    }
}


labelList blockwiseLines::columnsAt(const labelUList& points) const
{
    DynamicList<label> columns(points.size());
    for (const label p : points)
    {
        columns.append(p);
        if (furtherColumns_.found(p))
        {
            columns.append(furtherColumns_[p]);
        }
    }

    return labelList(std::move(columns));
}


labelList blockwiseLines::pointsUnder(const labelUList& columns) const
{
    return labelList(UIndirectList<label>(starts_.wallPoints, columns));
}


columnLines blockwiseLines::makeBlock(const labelList& own) const
{
    const fieldBlock block
    (
        makeFieldBlock
        (
            wall_.wall, wall_.radii, own, wall_.controls, wall_.mesh,
            wall_.maxStretch
        )
    );
    const backgroundMesh mesh(makeBackgroundMesh(block));
    const monotoneField field
    (
        makeMonotoneField(mesh, cotangentWeights(mesh), controls_)
    );

    const labelList columns(columnsAt(block.points));
    const labelList local(invert(wall_.wall.points.size(), block.points));
    const columnStarts starts
    {
        labelList(UIndirectList<label>(local, pointsUnder(columns))),
        vectorField(starts_.directions, columns), starts_.spacing.at(columns)
    };

    return makeColumnLines(mesh, field.values, starts);
}


void blockwiseLines::write
(
    const columnLines& made,
    const label nColumns,
    std::FILE* out
) const
{
    const size_t n = nColumns*nSamples_;
    std::fwrite(made.slopes.cdata(), sizeof(scalar), nColumns, out);
    std::fwrite(made.lines.energies.cdata(), sizeof(scalar), n, out);
    std::fwrite(made.lines.points.cdata(), sizeof(point), n, out);
}


bool blockwiseLines::read(const labelUList& columns, std::FILE* in)
{
    const label n = nSamples_;
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
    const label n = nSamples_;

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
    const label n = nSamples_;

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

    const label n = nSamples_;
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
    const labelList columns(columnsAt(own));
    const columnLines straight
    {
        makeStraightLines
        (
            pointField(wall_.wall.points, pointsUnder(columns)),
            vectorField(starts_.directions, columns),
            requestedHeights(starts_.spacing.at(columns))
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
