/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farFieldReport.H"
#include "DynamicField.H"
#include "polyMeshTools.H"
#include "prismPolyMesh.H"
#include "unitConversion.H"

#include <iomanip>
#include <sstream>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- What checkMesh accepts: non-orthogonality [deg] and skewness
static const scalar goodAngle = 70;
static const scalar goodSkewness = 4;


static scalarField nonOrthogonality(const polyMesh& mesh)
{
    scalarField angles
    (
        polyMeshTools::faceOrthogonality
        (
            mesh, mesh.faceAreas(), mesh.cellCentres()
        )
    );
    for (scalar& angle : angles)
    {
        angle = radToDeg(::acos(max(-1.0, min(1.0, angle))));
    }

    return angles;
}


static faceQuality qualityOf
(
    const labelUList& faces,
    const scalarField& allAngles,
    const scalarField& allSkewness,
    const vectorField& centres
)
{
    const scalarField angles(allAngles, faces);
    const scalarField skewness(allSkewness, faces);

    faceQuality quality;
    quality.nFaces = faces.size();
    quality.nonOrthogonality = makePercentiles(angles);
    quality.skewness = makePercentiles(skewness);

    DynamicField<point> places;
    forAll(faces, i)
    {
        if (angles[i] > goodAngle || skewness[i] > goodSkewness)
        {
            places.append(centres[faces[i]]);
        }
    }
    quality.poorPlaces = places;

    return quality;
}


static dictionary toDictionary(const faceQuality& quality)
{
    dictionary dict;
    dict.add("faces", quality.nFaces);
    dict.add("nonOrthogonality", toDictionary(quality.nonOrthogonality));
    dict.add("skewness", toDictionary(quality.skewness));
    dict.add("poorFaces", quality.poorPlaces.size());

    return dict;
}


static void write
(
    Ostream& os,
    const std::string& where,
    const faceQuality& quality
)
{
    std::ostringstream line;
    line<< std::fixed << std::setprecision(1)
        << "Non-orthogonality " << where << ": mean "
        << quality.nonOrthogonality.mean << ", max "
        << quality.nonOrthogonality.max << "; max skewness "
        << std::setprecision(2) << quality.skewness.max;

    if (quality.poorPlaces.size())
    {
        const point& x = quality.poorPlaces[0];
        line<< "; beyond 70 or 4 " << quality.poorPlaces.size()
            << " faces, first at " << std::defaultfloat << std::setprecision(6)
            << '(' << x.x() << ' ' << x.y() << ' ' << x.z() << ')';
    }

    os  << line.str().c_str() << nl;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

farFieldReport makeFarFieldReport(const polyMesh& mesh)
{
    const label nLayerCells = mesh.cellZones()[boundaryLayerName].size();
    const vectorField& centres = mesh.faceCentres();
    const scalarField& volumes = mesh.cellVolumes();
    const scalarField angles(nonOrthogonality(mesh));
    const scalarField skewness
    (
        polyMeshTools::faceSkewness
        (
            mesh, mesh.points(), centres, mesh.faceAreas(), mesh.cellCentres()
        )
    );

    // By the number of cells in the far field
    FixedList<DynamicList<label>, 3> faces;
    DynamicField<scalar> volumeRatios;

    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        const label owner = mesh.faceOwner()[facei];
        const label neighbour = mesh.faceNeighbour()[facei];
        const label nFar = (owner >= nLayerCells) + (neighbour >= nLayerCells);

        faces[nFar].append(facei);

        if (nFar == 1)
        {
            volumeRatios.append(volumes[neighbour]/volumes[owner]);
        }
    }

    farFieldReport report;
    report.nCells = mesh.nCells() - nLayerCells;
    report.layers = qualityOf(faces[0], angles, skewness, centres);
    report.transition = qualityOf(faces[1], angles, skewness, centres);
    report.farField = qualityOf(faces[2], angles, skewness, centres);
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
    dict.add("patchFaces", patches);
    dict.add("layers", toDictionary(report.layers));
    dict.add("transition", toDictionary(report.transition));
    dict.add("inside", toDictionary(report.farField));
    dict.add("volumeRatio", toDictionary(report.volumeRatio));

    return dict;
}


void write(Ostream& os, const farFieldReport& report)
{
    std::ostringstream volumes;
    volumes.precision(3);
    volumes
        << "cells " << report.nCells
        << "; their volume over that of the last layer: 1 % below "
        << report.volumeRatio.p1 << ", median " << report.volumeRatio.p50
        << ", 99 % below " << report.volumeRatio.p99;

    os  << nl << "Far field: " << volumes.str().c_str() << nl;
    write(os, "of layers", report.layers);
    write(os, "between", report.transition);
    write(os, "in the far field", report.farField);
}

} // End namespace Foam

// ************************************************************************* //
