/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boxSides.H"
#include "cyclicColumns.H"
#include "openSurfaces.H"
#include "periodicStages.H"
#include "periodicWall.H"
#include "testStages.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using namespace testSurfaces;

//- Largest distance of a point of a column on a first side, moved, from the
//  point of a column on the second side
static scalar largestGap(const prismLayerMesh& mesh)
{
    const prismLayers& layers = mesh.made.layers;
    scalar gap = 0;
    for (const sidePair& pair : pairsOf(layers.border.sides))
    {
        const Map<label> images(imagesOfColumns(layers, pair));
        EXPECT_EQ(images.size(), 9);
        forAllConstIters(images, iter)
        {
            const label c = iter.key();
            const label image = iter.val();
            EXPECT_EQ(mesh.made.thickness[c], mesh.made.thickness[image]);
            for (label i = 0; i <= layers.nLayers; ++i)
            {
                gap = max
                (
                    gap, mag(pair.toSecond(layers(c, i)) - layers(image, i))
                );
            }
        }
    }

    return gap;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(periodicLayers, columnsOnBothSidesAreImages)
{
    const wallSurface wall(periodicWaves(8));
    const prismLayerMesh mesh(layeredMesh(wall, 5, 0.1));

    EXPECT_TRUE(mesh.certificate.valid());
    EXPECT_EQ(mesh.certificate.nCells, 5*wall.faces.size());
    EXPECT_EQ(mesh.made.layers.nColumns(), wall.points.size());
    EXPECT_LT(largestGap(mesh), 1e-15);
}


TEST(periodicLayers, theWallIsTheGivenOne)
{
    const wallSurface wall(periodicWaves(8));
    const prismLayerMesh mesh(layeredMesh(wall, 3, 0.05));

    EXPECT_EQ(mesh.share.front.surface.faces, wall.faces);
    EXPECT_EQ(mesh.made.layers.pointsOf(0), wall.points);
    EXPECT_EQ(mesh.made.layers.patchIDs, wall.patchIDs);
    EXPECT_EQ(mesh.pointKinds.size(), wall.points.size());
    EXPECT_EQ(mesh.request.firstThickness.size(), wall.points.size());
    EXPECT_EQ
    (
        mesh.made.layers.border.edges.size(), wall.border.edges.size()
    );
}


// Few faces between the sides have images for nine periods
TEST(periodicLayers, imagesAreInFrontOfTheFarBoundary)
{
    for (const label n : {2, 8})
    {
        const wallSurface wall(periodicWaves(n));
        const List<sidePatch>& given = wall.border.sides;
        const periodicWall images(wall);
        const List<sidePatch>& sides = images.surface.border.sides;
        prismLayerControls controls;
        farBoundaryControls& boundary = controls.farField.boundary;
        boundary.type = farBoundaryType::box;
        boundary.box = boundBox(point(0, 0, -1), point(1, 1, 1));
        boundary = withImages(controls, given, sides).farField.boundary;

        const List<sidePatch> planes(freeSides(boundary, sides));
        EXPECT_EQ(planes.size(), 2);
        for (const sidePatch& plane : planes)
        {
            EXPECT_LT(max(distancesTo(plane, images.surface.points)), 0);
        }
    }
}


// What the images are for: without them the columns on both sides differ
TEST(periodicLayers, columnsDifferWithoutImages)
{
    wallSurface wall(periodicWaves(8));
    for (sidePatch& side : wall.border.sides)
    {
        side.type = "patch";
    }
    prismLayerMesh mesh(layeredMesh(wall, 5, 0.1));
    const prismLayers& layers = mesh.made.layers;
    scalar gap = 0;
    forAll(wall.points, p)
    {
        forAll(wall.points, q)
        {
            if (mag(wall.points[q] - wall.points[p] - vector(1, 0, 0)) < 1e-12)
            {
                gap = max
                (
                    gap, mag(layers(q, 5) - layers(p, 5) - vector(1, 0, 0))
                );
            }
        }
    }

    EXPECT_GT(gap, 1e-3);
}


TEST(periodicLayers, columnsStayInTheirPlanes)
{
    const prismLayerMesh mesh(layeredMesh(periodicWaves(8), 5, 0.1));
    const prismLayers& layers = mesh.made.layers;
    forAll(layers.border.edges, i)
    {
        const sidePatch& side = layers.border.sides[layers.border.edgeSides[i]];
        const edge& e = layers.border.edges[i];
        for (const label c : {e.first(), e.second()})
        {
            EXPECT_NEAR(side.distance(layers(c, 5)), 0, 1e-15);
        }
    }
}

// ************************************************************************* //
