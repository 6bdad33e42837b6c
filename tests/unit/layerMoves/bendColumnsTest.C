/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bendColumns.H"
#include "editedColumns.H"
#include "layerGeometry.H"
#include "scaledJacobian.H"
#include "unitConversion.H"

#include <gtest/gtest.h>
#include <omp.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static bool never(label)
{
    return false;
}


//- Layers one column of which was moved aside, by a share of its height.
//  Without that, faces around it have less than 60 degrees.
struct leaningColumn
{
    static constexpr label column = 30;

    editedColumns m;
    editedGeometry geometry;
    bendTargets targets;

    explicit leaningColumn(const scalar share = 1)
    :
        m(fronts()[0]),
        geometry(m.editor)
    {
        targets.faces = faceTargets{::cos(degToRad(60.0)), 3};
        targets.firstHeightWeight = layerMoveControls().firstHeightWeight;
        targets.thicknessWeight = layerMoveControls().thicknessWeight;
        targets.keep(m.editor, labelList(1, column));

        const scalar* heights = m.editor.heights(column);
        for (label i = 1; i <= 4; ++i)
        {
            m.editor.setPoint
            (
                column, i,
                m.editor.layers()(column, i)
              + share*heights[i]*across()
            );
        }
        m.editor.touch(column);
    }

    vector across() const
    {
        return normalised
        (
            m.front.visibility.cones[column].axis ^ vector(1, 2, 3)
        );
    }

    scalar violation()
    {
        scalar sum = 0;
        for (const label facei : m.front.addressing.pointFaces[column])
        {
            sum += geometry.now().violation(facei, targets.faces);
        }
        return sum;
    }

    labelList bend(const std::function<bool(label)>& isAtFault = never)
    {
        return bendColumns
        (
            m.editor, geometry, targets, labelList(1, column), isAtFault
        );
    }
};


//- The smallest scaled Jacobian around a column that was moved aside and bends
//  for nothing but a target of scaled Jacobians
static scalar worstJacobianAfterBends(const scalar target)
{
    leaningColumn one;
    const layerFront& front = one.m.front;

    // The place to stay at, and the heights to keep, are where it is now
    one.targets = bendTargets();
    one.targets.keep(one.m.editor, labelList(1, leaningColumn::column));
    one.targets.jacobians.setSize(front.surface.faces.size(), target);

    for (label i = 0; i < 10; ++i)
    {
        one.bend();
    }

    scalar worst = GREAT;
    for
    (
        const label facei
      : front.addressing.pointFaces[leaningColumn::column]
    )
    {
        worst = min(worst, worstJacobian(one.m.editor.layers(), facei));
    }

    return worst;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(bendColumns, columnComesBackFromASide)
{
    leaningColumn one;
    const scalar before = one.violation();
    ASSERT_GT(before, 0.1);

    for (label i = 0; i < 10 && one.violation() > 0; ++i)
    {
        EXPECT_EQ(one.bend(), labelList(1, leaningColumn::column));
    }

    EXPECT_LT(one.violation(), 1e-3*before);
}


TEST(bendColumns, columnComesBackToBetterCells)
{
    EXPECT_LT(worstJacobianAfterBends(0), 0);

    // Its displacement and excess heights hold it back from the target
    EXPECT_GT(worstJacobianAfterBends(0.3), 0.15);
}


TEST(bendColumns, heightsAreHeld)
{
    leaningColumn one;
    for (label i = 0; i < 10; ++i)
    {
        one.bend();
    }

    stackHeights stack(one.m.editor.layers());
    for
    (
        const label facei
      : one.m.front.addressing.pointFaces[leaningColumn::column]
    )
    {
        stack.compute(facei);
        EXPECT_NEAR
        (
            stack.heights()[0]/one.targets.heights[facei].first(), 1, 0.01
        );
        // The thickness has less weight
        EXPECT_NEAR
        (
            sum(stack.heights())/sum(one.targets.heights[facei]), 1, 0.03
        );
    }
}


TEST(bendColumns, goodColumnStays)
{
    leaningColumn one(0);

    EXPECT_TRUE(one.bend().empty());
}


TEST(bendColumns, columnAtFaultStays)
{
    leaningColumn one;
    const pointField before(one.m.editor.layers().points);
    const label then = one.m.editor.now();

    EXPECT_TRUE(one.bend([](label) { return true; }).empty());
    EXPECT_EQ(one.m.editor.layers().points, before);
    EXPECT_TRUE(one.m.editor.touchedSince(then).empty());
}


TEST(bendColumns, geometryFollows)
{
    leaningColumn one;
    one.bend();
    const layerGeometry anew
    (
        one.m.editor.layers(), one.m.front.addressing
    );

    forAll(one.m.front.surface.faces, facei)
    {
        EXPECT_EQ(one.geometry.now().centres(facei), anew.centres(facei));
    }
}


TEST(bendColumns, stacksAroundALeaningColumnMissTargets)
{
    leaningColumn one;
    const labelList all(identity(one.m.front.surface.faces.size()));

    const labelList stacks
    (
        stacksMissingTargets
        (
            one.m.editor.layers(), one.geometry.now(), all, one.targets
        )
    );
    const labelList columns(one.m.editor.layers().columnsOf(stacks));

    EXPECT_TRUE(columns.found(leaningColumn::column));
    EXPECT_LT(columns.size(), 40);
    EXPECT_FALSE(stacks.found(0));
}


TEST(bendColumns, numberOfThreadsChangesNothing)
{
    pointField points;
    const label nThreads = omp_get_max_threads();

    for (const label n : {1, 4})
    {
        omp_set_num_threads(n);
        editedColumns m(fronts()[2]);
        editedGeometry geometry(m.editor);
        bendTargets targets;
        targets.faces = faceTargets{::cos(degToRad(5.0)), 0.01};
        const labelList all(identity(m.nColumns()));
        targets.keep(m.editor, all);

        EXPECT_FALSE
        (
            bendColumns(m.editor, geometry, targets, all, never).empty()
        );
        if (n == 1)
        {
            points = m.editor.layers().points;
        }
        EXPECT_EQ(m.editor.layers().points, points);
    }

    omp_set_num_threads(nThreads);
}


// ************************************************************************* //
