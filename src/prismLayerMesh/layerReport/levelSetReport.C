/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "levelSetReport.H"
#include "criticalPoints.H"
#include "levelSets.H"
#include "ListOps.H"
#include "ranges.H"
#include "Switch.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static List<percentiles> spreadsByKind
(
    const scalarField& values,
    const List<pointKind>& kinds
)
{
    List<percentiles> spreads(nPointKinds);
    forAll(spreads, kind)
    {
        const labelList points(findIndices(kinds, pointKind(kind)));
        spreads[kind] = makePercentiles(scalarField(values, points));
    }

    return spreads;
}


//- Number of points at which the field is above a value
static label nAbove
(
    const scalar value,
    const scalarField& field,
    const labelUList& points
)
{
    return countOf(points, [&](const label p) { return field[p] > value; });
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool hasLevelSetReport(const prismLayerMesh& mesh)
{
    const layerSpacing& request = mesh.request;

    // The field of a wall with cyclic sides is also the field of its images
    const label nInField = mesh.guide.fields.background.nWallPoints;

    return mesh.guide.fields.failure.empty()
        && nInField == mesh.pointKinds.size()
        && max(request.thickness) <= min(request.thickness)*(1 + SMALL)
        && max(request.firstThickness)
        <= min(request.firstThickness)*(1 + SMALL);
}


levelSetReport makeLevelSetReport(const prismLayerMesh& mesh)
{
    if (!hasLevelSetReport(mesh))
    {
        FatalErrorInFunction
            << "A report of level sets needs a field, and one request for the"
            << " whole wall" << exit(FatalError);
    }

    const layerSpacing uniform(uniformSpacing(mesh.request));
    const scalarField energies
    (
        samplingEnergies
        (
            mesh.guide.fields.background, mesh.guide.field,
            mesh.visibility.axes(), mesh.pointKinds, uniform
        )
    );
    const layerSpacing levelSets
    (
        levelSetSpacing
        (
            mesh.guide.fields.background, mesh.guide.field, mesh.visibility,
            energies, uniform
        )
    );
    const criticalPoints critical
    (
        findCriticalPoints(mesh.guide.fields.background, mesh.guide.field)
    );

    levelSetReport report;
    report.firstEnergy = energies.first();
    report.lastEnergy = energies.last();
    const scalarField& field = mesh.guide.field;
    const scalar last = energies.last();
    report.nExtrema =
        nAbove(last, field, critical.minima)
      + nAbove(last, field, critical.maxima);
    report.nSaddles = nAbove(last, field, critical.saddles);
    report.lastTopology = levelSetTopology
    (
        mesh.guide.fields.background, mesh.guide.field, energies.last()
    );
    report.lastLikeWall = report.lastTopology == mesh.guide.fields.topology;
    report.first = levelSets.firstThickness/uniform.firstThickness;
    report.last = levelSets.thickness/uniform.thickness;
    report.firstOfKind = spreadsByKind(report.first, mesh.pointKinds);
    report.lastOfKind = spreadsByKind(report.last, mesh.pointKinds);

    return report;
}


dictionary toDictionary(const levelSetReport& report)
{
    dictionary dict;
    dict.add("firstEnergy", report.firstEnergy);
    dict.add("lastEnergy", report.lastEnergy);
    dict.add("extrema", report.nExtrema);
    dict.add("saddlePoints", report.nSaddles);
    dict.add("lastComponents", report.lastTopology.nComponents);
    dict.add
    (
        "lastEulerCharacteristic", report.lastTopology.eulerCharacteristic
    );
    dict.add("lastLikeWall", Switch(report.lastLikeWall));

    for (label kind = 0; kind < nPointKinds; ++kind)
    {
        dictionary heights;
        heights.add("firstOverRequest", toDictionary(report.firstOfKind[kind]));
        heights.add("lastOverRequest", toDictionary(report.lastOfKind[kind]));
        dict.add(name(pointKind(kind)), heights);
    }

    return dict;
}

} // End namespace Foam

// ************************************************************************* //
