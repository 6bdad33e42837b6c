/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerJudge.H"
#include "testLayers.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Two layers on a cube, and their judge
struct judgedLayers
{
    layerFront front = testSurfaces::frontOf(testSurfaces::cube(4), 0);
    prismLayers layers = testSurfaces::frontLayers(front, {0, 0.02, 0.05});
    layerMoveControls controls;
    layerJudge judge{layers, front.surface, front.visibility, controls};

    //- The column in the middle of the side z = 1
    label middle() const
    {
        return front.surface.points.find(point(0.5, 0.5, 1));
    }

    labelList around() const
    {
        labelList faces(front.addressing.pointFaces[middle()]);
        sort(faces);

        return faces;
    }

    point& end()
    {
        return layers.points[layers.index(middle(), 2)];
    }

    labelList faultyFaces(const stackFault first, const stackFault last) const
    {
        DynamicList<label> faces;
        for
        (
            const faultyStack& stack
          : judge.findFaults(identity(layers.faces.size()), first, last)
        )
        {
            EXPECT_EQ(stack.fault, judge.faultOf(stack.facei, first, last));
            faces.append(stack.facei);
        }

        return labelList(std::move(faces));
    }
};


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(layerJudge, goodLayersHaveNoFault)
{
    const judgedLayers j;

    EXPECT_TRUE(j.judge.findFaults(identity(j.layers.faces.size())).empty());
    EXPECT_TRUE
    (
        j.judge.findOverlapping
        (
            identity(j.layers.faces.size()), stackBoxes(j.layers),
            scalarField(j.layers.nColumns(), 0.1)
        ).empty()
    );
}


TEST(layerJudge, columnsNearToAFreeSideAreFound)
{
    // The layers end at z = 1.05
    judgedLayers j;
    sidePatch side;
    side.normal = vector(0, 0, 1);
    for (const scalar height : {1.06, 1.07})
    {
        side.origin = point(0, 0, height);
        j.controls.freeSides = List<sidePatch>(1, side);
        const labelList found
        (
            j.faultyFaces(stackFault::notPositive, stackFault::notPositive)
        );

        EXPECT_EQ(found.empty(), height > 1.065) << height;
        for (const label facei : j.around())
        {
            EXPECT_EQ(found.found(facei), height < 1.065);
        }
    }
}


TEST(layerJudge, cellsBelowTheAttainableAreFound)
{
    // The column leans so far over that its cells are flat, but positive
    judgedLayers j;
    j.end() += vector(0.24, 0.24, -0.0295);

    const labelList found
    (
        j.faultyFaces
        (
            stackFault::belowAttainable, stackFault::belowAttainable
        )
    );
    ASSERT_FALSE(found.empty());

    for (const label facei : found)
    {
        EXPECT_TRUE(j.around().found(facei));
        EXPECT_TRUE(j.judge.isBelowAttainable(facei, 0.05));
    }
}


TEST(layerJudge, cellsThatAreNotPositiveAreFound)
{
    judgedLayers j;
    j.end().z() = 1.01;

    EXPECT_EQ
    (
        j.faultyFaces(stackFault::notPositive, stackFault::notPositive),
        j.around()
    );
}


TEST(layerJudge, theCheapestFaultIsSaidFirst)
{
    judgedLayers j;
    j.end().z() = 1.01;
    const label facei = j.around()[0];

    EXPECT_EQ(j.judge.faultOf(facei), stackFault::belowAttainable);
    EXPECT_EQ
    (
        j.judge.faultOf
        (
            facei, stackFault::notPositive, stackFault::centreOutside
        ),
        stackFault::notPositive
    );
}


TEST(layerJudge, saysTheSameAsOftenAsItIsAsked)
{
    judgedLayers j;
    j.end() = point(0.5, 0.5, 0.5);
    const stackFault kind = stackFault::centreOutside;
    const labelList first(j.faultyFaces(kind, kind));
    ASSERT_FALSE(first.empty());

    for (label i = 0; i < 2*j.controls.maxCentreTries; ++i)
    {
        EXPECT_EQ(j.faultyFaces(kind, kind), first);
    }
}


TEST(layerJudge, overlapsAreFoundFromEitherFace)
{
    // Two cubes whose layers meet
    const wallSurface cube(testSurfaces::cube(2));
    const layerFront front
    (
        testSurfaces::frontOf
        (
            testSurfaces::merge
            (
                cube, testSurfaces::translated(cube, vector(1.05, 0.1, 0.1))
            ),
            0
        )
    );
    const prismLayers layers(testSurfaces::frontLayers(front, {0, 0.04}));
    const layerMoveControls controls;
    const layerJudge judge(layers, front.surface, front.visibility, controls);
    const label n = front.surface.faces.size();
    scalarField thickness(layers.nColumns(), 0.04);
    thickness.last() = 0.05;
    const auto stacksOf = [&](const labelUList& faces)
    {
        labelHashSet stacks;
        for
        (
            const overlappingStack& stack
          : judge.findOverlapping(faces, stackBoxes(layers), thickness)
        )
        {
            EXPECT_GE(stack.tallest, 0.04);
            stacks.insert(stack.facei);
        }

        return stacks;
    };
    const labelHashSet all(stacksOf(identity(n)));
    ASSERT_FALSE(all.empty());

    for (const label facei : all)
    {
        const labelHashSet with(stacksOf(labelList(1, facei)));
        EXPECT_TRUE(with.found(facei));
        EXPECT_GT(with.size(), 1);
    }
    EXPECT_TRUE(stacksOf(labelList()).empty());
}


TEST(layerJudge, attainableShares)
{
    const judgedLayers j;
    const labelList all(identity(j.layers.faces.size()));

    EXPECT_TRUE(j.judge.findBelowAttainable(all, 0.3).empty());
    EXPECT_EQ(j.judge.findBelowAttainable(all, 10), all);
}


// ************************************************************************* //
