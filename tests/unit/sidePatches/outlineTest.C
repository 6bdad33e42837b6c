/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sidePatch.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

using namespace Foam;

TEST(outline, ofAClosedSurfaceIsEmpty)
{
    EXPECT_TRUE(outline(testSurfaces::cube(4).faces).empty());
    EXPECT_TRUE(outline(faceList()).empty());
}


TEST(outline, runsAsTheFacesDoInTheirOrder)
{
    // Two triangles, a quadrangle apart from them, and labels in between that
    // no face has
    const faceList faces
    (
        {face({0, 1, 2}), face({9, 8, 7, 6}), face({2, 1, 4})}
    );
    const edgeList expected
    ({
        edge(0, 1), edge(2, 0), edge(9, 8), edge(8, 7), edge(7, 6), edge(6, 9),
        edge(1, 4), edge(4, 2)
    });

    const edgeList found(outline(faces));
    ASSERT_EQ(found.size(), expected.size());
    forAll(found, i)
    {
        EXPECT_EQ(found[i].start(), expected[i].start());
        EXPECT_EQ(found[i].end(), expected[i].end());
    }
}


TEST(outline, hasNoEdgeOfThreeFaces)
{
    const faceList faces({face({0, 1, 2}), face({1, 0, 3}), face({0, 1, 4})});

    for (const edge& e : outline(faces))
    {
        EXPECT_FALSE(e == edge(0, 1));
    }
    EXPECT_EQ(outline(faces).size(), 6);
}

// ************************************************************************* //
