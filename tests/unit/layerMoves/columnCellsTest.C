/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnCells.H"
#include "editedColumns.H"
#include "unitConversion.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;


//- A column that was moved aside, by a share of its height, after the heights
//  around it were kept
struct movedColumn
{
    editedColumns m;
    const label column;
    layerGeometry geometry;
    bendTargets targets;

    movedColumn
    (
        const layerFront& front,
        const faceTargets& faces,
        const scalar jacobian = 0
    )
    :
        m(front),
        column(m.nColumns()/2),
        geometry(m.editor.layers(), m.front.addressing)
    {
        targets.faces = faces;
        targets.jacobians.setSize(front.surface.faces.size(), jacobian);
        targets.firstHeightWeight = layerMoveControls().firstHeightWeight;
        targets.thicknessWeight = layerMoveControls().thicknessWeight;
        targets.keep(m.editor, labelList(1, column));
        moveBy(0.5*vector(1, 2, 3)/mag(vector(1, 2, 3)));
    }

    //- By a share of its height
    void moveBy(const vector& share)
    {
        for (label i = 1; i <= m.spacing.nLayers; ++i)
        {
            m.editor.setPoint
            (
                column, i,
                m.editor.layers()(column, i)
              + m.editor.heights(column)[i]*share
            );
        }
    }

    columnCells cells() const
    {
        return columnCells(m.editor, geometry, targets, column);
    }
};


//- Of triangles and of quadrilaterals
static List<layerFront> roundFronts()
{
    return List<layerFront>
    ({
        testSurfaces::frontOf(testSurfaces::sphere(4), 0),
        testSurfaces::frontOf(testSurfaces::quadSphere(4), 0)
    });
}


static scalar sumOfSquares(const UList<scalar>& all)
{
    scalar sum = 0;
    for (const scalar r : all)
    {
        sum += sqr(r);
    }
    return sum;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(columnCells, residualsAreAllThatAreNot0)
{
    const faceTargets steep{::cos(degToRad(30.0)), 0.5, 0.2};

    for (const layerFront& front : roundFronts())
    {
        const movedColumn one(front, steep, 0.7);
        columnCells cells(one.cells());
        const scalar sum = cells.evaluate();
        DynamicList<scalar> all;
        cells.linearise();
        cells.residuals(all);

        ASSERT_GT(sum, 0.1);
        EXPECT_NEAR(sumOfSquares(all), sum, 1e-12*sum);
    }
}


TEST(columnCells, residualsFollowAMove)
{
    const faceTargets steep{::cos(degToRad(10.0)), 0.1, 0.2};

    for (const layerFront& front : roundFronts())
    {
        // Further away, changes of faces and of heights nearly cancel
        movedColumn one(front, steep);
        one.moveBy(-0.3*vector(1, 2, 3)/mag(vector(1, 2, 3)));
        columnCells cells(one.cells());
        const scalar before = cells.evaluate();
        cells.linearise();
        one.moveBy(1e-4*vector(2, 1, 1));
        DynamicList<scalar> all;
        cells.residuals(all);
        const scalar change = cells.evaluate() - before;

        ASSERT_GT(mag(change), 1e-6*before);
        EXPECT_NEAR(sumOfSquares(all) - before, change, 0.02*mag(change));
    }
}


TEST(columnCells, residualsOfCellsFollowAMove)
{
    // Neither faces nor heights have targets: what is left is the cells and the
    // displacements
    for (const layerFront& front : roundFronts())
    {
        movedColumn one(front, faceTargets(), 1);
        for (const label facei : one.targets.heights.toc())
        {
            one.targets.heights[facei].clear();
        }
        columnCells cells(one.cells());
        const scalar before = cells.evaluate();
        DynamicList<scalar> all;
        cells.linearise();
        cells.residuals(all);
        ASSERT_NEAR(sumOfSquares(all), before, 1e-12*before);

        one.moveBy(1e-4*vector(2, 1, 1));
        cells.residuals(all);
        const scalar change = cells.evaluate() - before;

        ASSERT_GT(mag(change), 1e-7*before);
        EXPECT_NEAR(sumOfSquares(all) - before, change, 0.01*mag(change));
    }
}


TEST(columnCells, linearHeightsAreThoseOfSmallMoves)
{
    // Without targets of faces: heights and displacements are all there is
    for (const layerFront& front : roundFronts())
    {
        for (direction k = 0; k < vector::nComponents; ++k)
        {
            vector d(Zero);
            d[k] = 1e-4;
            movedColumn one(front, faceTargets{-1, GREAT});
            columnCells cells(one.cells());
            const scalar before = cells.evaluate();
            cells.linearise();
            one.moveBy(d);
            DynamicList<scalar> all;
            cells.residuals(all);
            const scalar change = cells.evaluate() - before;

            EXPECT_NEAR
            (
                sumOfSquares(all) - before, change, 0.1*mag(change) + 1e-6
            );
        }
    }
}


// ************************************************************************* //
