/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshCertificate.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- A cube on the wall z = 0, cell 0, and on it two halves of a cube
class cubeUnderHalves
{
    const pointField points_ = pointField
    ({
        {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
        {0, 0, 1}, {0.5, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0.5, 1, 1}, {0, 1, 1},
        {0, 0, 2}, {0.5, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0.5, 1, 2}, {0, 1, 2}
    });
    const faceList faces_ = faceList
    ({
        face({4, 5, 8, 9}), face({5, 6, 7, 8}), face({5, 8, 14, 11}),
        face({0, 3, 2, 1}), face({0, 1, 6, 5, 4}), face({1, 2, 7, 6}),
        face({2, 3, 9, 8, 7}), face({3, 0, 4, 9}),
        face({4, 5, 11, 10}), face({8, 9, 15, 14}), face({9, 4, 10, 15}),
        face({10, 11, 14, 15}),
        face({5, 6, 12, 11}), face({6, 7, 13, 12}), face({7, 8, 14, 13}),
        face({11, 12, 13, 14})
    });
    const labelList owner_ =
        labelList({0, 0, 1, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2});
    const labelList neighbour_ = labelList({1, 2, 2});

public:

    const polyhedralMesh mesh =
        polyhedralMesh(points_, faces_, owner_, neighbour_);

    //- The faces z = 0 and x = 1 of the cube
    static constexpr label bottom = 3;
    static constexpr label right = 5;

    const bitSet halves = bitSet(3, labelList({1, 2}));
};


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(meshCertificate, aLastCellMayHaveSeveralFacesToThoseBeyond)
{
    const cubeUnderHalves cube;
    const auto count = [&](const bitSet& beyondLayers)
    {
        const meshCertificate certificate
        (
            certifyMesh(cube.mesh, labelList({cube.bottom}), {}, beyondLayers)
        );
        EXPECT_TRUE(certificate.invalidCells.empty());

        return certificate.nLayers[0];
    };

    EXPECT_EQ(count(cube.halves), 1);

    // One of them may be in the layers, and then they are not complete
    bitSet half(cube.halves);
    half.unset(1);
    EXPECT_EQ(count(half), 0);
    EXPECT_EQ(count(bitSet()), 0);
}


TEST(isBelowLayers, sidesOfLayersAreNot)
{
    const cubeUnderHalves cube;

    EXPECT_TRUE(isBelowLayers(cube.mesh, cube.bottom, cube.halves, bitSet()));
    EXPECT_FALSE(isBelowLayers(cube.mesh, cube.right, cube.halves, bitSet()));
}


TEST(isBelowLayers, facesAreThatStacksJoinWithTheOuterSurface)
{
    // A stack goes through both halves, from x = 0 to x = 1
    const cubeUnderHalves cube;
    const label from = 10;
    const label to = 13;
    const bitSet outer(cube.mesh.faces().size(), labelList({to}));

    EXPECT_TRUE(isBelowLayers(cube.mesh, from, bitSet(), outer));
    EXPECT_FALSE(isBelowLayers(cube.mesh, from, bitSet(), bitSet()));
}


TEST(isBelowLayers, facesBeyondLayersAreNot)
{
    const cubeUnderHalves cube;
    const label top = 15;

    EXPECT_FALSE(isBelowLayers(cube.mesh, top, cube.halves, bitSet()));
}


// ************************************************************************* //
