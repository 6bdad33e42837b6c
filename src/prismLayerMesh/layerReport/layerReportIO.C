/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/


#include "layerReport.H"
#include "dictionary.H"
#include "Switch.H"

#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

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
    label nColumns = 0;
    for (const label n : report.columns)
    {
        nColumns += n;
    }

    dictionary dict;
    dict.add("total", nColumns);
    dict.add("fullThickness", report.columns[0]);
    dict.add("squeezed", squeezedDictionary(report.columns));
    dict.add("multipleNormals", report.nFurtherColumns);
    dict.add("retreats", report.nRetreats);

    return dict;
}


static dictionary stagesDictionary(const UList<stageCost>& stages)
{
    dictionary dict;

    for (const stageCost& stage : stages)
    {
        dictionary cost;
        cost.add("seconds", stage.seconds);
        cost.add("peakMemoryMB", stage.peakMemory);
        dict.add(stage.stage, cost);
    }

    return dict;
}


//- With three decimals
static std::string fixed(const scalar value)
{
    std::ostringstream text;
    text << std::fixed << std::setprecision(3) << value;

    return text.str();
}


//- Rows of a table: text on the left, numbers on the right
class tableWriter
{
    std::ostringstream text_;
    const int nameWidth_;

public:

    explicit tableWriter(const int nameWidth)
    :
        nameWidth_(nameWidth)
    {
        text_ << std::fixed;
    }

    void startRow(const std::string& name)
    {
        text_ << std::left << std::setw(nameWidth_) << name << std::right;
    }

    void endRow()
    {
        text_ << '\n';
    }

    template<class Type>
    void add(const int width, const Type& value, const int precision = 0)
    {
        text_
            << std::setw(width) << std::setprecision(precision) << value;
    }

    void addSpread(const percentiles& spread)
    {
        add(8, spread.p1, 3);
        add(7, spread.p50, 3);
        add(7, spread.p99, 3);
    }

    std::string text() const
    {
        return text_.str();
    }
};


static void addHeader(tableWriter& table)
{
    table.startRow("");
    table.add(9, "");
    table.add(9, "layers");
    table.add(7, "full");
    table.add(7, "thick");
    table.add(22, "first height/asked");
    table.add(22, "thickness/asked");
    table.add(8, "growth");
    table.add(8, "worst");
    table.endRow();

    table.startRow("patch");
    table.add(9, "faces");
    table.add(9, "of asked");
    table.add(7, "area%");
    table.add(7, "area%");

    for (label i = 0; i < 2; ++i)
    {
        table.add(8, "p1");
        table.add(7, "p50");
        table.add(7, "p99");
    }

    table.add(8, "p99");
    table.add(8, "Jacob.");
    table.endRow();
}


static void addRow(tableWriter& table, const patchReport& patch)
{
    table.startRow(patch.name);
    table.add(9, patch.nFaces);
    table.add
    (
        9,
        std::to_string(patch.layersReached) + '/'
      + std::to_string(patch.layersAsked)
    );
    table.add(7, patch.fullLayersArea, 2);
    table.add(7, patch.fullThicknessArea, 2);
    table.addSpread(patch.firstHeight);
    table.addSpread(patch.totalThickness);
    table.add(8, patch.growth.p99, 3);
    table.add(8, patch.worstJacobian, 3);
    table.endRow();
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::dictionary Foam::toDictionary(const percentiles& spread)
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


Foam::dictionary Foam::toDictionary(const layerReport& report)
{
    dictionary wall;
    wall.add("faces", report.nWallFaces);
    wall.add("points", report.nWallPoints);
    wall.add("emptyCones", report.points[int(pointKind::empty)]);
    wall.add("pointKinds", pointsDictionary(report));

    dictionary certificate;
    certificate.add("cells", report.nCells);
    certificate.add("invalidCells", report.nInvalidCells);
    certificate.add("intersectingPairs", report.nIntersectingPairs);
    certificate.add("outlyingCentres", report.outlyingCentres.size());
    certificate.add
    (
        "valid",
        Switch(!report.nInvalidCells && !report.nIntersectingPairs)
    );

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
    dict.add("patches", patches);
    dict.add("field", report.noField.empty() ? "followed" : report.noField);
    dict.add("columns", columnsDictionary(report));
    dict.add("stages", stagesDictionary(report.stages));

    return dict;
}


void Foam::write(Ostream& os, const layerReport& report)
{
    if (report.noField.size())
    {
        os  << "Columns do not follow a field: " << report.noField.c_str()
            << nl;
    }

    size_t nameWidth = report.wall.name.size();
    for (const patchReport& patch : report.patches)
    {
        nameWidth = std::max(nameWidth, patch.name.size());
    }

    tableWriter table(nameWidth);
    addHeader(table);

    for (const patchReport& patch : report.patches)
    {
        addRow(table, patch);
    }

    if (report.patches.size() > 1)
    {
        addRow(table, report.wall);
    }

    os  << table.text().c_str() << nl
        << "Cells " << report.nCells
        << ", not positive " << report.nInvalidCells
        << ", intersecting pairs " << report.nIntersectingPairs << nl
        << "First height from face to face changes by a factor of at most "
        << fixed(report.firstHeightChange.max).c_str() << ", on 99 % of edges "
        << fixed(report.firstHeightChange.p99).c_str() << nl;

    for (const point& x : report.outlyingCentres)
    {
        std::ostringstream place;
        place << '(' << x.x() << ' ' << x.y() << ' ' << x.z() << ')';

        os  << "A cell's centre is outside of it, which checkMesh calls faces"
            << " incorrectly oriented: on the wall at " << place.str().c_str()
            << nl;
    }

    os  << "Columns of full thickness " << report.columns[0]
        << ", squeezed by";

    for (label cause = 1; cause < nSqueezeCauses; ++cause)
    {
        os  << (cause > 1 ? "," : "") << ' '
            << name(squeezeCause(cause)) << ' ' << report.columns[cause];
    }

    os  << nl << "Points of the wall:";

    for (label kind = 0; kind < nPointKinds; ++kind)
    {
        os  << (kind ? "," : "") << ' ' << name(pointKind(kind)) << ' '
            << report.points[kind];
    }

    os  << "; further columns on them " << report.nFurtherColumns << nl;
}


// ************************************************************************* //
