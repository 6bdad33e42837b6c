/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "blockLines.H"
#include "isolatedProcess.H"
#include "ListOps.H"
#include "monotoneField.H"
#include "throwingErrors.H"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The lines of the first nColumns columns of a block
static columnLines makeLines
(
    const dividedWall& wall,
    const columnStarts& all,
    const labelList& part,
    const label nColumns,
    const fieldControls& controls
)
{
    const fieldBlock block
    (
        makeFieldBlock
        (
            wall.wall, wall.radii, part, wall.controls, wall.mesh,
            wall.maxStretch
        )
    );
    const backgroundMesh mesh(makeBackgroundMesh(block));
    const monotoneField field
    (
        makeMonotoneField(mesh, cotangentWeights(mesh), controls)
    );

    const label nPoints = wall.wall.points.size();
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


//- Writes lines for another process. First the length of the reason why there
//  are none, then what there is.
static void write
(
    const string& reason,
    const columnLines& made,
    std::FILE* out
)
{
    const auto put = [&](const auto& values)
    {
        std::fwrite(values.cdata(), sizeof(values[0]), values.size(), out);
    };
    const size_t length = reason.size();
    std::fwrite(&length, sizeof(length), 1, out);
    std::fwrite(reason.data(), 1, length, out);
    if (reason.empty())
    {
        put(made.slopes);
        put(made.lines.energies);
        put(made.lines.points);
    }
}


//- Reads the output of 'write'. Returns whether it is complete.
static bool read(std::FILE* in, string& reason, columnLines& lines)
{
    const auto take = [&](auto& values)
    {
        return std::fread
        (
            values.data(), sizeof(values[0]), values.size(), in
        ) == size_t(values.size());
    };
    size_t length = 0;
    if (std::fread(&length, sizeof(length), 1, in) != 1)
    {
        return false;
    }
    reason.resize(length);

    return std::fread(&reason[0], 1, length, in) == length
        && (
               length > 0
            || (
                   take(lines.slopes)
                && take(lines.lines.energies) && take(lines.lines.points)
               )
           );
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

columnLines linesOfBlock
(
    const dividedWall& wall,
    const columnStarts& starts,
    const labelList& part,
    const fieldControls& controls,
    string& failure
)
{
    const labelList columns(starts.columnsOn(part, wall.wall.points.size()));
    const label nColumns = columns.size();
    columnLines lines(noLines(nColumns, starts.spacing.nLayers));
    failure.clear();

    const auto work = [&](std::FILE* out)
    {
        const throwingErrors throwing;
        string reason;
        columnLines made;
        try
        {
            made = makeLines(wall, starts, part, nColumns, controls);
            if (!std::isfinite(sum(made.slopes) + sum(mag(made.lines.points))))
            {
                reason = "its lines are not finite";
            }
        }
        catch (const Foam::error& e)
        {
            reason = e.message();
        }
        write(reason, made, out);
    };
    const auto receive = [&](std::FILE* in)
    {
        return read(in, failure, lines);
    };

    if (isolatedProcess(work, receive) != processEnd::complete)
    {
        failure = "the process that made it crashed";
    }
    lines.isSet = true;

    return failure.empty() ? lines : straightLines(wall.wall, starts, columns);
}


columnLines noLines(const label nColumns, const label nSamples)
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


void setLines
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


string summary(const labelListList& parts, const blockFailures& failures)
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

} // End namespace Foam

// ************************************************************************* //
