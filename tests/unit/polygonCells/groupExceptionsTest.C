/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "groupExceptions.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Corners of a group, corner i at x = i but for the first one, which is at 10
static groupExceptions dividedRow(const UList<labelPair>& beside)
{
    const labelList corners({20, 21, 22, 23});
    const List<vector> places
    ({
        vector(10, 0, 0), vector(1, 0, 0), vector(2, 0, 0), vector(3, 0, 0)
    });
    groupExceptions exceptions;
    exceptions.divide(corners, places, beside);

    return exceptions;
}

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(groupExceptions, aGroupIsDividedBetweenTheCornersFurthestApart)
{
    const groupExceptions row
    (
        dividedRow
        (
            List<labelPair>({labelPair(0, 1), labelPair(1, 2), labelPair(2, 3)})
        )
    );
    EXPECT_EQ(row.part(21), row.part(22));
    EXPECT_EQ(row.part(22), row.part(23));
    EXPECT_NE(row.part(20), row.part(21));
    EXPECT_EQ(row.part(24), -1);
}


TEST(groupExceptions, aSideThatIsNotConnectedIsTwoParts)
{
    const groupExceptions row
    (
        dividedRow(List<labelPair>({labelPair(0, 3), labelPair(1, 2)}))
    );

    EXPECT_EQ(row.part(21), row.part(22));
    EXPECT_NE(row.part(22), row.part(23));
}


TEST(groupExceptions, cornersThatAreNotApartBecomeOnePartEach)
{
    groupExceptions exceptions;
    exceptions.divide
    (
        labelList({7, 8}), List<vector>(2, vector::one),
        List<labelPair>(1, labelPair(0, 1))
    );

    EXPECT_NE(exceptions.part(7), exceptions.part(8));
}

// ************************************************************************* //
