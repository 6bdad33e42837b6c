/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "testStages.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- Walls on which faces are beyond the bounds with the heights asked for
static List<wallSurface> narrowWalls()
{
    return
    {
        testSurfaces::torus(24, 12, 1, 0.8), testSurfaces::wedgeBlock(8, 45),
        testSurfaces::slitBlock(8, 0.05)
    };
}


//- The same layers with heights that do not give way
static madeLayers withPriorityThickness(const prismLayerMesh& m)
{
    layerMoveControls moves;
    moves.quality.priority = qualityControls::priorities::thickness;

    return makePrismLayers
    (
        m.share.front, m.guide.spacing.at(m.share.front.wallPoints),
        m.columns, moves
    );
}


static faceQualityCounts facesOf
(
    const prismLayerMesh& m,
    const prismLayers& layers
)
{
    return faceQualityOfLayers
    (
        layers, layerGeometry(layers, m.share.front.addressing),
        qualityControls()
    );
}


//- Those beyond maxNonOrtho that are not so by the wall
static label nNonOrthogonal(const faceQualityCounts& faces)
{
    return faces.nBeyond[0] - faces.nOfWall;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(giveWay, onlyIfThePriorityIsQuality)
{
    label n = 0;
    label nOfHigh = 0;
    bool isNamed = false;

    for (const wallSurface& wall : narrowWalls())
    {
        const prismLayerMesh m(testSurfaces::layeredMesh(wall, 8, 0.1));
        const madeLayers high(withPriorityThickness(m));
        const faceQualityCounts faces(facesOf(m, high.layers));

        EXPECT_TRUE(high.gaveWay.empty());
        EXPECT_FALSE(high.causes.found(squeezeCause::quality));
        EXPECT_EQ
        (
            m.made.gaveWay.empty(),
            high.layers.points == m.made.layers.points
        );
        EXPECT_LE(m.faces.nBeyondAny, faces.nBeyondAny);

        n += nNonOrthogonal(m.faces);
        nOfHigh += nNonOrthogonal(faces);
        isNamed = isNamed || m.made.causes.found(squeezeCause::quality);
    }

    EXPECT_LT(n, 0.5*nOfHigh);
    EXPECT_TRUE(isNamed);
}


TEST(giveWay, thicknessIsThatOfTheColumnsThen)
{
    const wallSurface wall(narrowWalls()[0]);
    const prismLayerMesh m(testSurfaces::layeredMesh(wall, 8, 0.1));
    const prismLayers& layers = m.made.layers;
    EXPECT_FALSE(m.made.gaveWay.empty());

    for (const label c : m.made.gaveWay)
    {
        const vector column(layers(c, layers.nLayers) - layers(c, 0));
        EXPECT_LE
        (
            m.made.thickness[c],
            m.share.front.visibility.heightCosine(c, column) + SMALL
        );
    }
}


// ************************************************************************* //
