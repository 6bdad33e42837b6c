/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farFieldReport.H"
#include "memoryMesh.H"
#include "meshBuilder.H"
#include "soundMesh.H"
#include "testFarField.H"
#include "testLayers.H"
#include "testStages.H"
#include "testSurfaces.H"
#include "thrownMessage.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Layers with a far field
struct farCase
{
    prismLayers layers;
    farFieldControls controls;
    farFieldMesh mesh;

    //- Around a wall: a box from low to high
    farCase
    (
        const wallSurface& wall,
        const boundBox& box,
        const label maxCells = 1000000
    )
    {
        const prismLayerMesh run(testSurfaces::layeredMesh(wall, 3, 0.1));
        layers = run.made.layers;
        controls.type = farFieldType::tet;
        controls.maxCells = maxCells;

        if (!box.empty())
        {
            controls.boundary.type = farBoundaryType::box;
            controls.boundary.box = box;
        }
        mesh = farFieldOf(run, controls);
    }
};


static boundBox boxOf(const scalar size)
{
    return boundBox(point::uniform(-size), point::uniform(size));
}


static std::string errorOf(const boundBox& box, const label maxCells)
{
    return thrownMessage<error>
    (
        [&]() { farCase(testSurfaces::sphere(5), box, maxCells); }
    );
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(makeFarFieldMesh, joinsTheLayersWithoutAPatchBetween)
{
    const farCase c(testSurfaces::sphere(5), boxOf(4));
    const memoryMesh memory(c.layers, c.mesh);
    const polyMesh& mesh = memory();

    EXPECT_EQ
    (
        mesh.boundaryMesh().names(),
        wordList({"wall", "xMin", "xMax", "yMin", "yMax", "zMin", "zMax"})
    );
    EXPECT_EQ(mesh.nCells(), 3*300 + c.mesh.nCells);
    EXPECT_EQ
    (
        mesh.cellZones().names(), wordList({"boundaryLayer", "farField"})
    );
    EXPECT_EQ(mesh.cellZones()[0].size(), 3*300);
    EXPECT_EQ(mesh.cellZones()[1].size(), c.mesh.nCells);
    expectSound(mesh);

    // All of the box is filled but the body
    EXPECT_NEAR
    (
        sum(mesh.cellVolumes()),
        512 - testSurfaces::enclosedVolume(testSurfaces::sphere(5)), 1e-9
    );
}


TEST(makeFarFieldMesh, takesQuadsAndSeveralBodies)
{
    const farCase c
    (
        testSurfaces::merge
        (
            testSurfaces::quadSphere(4),
            testSurfaces::translated
            (
                testSurfaces::quadCube(3), vector(2.5, 0, 0)
            )
        ),
        boxOf(5)
    );
    const memoryMesh memory(c.layers, c.mesh);
    expectSound(memory());

    // Nearly all quadrilaterals stay one face
    EXPECT_GE(c.mesh.frontFaces.size(), 96 + 54);
    EXPECT_LT(c.mesh.frontFaces.size(), 1.2*(96 + 54));
}


TEST(makeFarFieldMesh, fillsTheInsideOfAWall)
{
    const farCase c
    (
        testSurfaces::reversed(testSurfaces::cube(4, 2)), boundBox()
    );
    const memoryMesh memory(c.layers, c.mesh);
    expectSound(memory());
    EXPECT_NEAR(sum(memory().cellVolumes()), 8, 1e-12);
    EXPECT_EQ(memory().boundaryMesh().names(), wordList({"wall"}));
}


TEST(makeFarFieldMesh, sizesGrowByTheGivenRate)
{
    const farCase c(testSurfaces::sphere(8), boxOf(10));

    // Edges at a distance from the layers
    scalar sum = 0;
    label n = 0;
    for (const face& f : c.mesh.topology.faces)
    {
        for (const edge& e : f.edges())
        {
            const scalar r = mag(e.centre(c.mesh.points));

            if (r > 3 && r < 6)
            {
                sum += e.mag(c.mesh.points)/(0.17 + 0.2*(r - 1.1));
                ++n;
            }
        }
    }

    EXPECT_GT(n, 1000);
    EXPECT_NEAR(sum/n, 1, 0.15);
}


TEST(makeFarFieldMesh, reportsTheTransition)
{
    const farCase c(testSurfaces::sphere(5), boxOf(4));
    const farFieldReport report
    (
        makeFarFieldReport(c.layers, c.mesh, qualityControls())
    );

    EXPECT_EQ(report.nCells, c.mesh.nCells);
    EXPECT_EQ(report.transition.nFaces, 300);
    EXPECT_EQ(report.patches.size(), 6);
    EXPECT_LT(report.farField.maxNonOrtho, 70);
    EXPECT_EQ(report.farField.nBeyondAny, 0);
    EXPECT_GT(report.volumeRatio.min, 0.1);

    const dictionary dict(toDictionary(report));
    EXPECT_EQ(dict.get<label>("cells"), report.nCells);
    EXPECT_EQ
    (
        dict.subDict("patchFaces").get<label>("xMin"), report.patchFaces[0]
    );
}


TEST(makeFarFieldMesh, boundariesInTheWrongPlaceAreRefused)
{
    expectWords(errorOf(boxOf(1.05), 1000000), {"cuts the layers", "first at"});
    expectWords
    (
        errorOf(boundBox(point(2, 2, 2), point(3, 3, 3)), 1000000),
        {"not around the wall"}
    );
}


TEST(makeFarFieldMesh, moreCellsThanAllowedAreRefused)
{
    expectWords(errorOf(boxOf(4), 6000), {"about", "maxCells 6000"});
    expectWords(errorOf(boxOf(4), 1000), {"many more cells", "maxCells 1000"});
}


TEST(requireVolumes, refusesATetrahedronThatIsFlatButForRounding)
{
    const auto tetOfHeight = [](const scalar height)
    {
        farFieldMesh far;
        far.points = pointField
        ({
            point(1, 0, 0), point(2, 0, 0), point(1, 1, 0),
            point(1.2, 0.2, height)
        });
        far.nCells = 1;
        const faceList faces
        ({
            face({0, 2, 1}), face({0, 1, 3}), face({1, 2, 3}), face({2, 0, 3})
        });
        meshBuilder made;
        for (const face& f : faces)
        {
            made.append(f, 0, meshBuilder::onPatch(0));
        }
        far.topology = made.topology(made.order(1, 1), 1);

        return far;
    };

    EXPECT_NO_THROW(requireVolumes(tetOfHeight(1e-12), 1));
    EXPECT_NO_THROW(requireVolumes(tetOfHeight(1e-18), 0));
    EXPECT_THROW(requireVolumes(tetOfHeight(1e-18), 1), error);
}

// ************************************************************************* //
