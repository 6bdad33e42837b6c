/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "invertCompact.H"
#include "labelPair.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

using namespace Foam;

TEST(invertCompact, hasTheRowsOfEachLabel)
{
    const List<labelList> rows({{3, 0}, {}, {0, 0, 2}});
    const CompactListList<label> inverse(invertCompact(5, rows));

    ASSERT_EQ(inverse.size(), 5);
    EXPECT_EQ(labelList(inverse[0]), labelList({0, 2, 2}));
    EXPECT_TRUE(inverse[1].empty());
    EXPECT_EQ(labelList(inverse[2]), labelList({2}));
    EXPECT_EQ(labelList(inverse[3]), labelList({0}));
    EXPECT_TRUE(inverse[4].empty());
}


TEST(invertCompact, ofNothingIsEmpty)
{
    EXPECT_EQ(invertCompact(0, List<labelPair>()).size(), 0);
}

// ************************************************************************* //
