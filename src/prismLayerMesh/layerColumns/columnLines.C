/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnLines.H"
#include "diffusionTensor.H"
#include "Map.H"

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

} // End namespace Foam

// ************************************************************************* //
