/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "editedColumns.H"
#include "layerGeometry.H"
#include "limitHeightJumps.H"
#include "retreatColumns.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The columns that are lowered
static labelList limited(editedColumns& m)
{
    const pointField before(m.editor.layers().points);
    limitHeightJumps(m.editor, neighboursOnWall(m.front));

    return movedColumns(m, before);
}


//- First heights of the faces of the wall
static scalarField lowestHeights(const editedColumns& m)
{
    scalarField heights(m.front.nWallFaces);
    stackHeights stack(m.editor.layers());

    forAll(heights, facei)
    {
        stack.compute(facei, 1);
        heights[facei] = stack.heights()[0];
    }

    return heights;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(limitHeightJumps, exactOnesStay)
{
    editedColumns m(testSurfaces::frontOf(testSurfaces::sphere(10), 0));

    EXPECT_TRUE(limited(m).empty());
}


TEST(limitHeightJumps, changesAreBoundedBesideSqueezedColumns)
{
    editedColumns m(testSurfaces::frontOf(testSurfaces::cube(16), 0));
    const wallAddressing& addressing = m.front.addressing;

    for (label i = 0; i < 8; ++i)
    {
        retreatColumns(m.editor, labelList(1, 100), squeezeCause::validity);
    }

    const auto largestChange = [&]()
    {
        const scalarField h(lowestHeights(m));
        scalar largest = 1;
        for (const labelPair& faces : addressing.edgeFaces)
        {
            const scalar a = h[faces.first()], b = h[faces.second()];
            largest = max(largest, max(a, b)/min(a, b));
        }

        return largest;
    };

    EXPECT_GT(largestChange(), 1.33);

    const pointField before(m.editor.layers().points);
    const labelList lowered(limited(m));
    const label n = m.spacing.nLayers;

    // Faces are not exactly as high as the mean of their columns
    limited(m);
    limited(m);

    EXPECT_LT(largestChange(), 1.3);
    EXPECT_FALSE(lowered.empty());

    for (const label c : lowered)
    {
        const prismLayers& layers = m.editor.layers();

        // The first layer is, the last point stays
        EXPECT_LT
        (
            mag(layers(c, 1) - layers(c, 0)),
            mag(before[layers.index(c, 1)] - layers(c, 0))
        );
        EXPECT_NEAR(mag(layers(c, n) - before[layers.index(c, n)]), 0, 1e-12);
        EXPECT_NE(m.editor.causes()[c], squeezeCause::none);
    }
}


TEST(limitHeightJumps, thoseRolledBackAreWhereTheyWere)
{
    editedColumns m(testSurfaces::frontOf(testSurfaces::cube(16), 0));

    for (label i = 0; i < 20; ++i)
    {
        retreatColumns(m.editor, labelList(1, 100), squeezeCause::validity);
    }

    const pointField before(m.editor.layers().points);
    const List<squeezeCause> causes(m.editor.causes());
    m.editor.record();
    const labelList lowered(limited(m));
    EXPECT_FALSE(lowered.empty());

    for (const label c : lowered)
    {
        m.editor.rollBack(c);
    }

    EXPECT_EQ(m.editor.layers().points, before);
    EXPECT_TRUE(m.editor.causes() == causes);
}


TEST(limitHeightJumps, columnsThatBendBackStay)
{
    const layerFront front(testSurfaces::frontOf(testSurfaces::cube(16), 0));
    editedColumns m(front);
    editedColumns bent(front);
    for (label i = 0; i < 8; ++i)
    {
        retreatColumns(m.editor, labelList(1, 100), squeezeCause::validity);
        retreatColumns(bent.editor, labelList(1, 100), squeezeCause::validity);
    }
    const labelList lowered(limited(m));
    ASSERT_FALSE(lowered.empty());

    // Their ends are behind the wall
    for (const label c : lowered)
    {
        const label n = bent.spacing.nLayers;
        const prismLayers& layers = bent.editor.layers();
        bent.editor.setPoint(c, n, 2*layers(c, 0) - layers(c, n));
    }
    EXPECT_TRUE(limited(bent).empty());
}


// ************************************************************************* //
