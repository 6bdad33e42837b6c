/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polygonReport.H"

#include "memoryMesh.H"
#include "polyMeshTools.H"
#include "testFarField.H"
#include "testStages.H"
#include "testSurfaces.H"
#include "unitConversion.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using namespace testSurfaces;

//- Reports on polygons around a sphere, and their mesh
struct sphereReports
{
    layerReport layers;
    farFieldReport far;
    polygonMesh polygons;

    explicit sphereReports(const farFieldType type)
    {
        const wallSurface wall(sphere(8));
        const prismLayerMesh run(layeredMesh(wall, 4, 0.1));
        farFieldControls controls;
        controls.type = type;
        controls.forPolygons = true;
        controls.boundary.type = farBoundaryType::box;
        controls.boundary.box =
            boundBox(point::uniform(-4), point::uniform(4));
        farFieldMesh field(farFieldOf(run, controls));
        layers = makeLayerReport(wall, run);
        far = makeFarFieldReport(run.made.layers, field, qualityControls());
        polygons = makePolygonCells(run.made.layers, field);
        reportPolygons(polygons, qualityControls(), layers, far);
    }
};

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(polygonReport, countsWhatIsWritten)
{
    for (const farFieldType type : {farFieldType::tet, farFieldType::hexCore})
    {
        const sphereReports made(type);
        const polyMeshParts& mesh = made.polygons.mesh;
        label nOnBox = 0;
        for (const label n : made.far.patchFaces)
        {
            nOnBox += n;
        }

        EXPECT_EQ(made.layers.nCells, made.polygons.counts.nLayerCells);
        EXPECT_EQ(made.layers.nCells + made.far.nCells, mesh.nCells);
        EXPECT_EQ
        (
            made.far.nCells - made.far.nTets, made.polygons.counts.nOthers
        );
        EXPECT_EQ
        (
            made.layers.faces.nFaces + made.far.transition.nFaces
          + made.far.farField.nFaces + made.far.cut.nFaces
          + made.far.core.nFaces,
            mesh.topology.neighbour.size()
        );
        EXPECT_EQ
        (
            nOnBox + mesh.topology.patchSizes[0],
            mesh.topology.faces.size() - mesh.topology.neighbour.size()
        );
        EXPECT_EQ(made.far.transition.nFaces, mesh.topology.patchSizes[0]);
    }
}


TEST(polygonReport, anglesAreThoseOfCheckMesh)
{
    sphereReports made(farFieldType::tet);
    const memoryMesh mesh(std::move(made.polygons.mesh));
    const scalarField cosines
    (
        polyMeshTools::faceOrthogonality
        (
            mesh(), mesh().faceAreas(), mesh().cellCentres()
        )
    );
    const scalar largest = max
    (
        made.layers.faces.maxNonOrtho,
        max(made.far.transition.maxNonOrtho, made.far.farField.maxNonOrtho)
    );
    EXPECT_NEAR
    (
        largest, radToDeg(Foam::acos(min(cosines))), 1e-6
    );

    // No triangle of the wall brings faces between polygons beyond a bound
    EXPECT_EQ(made.layers.faces.nOfWall, 0);
}


TEST(polygonReport, theSchemeIsThatOfThePolygons)
{
    const sphereReports made(farFieldType::tet);
    const dictionary entries(toDictionary(made.far));
    const schemeGrade& grade = made.polygons.counts.grade;

    EXPECT_EQ(made.far.grade.nLargeGains, grade.nLargeGains);
    EXPECT_EQ(made.far.grade.factor, grade.factor);
    EXPECT_TRUE(entries.found("polyhedra"));
    EXPECT_FALSE(entries.found("tetrahedra"));
}


// ************************************************************************* //
