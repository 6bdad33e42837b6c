/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farFieldReport.H"
#include "DynamicField.H"
#include "faceQualityReport.H"
#include "makeFarFieldMesh.H"
#include "prismPolyMesh.H"
#include "UIndirectList.H"

#include <sstream>

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

farFieldReport makeFarFieldReport
(
    const polyMesh& mesh,
    const qualityControls& bounds
)
{
    const label nLayerCells = mesh.cellZones()[boundaryLayerName].size();
    const scalarField& volumes = mesh.cellVolumes();
    const auto cell = [&](const label celli)
    {
        return faceCell{mesh.cellCentres()[celli], volumes[celli]};
    };
    const label nTets = mesh.cellZones()[farFieldName].size();
    const auto isTet = [=](const label celli)
    {
        return celli < nLayerCells + nTets;
    };
    DynamicField<scalar> volumeRatios;
    farFieldReport report;

    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        const label owner = mesh.faceOwner()[facei];
        const label neighbour = mesh.faceNeighbour()[facei];
        if (neighbour < nLayerCells)
        {
            continue;
        }

        faceGeometry f;
        f.centre = mesh.faceCentres()[facei];
        f.area = mesh.faceAreas()[facei];
        const UIndirectList<point> points(mesh.points(), mesh.faces()[facei]);
        faceQualityCounts& faces =
            owner < nLayerCells ? report.transition
          : isTet(neighbour) ? report.farField
          : isTet(owner) ? report.cut : report.core;
        faces.add(facei, f, points, cell(owner), cell(neighbour), bounds);

        if (owner < nLayerCells)
        {
            volumeRatios.append(volumes[neighbour]/volumes[owner]);
        }
    }

    report.nCells = mesh.nCells() - nLayerCells;
    report.nTets = nTets;
    report.volumeRatio = makePercentiles(volumeRatios);

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (patch.size() && patch.faceCells()[0] >= nLayerCells)
        {
            report.patches.append(patch.name());
            report.patchFaces.append(patch.size());
        }
    }

    return report;
}


dictionary toDictionary(const farFieldReport& report)
{
    dictionary patches;
    forAll(report.patches, patchi)
    {
        patches.add(report.patches[patchi], report.patchFaces[patchi]);
    }

    dictionary dict;
    dict.add("cells", report.nCells);
    dict.add("tetrahedra", report.nTets);
    dict.add("patchFaces", patches);
    dict.add("transition", toDictionary(report.transition));
    dict.add("inside", toDictionary(report.farField));
    if (report.nCells > report.nTets)
    {
        dict.add("cut", toDictionary(report.cut));
        dict.add("core", toDictionary(report.core));
    }
    dict.add("volumeRatio", toDictionary(report.volumeRatio));

    return dict;
}


void write(Ostream& os, const farFieldReport& report)
{
    std::ostringstream volumes;
    volumes.precision(3);
    volumes
        << "cells " << report.nCells << ", tetrahedra " << report.nTets
        << "; volumes over that of the last layer: 1 % below "
        << report.volumeRatio.p1 << ", median " << report.volumeRatio.p50
        << ", 99 % below " << report.volumeRatio.p99;

    os  << nl << "Far field: " << volumes.str().c_str() << nl;
    write(os, "between layers and far field", report.transition);
    write(os, "in the far field", report.farField);
    if (report.nCells > report.nTets)
    {
        write(os, "between tetrahedra and cells that stay", report.cut);
        write(os, "between cells that stay", report.core);
    }
}

} // End namespace Foam

// ************************************************************************* //
