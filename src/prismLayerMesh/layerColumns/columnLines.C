/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnLines.H"
#include "blockLines.H"
#include "diffusionTensor.H"
#include "Map.H"
#include "returnMemory.H"
#include "stageProgress.H"

#include <atomic>

namespace Foam
{

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

columnLines makeColumnLines
(
    const backgroundMesh& mesh,
    const scalarField& isotropic,
    const columnStarts& starts,
    const lineDirections weighting
)
{
    return columnLines
    {
        makeGradientLines
        (
            mesh, isotropic, starts.wallPoints, starts.directions,
            requestedHeights(starts.spacing), weighting
        ),
        scalarField(mag(scaledGradients(mesh, isotropic)), starts.wallPoints),
        boolList(starts.wallPoints.size(), true)
    };
}


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
    columnLines made(noLines(starts.wallPoints.size(), starts.spacing.nLayers));
    blockFailures failures(wall.parts.size());
    const labelList order(largestFirst(wall.parts));

    std::atomic<label> nMade(0);
    #pragma omp parallel for schedule(dynamic, 1)
    forAll(order, k)
    {
        const labelList& part = wall.parts[order[k]];
        setLines
        (
            starts.columnsOn(part, wall.wall.points.size()),
            linesOfBlock(wall, starts, part, controls, failures[order[k]]),
            made
        );
        tellProgress("blocks of the field", ++nMade, order.size());
    }
    failure = summary(wall.parts, failures);

    return made;
}

} // End namespace Foam

// ************************************************************************* //
