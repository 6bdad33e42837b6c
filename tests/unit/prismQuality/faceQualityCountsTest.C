/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchReport.H"
#include "memoryMesh.H"
#include "openSurfaces.H"
#include "polyMeshTetDecomposition.H"
#include "polyMeshTools.H"
#include "StringStream.H"
#include "testLayers.H"
#include "testSurfaces.H"
#include "tetPointRef.H"
#include "unitConversion.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static faceQualityCounts countedIn
(
    const wallSurface& wall,
    const prismLayers& layers,
    const qualityControls& bounds
)
{
    return faceQualityOfLayers
    (
        layers, layerGeometry(layers, makeWallAddressing(wall)), bounds
    );
}


//- The measures of polyMeshTools, of internal faces
struct polyMeshMeasures
{
    scalarField cosines, skewness, weights, ratios;

    explicit polyMeshMeasures(const polyMesh& mesh)
    {
        const pointField& cells = mesh.cellCentres();
        const pointField& centres = mesh.faceCentres();
        const vectorField& areas = mesh.faceAreas();
        const auto internal = [&](const scalarField& all)
        {
            return scalarField(SubField<scalar>(all, mesh.nInternalFaces()));
        };

        cosines = internal
        (
            polyMeshTools::faceOrthogonality(mesh, areas, cells)
        );
        skewness = internal
        (
            polyMeshTools::faceSkewness
            (
                mesh, mesh.points(), centres, areas, cells
            )
        );
        weights = internal
        (
            polyMeshTools::faceWeights(mesh, centres, areas, cells)
        );
        ratios = internal(polyMeshTools::volRatio(mesh, mesh.cellVolumes()));
    }
};


//- Number of values below a bound
static label nBelow(const scalarField& values, const scalar bound)
{
    return std::count_if
    (
        values.begin(), values.end(), [&](const scalar x) { return x < bound; }
    );
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(faceQualityCounts, equalThoseOfPolyMesh)
{
    qualityControls bounds;
    bounds.maxNonOrtho = 40;
    bounds.maxInternalSkewness = 0.3;
    bounds.minFaceWeight = 0.4;
    bounds.minVolRatio = 0.6;

    for (const wallSurface& wall :
         {testSurfaces::sphere(4), testSurfaces::quadSphere(4)})
    {
        const prismLayers layers(testSurfaces::shakenLayers(wall, 0.06));
        const faceQualityCounts faces(countedIn(wall, layers, bounds));
        const memoryMesh memory(layers);
        const polyMeshMeasures m(memory());

        EXPECT_EQ(faces.nFaces, memory().nInternalFaces());
        EXPECT_NEAR
        (
            faces.maxNonOrtho, radToDeg(::acos(min(m.cosines))), 1e-9
        );
        EXPECT_NEAR
        (
            faces.meanNonOrtho(), radToDeg(::acos(average(m.cosines))), 1e-9
        );
        EXPECT_NEAR(faces.maxSkewness, max(m.skewness), 1e-9);
        EXPECT_NEAR(faces.minWeight, min(m.weights), 1e-9);
        EXPECT_NEAR(faces.minVolRatio, min(m.ratios), 1e-9);

        const label expected[] =
        {
            nBelow(m.cosines, ::cos(degToRad(bounds.maxNonOrtho))),
            nBelow(-m.skewness, -bounds.maxInternalSkewness),
            nBelow(m.weights, bounds.minFaceWeight),
            nBelow(m.ratios, bounds.minVolRatio)
        };
        for (label k = 0; k < 4; ++k)
        {
            EXPECT_GT(expected[k], 0) << k;
            EXPECT_EQ(faces.nBeyond[k], expected[k]) << k;
        }
        EXPECT_GE(faces.nBeyondAny, expected[0]);
        EXPECT_LE(faces.nBeyondAny, faces.nFaces);
    }
}


TEST(faceQualityCounts, findNoBasePointWherePolyMeshDoesNot)
{
    const wallSurface wall(testSurfaces::quadSphere(4));
    const prismLayers layers(testSurfaces::shakenLayers(wall, 0.09));
    const faceQualityCounts faces(countedIn(wall, layers, qualityControls()));

    const memoryMesh memory(layers);
    label expected = 0;
    for (label facei = 0; facei < memory().nInternalFaces(); ++facei)
    {
        expected += polyMeshTetDecomposition::findSharedBasePoint
        (
            memory(), facei, qualityControls().minTetQuality
        ) < 0;
    }

    EXPECT_GT(expected, 10);
    EXPECT_EQ(faces.nBeyond[4], expected);
}


TEST(faceQualityCounts, tetrahedraAreBelowTheBound)
{
    const point a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);

    for (const scalar height : {1.0, 1e-2, 1e-4})
    {
        const point d(0.3, 0.3, height);
        const scalar quality = tetPointRef(a, b, c, d).quality();

        EXPECT_TRUE(isBelowQuality(a, b, c, d, 1.01*quality));
        EXPECT_FALSE(isBelowQuality(a, b, c, d, 0.99*quality));
        EXPECT_TRUE(isBelowQuality(a, c, b, d, 0.99*quality));
        EXPECT_TRUE(isBelowQuality(a, c, b, d, -1));
    }
}


TEST(faceQualityCounts, knowFacesOfTheWall)
{
    const wallSurface wall(testSurfaces::unequalTriangles());
    const prismLayers layers
    (
        testSurfaces::straightLayers(wall, scalarList({0, 0.01, 0.02}))
    );
    const faceQualityCounts faces(countedIn(wall, layers, qualityControls()));

    EXPECT_GT(faces.maxNonOrtho, 80);
    EXPECT_EQ(faces.nBeyond[0], 2);
    EXPECT_EQ(faces.nOfWall, 2);
}


TEST(faceQualityCounts, logNamesBoundsAndPlace)
{
    const wallSurface wall(testSurfaces::sphere(4));
    const prismLayers layers(testSurfaces::shakenLayers(wall, 0.06));
    qualityControls bounds;
    OStringStream good, bad;
    write(good, "of layers", countedIn(wall, layers, bounds));
    bounds.maxNonOrtho = 30;
    write(bad, "of layers", countedIn(wall, layers, bounds));

    EXPECT_EQ(good.str().find("Faces of layers: non-orthogonality"), 0u);
    EXPECT_NE(bad.str().find(" maxNonOrtho"), std::string::npos);
    EXPECT_NE(bad.str().find("; first at ("), std::string::npos);
}


// ************************************************************************* //
