/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "movableColumns.H"
#include "stackHeights.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static labelList evened(movableColumns& m)
{
    DynamicList<label> moved;
    m.moving.even([&](const label c) { moved.append(c); });

    return labelList(std::move(moved));
}


//- First heights of the faces of the wall
static scalarField firstHeights(const movableColumns& m)
{
    scalarField heights(m.front.nWallFaces);
    stackHeights stack(m.moving.layers());

    forAll(heights, facei)
    {
        stack.compute(facei, 1);
        heights[facei] = stack.heights()[0];
    }

    return heights;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(eveningColumns, exactOnesStay)
{
    movableColumns m(testSurfaces::frontOf(testSurfaces::sphere(10), 0));

    EXPECT_TRUE(evened(m).empty());
}


TEST(eveningColumns, changesAreBoundedBesideSqueezedColumns)
{
    movableColumns m(testSurfaces::frontOf(testSurfaces::cube(16), 0));
    const wallAddressing& addressing = m.front.addressing;

    for (label i = 0; i < 8; ++i)
    {
        m.moving.retreat(labelList(1, 100), squeezeCause::validity);
    }

    const auto largestChange = [&]()
    {
        const scalarField h(firstHeights(m));
        scalar largest = 1;
        for (const labelPair& faces : addressing.edgeFaces)
        {
            const scalar a = h[faces.first()], b = h[faces.second()];
            largest = max(largest, max(a, b)/min(a, b));
        }

        return largest;
    };

    EXPECT_GT(largestChange(), 1.33);

    const pointField before(m.moving.layers().points);
    const labelList lowered(evened(m));
    const label n = m.spacing.nLayers;

    // Faces are not exactly as high as the mean of their columns
    evened(m);
    evened(m);

    EXPECT_LT(largestChange(), 1.3);
    EXPECT_FALSE(lowered.empty());

    for (const label c : lowered)
    {
        const prismLayers& layers = m.moving.layers();

        // The first layer is, the last point stays
        EXPECT_LT
        (
            mag(layers(c, 1) - layers(c, 0)),
            mag(before[layers.index(c, 1)] - layers(c, 0))
        );
        EXPECT_NEAR(mag(layers(c, n) - before[layers.index(c, n)]), 0, 1e-12);
        EXPECT_NE(m.columns.causes[c], squeezeCause::none);
    }
}


TEST(eveningColumns, restoredOnesAreWhereTheyWere)
{
    movableColumns m(testSurfaces::frontOf(testSurfaces::cube(16), 0));

    for (label i = 0; i < 20; ++i)
    {
        m.moving.retreat(labelList(1, 100), squeezeCause::validity);
    }

    const pointField before(m.moving.layers().points);
    const List<squeezeCause> causes(m.columns.causes);
    List<movingColumns::posture> postures(m.nColumns());
    DynamicList<label> moved;

    m.moving.even
    (
        [&](const label c)
        {
            postures[c] = m.moving.postureOf(c);
            moved.append(c);
        }
    );
    EXPECT_NE(m.moving.layers().points, before);

    for (const label c : moved)
    {
        m.moving.restore(c, postures[c]);
    }

    EXPECT_EQ(m.moving.layers().points, before);
    EXPECT_TRUE(m.columns.causes == causes);
}


// ************************************************************************* //
