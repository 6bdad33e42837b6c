/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "expectedYPlus.H"
#include "DynamicList.H"
#include "ListOps.H"
#include "OStringStream.H"

namespace Foam
{

scalarMinMax yPlusBand(const scalar target)
{
    return target >= 30 && target <= 300
      ? scalarMinMax(30, 300)
      : scalarMinMax(0.5*target, 1.5*target);
}


scalar weightedPercentile
(
    const scalarField& values,
    const scalarField& weights,
    const scalar percent
)
{
    labelList order;
    sortedOrder(values, order);
    scalar left = 0.01*percent*sum(weights);
    label i = 0;

    while (i + 1 < order.size() && (left -= weights[order[i]]) > 0)
    {
        ++i;
    }

    return values[order[i]];
}


string describeYPlus
(
    const wallSurface& surface,
    const scalarField& yPlus,
    const scalar target
)
{
    const scalarMinMax band(yPlusBand(target));
    scalarField areas(yPlus.size());
    scalarField ofPatch(surface.patchNames.size(), 0);
    scalarField inBand(ofPatch);

    forAll(areas, facei)
    {
        const label patchi = surface.patchIDs[facei];
        areas[facei] = surface.faces[facei].mag(surface.points);
        ofPatch[patchi] += areas[facei];
        inBand[patchi] += band.contains(yPlus[facei]) ? areas[facei] : 0;
    }

    OStringStream os;
    os.precision(3);
    const char* separator = "";
    for (const scalar percent : {1, 5, 50, 95, 99})
    {
        os  << separator << weightedPercentile(yPlus, areas, percent) << " ("
            << percent << " %)";
        separator = ", ";
    }
    os  << nl;
    forAll(ofPatch, patchi)
    {
        if (ofPatch[patchi] > 0)
        {
            os  << surface.patchNames[patchi] << ": y+ from " << band.min()
                << " to " << band.max() << " on "
                << 100*inBand[patchi]/ofPatch[patchi] << " % of the area" << nl;
        }
    }

    return os.str();
}


string describeExpected
(
    const wallSurface& wall,
    const scalarField& firstHeights,
    const scalarField& yPlusPerHeight,
    const scalar target
)
{
    DynamicList<label> known;
    DynamicList<scalar> yPlus;

    if (yPlusPerHeight.size())
    {
        forAll(wall.faces, facei)
        {
            const face& f = wall.faces[facei];
            scalar lowest = GREAT;
            scalar mean = 0;
            for (const label p : f)
            {
                lowest = min(lowest, yPlusPerHeight[p]);
                mean += yPlusPerHeight[p]*firstHeights[p]/f.size();
            }
            if (lowest > 0)
            {
                known.append(facei);
                yPlus.append(mean);
            }
        }
    }

    if (known.empty())
    {
        return string();
    }

    wallSurface part;
    part.points = wall.points;
    part.patchNames = wall.patchNames;
    part.faces = faceList(wall.faces, known);
    part.patchIDs = labelList(wall.patchIDs, known);

    return
        "y+ to be expected: "
      + describeYPlus(part, scalarField(yPlus), target);
}

} // End namespace Foam

// ************************************************************************* //
