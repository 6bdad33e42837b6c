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

    const auto work = [&](pipeWriter& out)
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
