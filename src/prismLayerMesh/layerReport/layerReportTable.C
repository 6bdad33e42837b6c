/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerReport.H"
#include "faceQualityReport.H"
#include "StringStream.H"

#include <iomanip>
#include <sstream>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
