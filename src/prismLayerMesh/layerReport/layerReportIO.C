/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerReport.H"
#include "StringStream.H"
#include "Switch.H"

#include <iomanip>
#include <sstream>
#include <string>

namespace Foam
{

// * * * * * * * * * * * * * *  Layer Report IO  * * * * * * * * * * * * * * //

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
    dict.add("firstHeightAreaPercent", patch.firstHeightArea);
    dict.add("thicknessAreaPercent", patch.thicknessArea);
    dict.add("vanishingHeightsAreaPercent", patch.vanishingArea);
    dict.add("firstHeightMedian", patch.firstHeightMedian);
    dict.add("thicknessMedian", patch.thicknessMedian);
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
    dict.add("wall", wall);
    dict.add("certificate", certificate);
    dict.add("allPatches", toDictionary(report.wall));
    dict.add("firstHeightChange", toDictionary(report.firstHeightChange));
    dict.add("firstHeightJumps", report.heightJumps.size());
    dict.add("patches", patches);
    dict.add("field", report.noField.empty() ? "followed" : report.noField);
    dict.add("columns", columnsDictionary(report));
    dict.add("quality", toDictionary(report.faces));
    dict.add("stages", stagesDictionary(report.stages));

    return dict;
}


// * * * * * * * * * * * * *  Layer Report Table * * * * * * * * * * * * * * //

//- The 1, 50 and 99 % percentiles
static std::ostream& operator<<(std::ostream& os, const percentiles& spread)
{
    return os
        << std::setprecision(3) << std::setw(8) << spread.p1
        << std::setw(7) << spread.p50 << std::setw(7) << spread.p99;
}


static void addHeader(std::ostream& os, const int nameWidth)
{
    os  << std::left << std::setw(nameWidth) << ""
        << "            layers   full  thick"
        << "    first height/asked       thickness/asked  growth   worst\n"
        << std::setw(nameWidth) << "patch"
        << "    faces of asked  area%  area%"
        << "      p1    p50    p99      p1    p50    p99     p99  Jacob.\n";
}


static void addRow
(
    std::ostream& os,
    const int nameWidth,
    const patchReport& patch
)
{
    const std::string layers
    (
        std::to_string(patch.layersReached) + '/'
      + std::to_string(patch.layersAsked)
    );

    os  << std::left << std::setw(nameWidth) << patch.name << std::right
        << std::setw(9) << patch.nFaces << std::setw(9) << layers
        << std::setprecision(2) << std::setw(7) << patch.fullLayersArea
        << std::setw(7) << patch.fullThicknessArea
        << patch.firstHeight << patch.totalThickness
        << std::setw(8) << patch.growth.p99
        << std::setw(8) << patch.worstJacobian << '\n';
}


//- One row for each patch, and one for all of several
static void addTable(std::ostream& os, const layerReport& report)
{
    size_t nameWidth = report.wall.name.size();
    for (const patchReport& patch : report.patches)
    {
        nameWidth = std::max(nameWidth, patch.name.size());
    }

    addHeader(os, nameWidth);

    for (const patchReport& patch : report.patches)
    {
        addRow(os, nameWidth, patch);
    }

    if (report.patches.size() > 1)
    {
        addRow(os, nameWidth, report.wall);
    }
}


//- Numbers of columns by cause, and of points by kind
static void addCounts(std::ostream& os, const layerReport& report)
{
    os  << "Columns of full thickness " << report.columns[0]
        << ", squeezed by";

    for (label cause = 1; cause < nSqueezeCauses; ++cause)
    {
        os  << (cause > 1 ? "," : "") << ' '
            << name(squeezeCause(cause)) << ' ' << report.columns[cause];
    }

    os  << "\nPoints of the wall:";

    for (label kind = 0; kind < nPointKinds; ++kind)
    {
        os  << (kind ? "," : "") << ' ' << name(pointKind(kind)) << ' '
            << report.points[kind];
    }

    os  << "; extra columns " << report.nExtraColumns << '\n';
}


void write(Ostream& os, const layerReport& report)
{
    std::ostringstream text;

    if (report.noField.size())
    {
        text<< "Columns have no field to follow: " << report.noField << '\n';
    }

    text<< std::fixed;
    addTable(text, report);

    text<< std::setprecision(3)
        << "\nCells " << report.nCells << ", stacks not positive "
        << report.nStacksNotPositive << ", overlaps " << report.nOverlaps
        << "\nFirst height from face to face changes by a factor of at most "
        << report.firstHeightChange.max << ", on 99 % of edges "
        << report.firstHeightChange.p99 << '\n';

    OStringStream faces;
    write(faces, "between cells", report.faces);
    text<< faces.str();

    text<< std::defaultfloat << std::setprecision(6);
    for (const point& x : report.outlyingCentres)
    {
        text<< "The centre of a cell is outside of the cell (checkMesh: faces"
            << " incorrectly oriented), on the wall at (" << x.x() << ' '
            << x.y() << ' ' << x.z() << ")\n";
    }

    addCounts(text, report);
    os  << text.str().c_str();
}

} // End namespace Foam

// ************************************************************************* //
