/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshCell.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

namespace
{

//- A tetrahedron of volume 1/6
const pointField corners
({
    point(0, 0, 0), point(1, 0, 0), point(0, 1, 0), point(0, 0, 1)
});

cellCorners::factsOfAll factsOf
(
    const labelList& labels,
    const labelList& starts
)
{
    cellCorners cell(corners);
    cell.set(labels, starts);

    return cell.facts();
}

} // End anonymous namespace


TEST(cellCorners, tetrahedronIsPositiveAndItsMirrorImageIsNot)
{
    const labelList starts({0, 3, 6, 9, 12});
    const cellCorners::factsOfAll outwards
    (
        factsOf({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, starts)
    );
    const cellCorners::factsOfAll inwards
    (
        factsOf({0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2}, starts)
    );

    EXPECT_EQ(outwards.nPoints, 4);
    EXPECT_TRUE(outwards.closed && outwards.simple && outwards.positive);
    EXPECT_FALSE(outwards.within);
    EXPECT_TRUE(inwards.closed);
    EXPECT_FALSE(inwards.positive);
}


TEST(cellCorners, cellWithoutAFaceOrWithoutFacesIsOpen)
{
    EXPECT_FALSE(factsOf({0, 2, 1, 0, 1, 3, 0, 3, 2}, {0, 3, 6, 9}).closed);
    EXPECT_FALSE(factsOf({}, {0}).closed);
}


TEST(cellCorners, boundsAreOfTheCellAlone)
{
    cellCorners cell(corners);
    cell.set(labelList({0, 1, 2}), labelList({0, 3}));

    EXPECT_EQ(cell.bounds(), boundBox(point::zero, point(1, 1, 0)));
}


// ************************************************************************* //
