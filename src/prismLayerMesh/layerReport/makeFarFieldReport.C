/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "farFieldReport.H"
#include "prismPolyMesh.H"
#include "polyMeshTools.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- What checkMesh accepts: non-orthogonality [deg] and skewness
static const scalar goodAngle = 70;
static const scalar goodSkewness = 4;


static faceQuality qualityOf
(
    const labelUList& faces,
    const scalarField& angles,
    const scalarField& skewness,
    const vectorField& centres
)
{
    faceQuality quality;
    quality.nFaces = faces.size();

    scalarField ofFaces(angles, faces);
    quality.nonOrthogonality = makePercentiles(ofFaces);
    ofFaces = scalarField(skewness, faces);
    quality.skewness = makePercentiles(ofFaces);

    DynamicList<point> places;
    for (const label facei : faces)
    {
        if (angles[facei] > goodAngle || skewness[facei] > goodSkewness)
        {
            places.append(centres[facei]);
        }
    }
    quality.poorPlaces = pointField(std::move(places));

    return quality;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::farFieldReport Foam::makeFarFieldReport(const polyMesh& mesh)
{
    const label nLayerCells = mesh.cellZones()[boundaryLayerName].size();
    const vectorField& centres = mesh.faceCentres();
    const scalarField& volumes = mesh.cellVolumes();

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

    const scalarField skewness
    (
        polyMeshTools::faceSkewness
        (
            mesh, mesh.points(), centres, mesh.faceAreas(), mesh.cellCentres()
        )
    );

    DynamicList<label> inLayers, between, inFarField;
    DynamicList<scalar> ratios;

    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        const label owner = mesh.faceOwner()[facei];
        const label neighbour = mesh.faceNeighbour()[facei];

        if (neighbour < nLayerCells)
        {
            inLayers.append(facei);
        }
        else if (owner < nLayerCells)
        {
            between.append(facei);
            ratios.append(volumes[neighbour]/volumes[owner]);
        }
        else
        {
            inFarField.append(facei);
        }
    }

    farFieldReport report;
    report.nCells = mesh.nCells() - nLayerCells;
    report.layers = qualityOf(inLayers, angles, skewness, centres);
    report.transition = qualityOf(between, angles, skewness, centres);
    report.farField = qualityOf(inFarField, angles, skewness, centres);

    scalarField volumeRatios(std::move(ratios));
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


// ************************************************************************* //
