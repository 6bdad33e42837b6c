/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "testStages.H"
#include "testSurfaces.H"
#include "unitConversion.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using testSurfaces::layeredMesh;

//- Columns before any of them retreats
static layerColumns columnsOf(const prismLayerMesh& m)
{
    return makeLayerColumns
    (
        m.share.front, m.clearance, m.guide.spacing, m.guide.lines,
        layerControls()
    );
}


//- One column of three heights
static layerColumns oneColumn()
{
    layerColumns columns;
    columns.nLayers = 3;
    columns.heights = scalarField(scalarList({1, 2, 4}));
    columns.offsets = vectorField
    (
        List<vector>({vector(0, 0, 1), vector(1, 0, 1), vector(3, 0, 1)})
    );

    return columns;
}


//- Whether a point of the unit cube is that far from all edges
static bool awayFromEdges(const point& x, const scalar distance)
{
    label nSides = 0;
    for (const scalar c : x)
    {
        nSides += c < distance || c > 1 - distance;
    }

    return nSides < 2;
}


//- Offset of the first column at a height
static vector offset(const layerColumns& columns, const scalar height)
{
    return columns.interpolated(columns.offsets, 0, height);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(requestedHeights, areGeometricSums)
{
    const wallSurface wall(testSurfaces::cube(1));
    layerControls controls;
    controls.heights.nSurfaceLayers = 12;
    controls.heights.firstLayerThickness = 1e-3;
    controls.heights.expansionRatio = 1.3;

    const scalarField heights
    (
        requestedHeights
        (
            makeLayerSpacing(wall, makeWallAddressing(wall), controls)
        )
    );

    ASSERT_EQ(heights.size(), 12*wall.points.size());
    forAll(heights, i)
    {
        const scalar exact = 1e-3*(std::pow(1.3, i % 12 + 1) - 1)/0.3;
        EXPECT_NEAR(heights[i]/exact, 1, 1e-12);
    }
}


TEST(layerColumns, offsetAtItsHeights)
{
    const layerColumns columns(oneColumn());

    for (label i = 0; i < 3; ++i)
    {
        EXPECT_EQ(offset(columns, columns.heights[i]), columns.offsets[i]);
    }
}


TEST(layerColumns, offsetIsLinearBetween)
{
    const layerColumns columns(oneColumn());

    EXPECT_NEAR(mag(offset(columns, 1.5) - vector(0.5, 0, 1)), 0, 1e-15);
    EXPECT_NEAR(mag(offset(columns, 3.5) - vector(2.5, 0, 1)), 0, 1e-15);
}


TEST(layerColumns, offsetIsConstantBeyond)
{
    const layerColumns columns(oneColumn());

    EXPECT_EQ(offset(columns, 0.1), vector(0, 0, 1));
    EXPECT_EQ(offset(columns, 9), vector(3, 0, 1));
}


TEST(layerColumns, areRadialOnASphere)
{
    const wallSurface wall(testSurfaces::sphere(16));
    const layerColumns columns(columnsOf(layeredMesh(wall, 6, 0.1)));

    forAll(columns.offsets, i)
    {
        EXPECT_GT
        (
            wall.points[i/6] & columns.offsets[i],
            std::cos(degToRad(2.0))*mag(columns.offsets[i])
        );
    }
}


TEST(layerColumns, areNormalToTheFacesOfACube)
{
    const wallSurface wall(testSurfaces::cube(12));
    const layerColumns columns(columnsOf(layeredMesh(wall, 6, 0.05)));

    forAll(columns.offsets, i)
    {
        const label p = i/6;

        if (awayFromEdges(wall.points[p], 0.2))
        {
            vector n(Zero);
            for (direction d = 0; d < 3; ++d)
            {
                n[d] = (wall.points[p][d] > 1 - 1e-9)
                  - (wall.points[p][d] < 1e-9);
            }

            EXPECT_GT
            (
                n & columns.offsets[i],
                std::cos(degToRad(3.0))*mag(columns.offsets[i])
            );
        }
    }
}


TEST(layerColumns, offsetsHaveUnitHeight)
{
    for (const wallSurface& wall :
        {testSurfaces::sphere(8), testSurfaces::lBlock(6)})
    {
        const prismLayerMesh m(layeredMesh(wall, 6, 0.1));
        const layerColumns columns(columnsOf(m));

        forAll(columns.offsets, i)
        {
            const vector& offset = columns.offsets[i];
            const scalar height = m.visibility.heightCosine(i/6, offset);

            // Less only where the bound on the stretch is reached
            EXPECT_TRUE
            (
                mag(height - 1) < 1e-12
             || (mag(mag(offset) - 2) < 1e-12 && height < 1)
            );
        }
    }
}


TEST(layerColumns, offsetsAreInTheCones)
{
    const wallSurface wall(testSurfaces::wedgeBlock(6, 45));
    const prismLayerMesh m(layeredMesh(wall, 6, 0.1));
    const layerColumns columns(columnsOf(m));

    forAll(columns.offsets, i)
    {
        for (const vector& n : m.visibility.cornerNormals[i/6])
        {
            EXPECT_GT(columns.offsets[i] & n, 0);
        }
    }
}


TEST(layerColumns, roomIsAllWhereNothingIsNear)
{
    const wallSurface wall(testSurfaces::lBlock(6));
    const prismLayerMesh m(layeredMesh(wall, 6, 0.1));
    const layerColumns columns(columnsOf(m));

    EXPECT_EQ(columns.maxThickness, m.guide.spacing.thickness);
    for (const squeezeCause cause : columns.causes)
    {
        EXPECT_EQ(cause, squeezeCause::none);
    }
}


TEST(layerColumns, roomInASlitIsItsShareOfHalfTheWidth)
{
    const scalar width = 0.1;
    const wallSurface wall(testSurfaces::slitBlock(10, width));
    const layerColumns columns(columnsOf(layeredMesh(wall, 6, 0.25)));
    label nInside = 0, nNeighbours = 0;

    forAll(wall.points, p)
    {
        const point& x = wall.points[p];
        nNeighbours += columns.causes[p] == squeezeCause::neighbour;

        if
        (
            mag(mag(x.x() - 1) - 0.5*width) < 1e-9
         && x.y() > 1.05 && x.y() < 1.95 && x.z() > 0.05 && x.z() < 0.95
        )
        {
            ++nInside;
            EXPECT_LE(columns.maxThickness[p], 0.95*0.5*width*(1 + 1e-5));
            EXPECT_GT(columns.maxThickness[p], 0.8*0.5*width);
            EXPECT_EQ(columns.causes[p], squeezeCause::gap);
        }
    }

    EXPECT_GT(nInside, 20);
    EXPECT_GT(nNeighbours, 0);
}


TEST(layerColumns, roomHasABoundedGradient)
{
    const wallSurface wall(testSurfaces::slitBlock(10, 0.1));
    const prismLayerMesh m(layeredMesh(wall, 6, 0.15));
    const layerColumns columns(columnsOf(m));

    for (const edge& e : m.addressing.edges)
    {
        EXPECT_LE
        (
            mag
            (
                columns.maxThickness[e.start()]
              - columns.maxThickness[e.end()]
            ),
            layerColumns::maxSlope*e.mag(wall.points) + 1e-14
        );
    }
}


TEST(layerColumns, causeIsNoneExactlyWhereTheRoomIsAll)
{
    const wallSurface wall(testSurfaces::slitBlock(10, 0.1));
    const prismLayerMesh m(layeredMesh(wall, 6, 0.15));
    const layerColumns columns(columnsOf(m));

    forAll(columns.maxThickness, p)
    {
        EXPECT_EQ
        (
            columns.causes[p] == squeezeCause::none,
            columns.maxThickness[p] == m.guide.spacing.thickness[p]
        );
    }
}


// ************************************************************************* //
