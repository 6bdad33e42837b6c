/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerReport.H"
#include "faceQualityReport.H"
#include "pluginVersion.H"
#include "Switch.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static dictionary toDictionary(const MinMax<scalar>& range)
{
    dictionary dict;
    dict.add("min", range.valid() ? range.min() : 0);
    dict.add("max", range.valid() ? range.max() : 0);

    return dict;
}


static dictionary toDictionary(const layerRequest& request)
{
    dictionary dict;
    dict.add("firstLayerThickness", toDictionary(request.firstThickness));
    dict.add("expansionRatio", toDictionary(request.ratio));
    dict.add("thickness", toDictionary(request.thickness));

    return dict;
}


//- By cause
static dictionary squeezedDictionary
(
    const FixedList<label, nSqueezeCauses>& counts
)
{
    dictionary squeezed;

    for (label cause = 1; cause < nSqueezeCauses; ++cause)
    {
        squeezed.add(name(squeezeCause(cause)), counts[cause]);
    }

    return squeezed;
}


static dictionary toDictionary(const patchReport& patch)
{
    dictionary dict;
    dict.add("faces", patch.nFaces);
    dict.add("area", patch.area);
    dict.add("request", toDictionary(patch.request));
    dict.add("layersAsked", patch.layersAsked);
    dict.add("layersReached", patch.layersReached);
    dict.add("fullLayersAreaPercent", patch.fullLayersArea);
    dict.add("fullThicknessAreaPercent", patch.fullThicknessArea);
    dict.add("firstHeightOverRequest", toDictionary(patch.firstHeight));
    dict.add("totalThicknessOverRequest", toDictionary(patch.totalThickness));
    dict.add("growthOverRequest", toDictionary(patch.growth));
    dict.add("worstScaledJacobian", patch.worstJacobian);
    dict.add("meanScaledJacobian", patch.meanJacobian);
    dict.add("squeezedPoints", squeezedDictionary(patch.points));

    return dict;
}


static dictionary pointsDictionary(const layerReport& report)
{
    dictionary dict;

    for (label kind = 0; kind < nPointKinds; ++kind)
    {
        dict.add(name(pointKind(kind)), report.points[kind]);
    }

    return dict;
}


static dictionary columnsDictionary(const layerReport& report)
{
    dictionary dict;
    dict.add("total", sum(labelList(report.columns)));
    dict.add("fullThickness", report.columns[0]);
    dict.add("squeezed", squeezedDictionary(report.columns));
    dict.add("multipleNormals", report.nExtraColumns);
    dict.add("retreats", report.nRetreats);

    return dict;
}


static dictionary stagesDictionary(const UList<stageCost>& stages)
{
    dictionary dict;

    for (const stageCost& stage : stages)
    {
        dictionary cost;
        const dictionary* earlier = dict.findDict(stage.stage);
        cost.add
        (
            "seconds",
            stage.seconds + (earlier ? earlier->get<scalar>("seconds") : 0)
        );
        cost.add("peakMemoryMB", stage.peakMemory);
        dict.set(stage.stage, cost);
    }

    return dict;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

dictionary toDictionary(const percentiles& spread)
{
    dictionary dict;
    dict.add("mean", spread.mean);
    dict.add("min", spread.min);
    dict.add("p1", spread.p1);
    dict.add("p5", spread.p5);
    dict.add("p50", spread.p50);
    dict.add("p95", spread.p95);
    dict.add("p99", spread.p99);
    dict.add("max", spread.max);

    return dict;
}


dictionary toDictionary(const layerReport& report)
{
    dictionary wall;
    wall.add("faces", report.nWallFaces);
    wall.add("points", report.nWallPoints);
    wall.add("emptyCones", report.points[int(pointKind::empty)]);
    wall.add("pointKinds", pointsDictionary(report));

    dictionary certificate;
    certificate.add("cells", report.nCells);
    certificate.add("stacksNotPositive", report.nStacksNotPositive);
    certificate.add("overlaps", report.nOverlaps);
    certificate.add("outlyingCentres", report.outlyingCentres.size());
    certificate.add("valid", Switch(report.valid));

    dictionary patches;
    for (const patchReport& patch : report.patches)
    {
        patches.add(patch.name, toDictionary(patch));
    }

    dictionary dict;
    dict.add("version", string(pluginVersion));
    dict.add("wall", wall);
    dict.add("certificate", certificate);
    dict.add("allPatches", toDictionary(report.wall));
    dict.add("firstHeightChange", toDictionary(report.firstHeightChange));
    dict.add("patches", patches);
    dict.add("field", report.noField.empty() ? "followed" : report.noField);
    dict.add("columns", columnsDictionary(report));
    dict.add("quality", toDictionary(report.faces));
    dict.add("stages", stagesDictionary(report.stages));

    return dict;
}

} // End namespace Foam

// ************************************************************************* //
