/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "diffusionTensor.H"
#include "harmonicField.H"
#include "testStages.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using testSurfaces::layeredMesh;

static wallSurface scaled(const wallSurface& wall, const scalar factor)
{
    wallSurface result(wall);
    result.points *= factor;

    return result;
}


static labelList countCauses(const madeLayers& made)
{
    labelList counts(nSqueezeCauses, 0);

    for (const squeezeCause cause : made.causes)
    {
        ++counts[int(cause)];
    }

    return counts;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(makePrismLayerMesh, layersOnASphereAreCertified)
{
    const wallSurface wall(testSurfaces::sphere(6));
    const prismLayerMesh m(layeredMesh(wall, 5, 0.1));

    EXPECT_TRUE(m.certificate.valid());
    EXPECT_EQ(m.certificate.nCells, 5*wall.faces.size());
    EXPECT_EQ(m.guide.fields.topology.eulerCharacteristic, 2);
}


TEST(makePrismLayerMesh, fluidInsideASphere)
{
    const wallSurface wall(testSurfaces::reversed(testSurfaces::sphere(6)));
    const prismLayerMesh m(layeredMesh(wall, 5, 0.1));

    EXPECT_TRUE(m.certificate.valid());
    EXPECT_EQ(countCauses(m.made)[0], wall.points.size());
    for (label p = 0; p < wall.points.size(); ++p)
    {
        EXPECT_LT(mag(m.made.layers(p, 5)), 1);
    }
}


TEST(makePrismLayerMesh, stagesAreToldInTheirOrder)
{
    DynamicList<word> begun;
    label nEnded = 0;
    prismLayerControls controls;
    controls.layers = testSurfaces::layersOf(3, 0.1);

    makePrismLayerMesh
    (
        testSurfaces::cube(2),
        controls,
        localHeights(),
        stageObserver
        {
            [&](const word& stage)
            {
                EXPECT_EQ(begun.size(), nEnded);
                begun.append(stage);
            },
            [&](const string& sizes)
            {
                ++nEnded;
                EXPECT_FALSE(sizes.empty());
            }
        }
    );

    EXPECT_EQ(nEnded, begun.size());
    EXPECT_EQ
    (
        wordList(begun),
        wordList
        ({
            "wallVisibility", "layerSpacing", "layerFront", "wallClearance",
            "offsetEnvelope", "backgroundMesh", "isotropicField",
            "anisotropicField", "layerColumns", "prismLayers", "prismQuality"
        })
    );
}


TEST(makePrismLayerMesh, powersOfTwoScaleEverything)
{
    // All coordinates are exact multiples, so that nothing rounds differently
    const wallSurface wall(testSurfaces::slitBlock(6, 0.1));
    const prismLayerMesh m(layeredMesh(wall, 5, 0.1));

    for (const scalar factor : {1.0/1024, 1024.0})
    {
        const prismLayerMesh other
        (
            layeredMesh(scaled(wall, factor), 5, 0.1*factor)
        );

        EXPECT_EQ
        (
            other.guide.fields.background.tets, m.guide.fields.background.tets
        );
        EXPECT_EQ(countCauses(other.made), countCauses(m.made));
        EXPECT_LT
        (
            max(mag(other.made.thickness/(factor*m.made.thickness) - 1)), 1e-9
        );
    }
}


TEST(makePrismLayerMesh, unitOfLengthDoesNotMatter)
{
    // Rounding decides between tetrahedra of equal right, and with them may
    // decide how often a column retreats
    const wallSurface wall(testSurfaces::slitBlock(6, 0.1));
    const label nFree =
        countCauses(layeredMesh(wall, 5, 0.1).made)[0];

    for (const scalar factor : {1e-3, 1e3})
    {
        const prismLayerMesh other
        (
            layeredMesh(scaled(wall, factor), 5, 0.1*factor)
        );

        EXPECT_TRUE(other.certificate.valid());
        EXPECT_NEAR(scalar(countCauses(other.made)[0])/nFree, 1, 0.02);
    }
}


TEST(makePrismLayerMesh, placeDoesNotMatter)
{
    const wallSurface wall(testSurfaces::slitBlock(6, 0.1));
    const prismLayerMesh m(layeredMesh(wall, 5, 0.1));
    const prismLayerMesh other
    (
        layeredMesh
        (
            testSurfaces::translated(wall, vector(100, -200, 300)), 5, 0.1
        )
    );

    EXPECT_TRUE(other.certificate.valid());
    EXPECT_NEAR
    (
        scalar(countCauses(other.made)[0])/countCauses(m.made)[0],
        1,
        0.02
    );
}


TEST(makePrismLayerMesh, bothSolversGiveTheLayers)
{
    const wallSurface wall(testSurfaces::cube(4));
    prismLayerControls controls;
    controls.layers = testSurfaces::layersOf(5, 0.1);
    controls.field.tolerance = 1e-12;
    const stageObserver unheard{[](const word&) {}, [](const string&) {}};

    controls.field.solver = fieldSolver::krylov;
    const prismLayerMesh a
    (
        makePrismLayerMesh(wall, controls, localHeights(), unheard)
    );
    controls.field.solver = fieldSolver::iteration;
    const prismLayerMesh b
    (
        makePrismLayerMesh(wall, controls, localHeights(), unheard)
    );

    EXPECT_LT(max(mag(b.guide.field - a.guide.field)), 1e-4);
}


TEST(makePrismLayerMesh, pointThatSeesNothingHasMultipleNormals)
{
    const wallSurface wall(testSurfaces::screw(point(3, 4, 5)));
    ASSERT_NEAR(testSurfaces::enclosedVolume(wall), 4, 1e-12);

    const prismLayerMesh mesh(layeredMesh(wall, 3, 0.1));

    EXPECT_EQ(mesh.visibility.emptyCones().size(), 1);
    EXPECT_GE(mesh.made.layers.extraColumnPoints.size(), 1);
    EXPECT_TRUE(mesh.certificate.valid());
    EXPECT_EQ(mesh.made.layers.nWallFaces(), wall.faces.size());
    EXPECT_EQ
    (
        mesh.made.layers.faces.size() - wall.faces.size(),
        2*mesh.made.layers.extraColumnPoints.size()
    );
}


// ************************************************************************* //
