/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cornerPoints.H"
#include "outlines.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Whether two lists are the same but for where they start
static bool isTurned(const labelList& a, const labelList& b)
{
    const label start = b.find(a[0]);
    bool same = a.size() == b.size() && start >= 0;
    forAll(a, k)
    {
        same = same && a[k] == b[(start + k) % b.size()];
    }

    return same;
}


static List<labelList> outlinesOf(const List<cornerQuad>& quads)
{
    DynamicList<labelList> outlines;
    outlineFinder find;
    find(quads, [&](const labelUList& outline) { outlines.append(outline); });

    return List<labelList>(std::move(outlines));
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(outlines, aRingAroundAPointLosesThePoint)
{
    // Three quadrilaterals around point 0: edges to 1, 2, 3; faces 4, 5, 6
    const List<labelList> outlines
    (
        outlinesOf
        (
            List<cornerQuad>
            ({
                cornerQuad({0, 1, 4, 2}), cornerQuad({0, 2, 5, 3}),
                cornerQuad({0, 3, 6, 1})
            })
        )
    );

    ASSERT_EQ(outlines.size(), 1);
    EXPECT_TRUE(isTurned(outlines[0], labelList({1, 4, 2, 5, 3, 6})));
}


TEST(outlines, anOpenFanKeepsThePoint)
{
    const List<labelList> outlines
    (
        outlinesOf
        (
            List<cornerQuad>
            ({
                cornerQuad({0, 2, 5, 3}), cornerQuad({0, 1, 4, 2})
            })
        )
    );

    ASSERT_EQ(outlines.size(), 1);
    EXPECT_TRUE(isTurned(outlines[0], labelList({0, 1, 4, 2, 5, 3})));
}


TEST(outlines, partsThatDoNotTouchAreTwo)
{
    const List<labelList> outlines
    (
        outlinesOf
        (
            List<cornerQuad>
            ({
                cornerQuad({0, 1, 4, 2}), cornerQuad({7, 8, 9, 10})
            })
        )
    );

    EXPECT_EQ(outlines.size(), 2);
}


TEST(outlines, haveEachPointOnce)
{
    // Two quadrilaterals that touch in a point
    const List<labelList> outlines
    (
        outlinesOf
        (
            List<cornerQuad>
            ({
                cornerQuad({0, 1, 2, 3}), cornerQuad({2, 4, 5, 6})
            })
        )
    );

    ASSERT_EQ(outlines.size(), 2);
    EXPECT_EQ(outlines[0].size(), 4);
    EXPECT_EQ(outlines[1].size(), 4);
}


TEST(innerWeights, anAcuteTriangleHasItsCircumcentre)
{
    const FixedList<point, 3> corners
    ({
        point(0, 0, 0), point(1, 0, 0), point(0.5, 0.8, 0)
    });
    const auto w(innerWeights(corners, 0.1));
    const point centre(w[0]*corners[0] + w[1]*corners[1] + w[2]*corners[2]);

    EXPECT_NEAR(mag(centre - corners[0]), mag(centre - corners[1]), 1e-15);
    EXPECT_NEAR(mag(centre - corners[0]), mag(centre - corners[2]), 1e-15);
}


TEST(innerWeights, aTetrahedronHasItsCircumcentre)
{
    const FixedList<point, 4> corners
    ({
        point(0, 0, 0), point(1, 0, 0), point(0.5, 0.9, 0),
        point(0.5, 0.3, 0.8)
    });
    const auto w(innerWeights(corners, 0.1));
    point centre(Zero);
    forAll(corners, k)
    {
        centre += w[k]*corners[k];
    }

    for (label k = 1; k < 4; ++k)
    {
        EXPECT_NEAR(mag(centre - corners[0]), mag(centre - corners[k]), 1e-15);
    }
}


TEST(innerWeights, haveAShareOfThoseOfTheCentroid)
{
    // The circumcentre of an obtuse triangle is outside
    const FixedList<point, 3> corners
    ({
        point(0, 0, 0), point(4, 0, 0), point(2, 0.5, 0)
    });
    const auto w(innerWeights(corners, 0.3));

    EXPECT_NEAR(min(w[0], min(w[1], w[2])), 0.3/3, 1e-15);
    EXPECT_NEAR(w[0] + w[1] + w[2], 1, 1e-15);
    for (const scalar x : innerWeights(corners, 1))
    {
        EXPECT_EQ(x, 1.0/3);
    }
}


// ************************************************************************* //
