/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planarColumns.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Two quadrilaterals between z = 0 and 1, one layer
prismLayers strip()
{
    prismLayers layers;
    layers.nLayers = 1;
    for (const scalar z : {0, 1})
    {
        for (label i = 0; i < 3; ++i)
        {
            layers.points.append(point(i, 0, z));
            layers.points.append(point(i, 0.1*(i + 1) + 0.01*z, z));
        }
    }
    layers.faces = {face({3, 4, 1, 0}), face({4, 5, 2, 1})};
    layers.patchIDs = {0, 0};

    layers.border.sides.setSize(2);
    forAll(layers.border.sides, s)
    {
        layers.border.sides[s].type = "empty";
        layers.border.sides[s].origin = point(0, 0, s);
        layers.border.sides[s].normal = vector(0, 0, 2*s - 1);
    }

    return layers;
}


labelList across(const prismLayers& layers)
{
    return columnsAcross(layers.faces, layers.border, layers.pointsOf(0));
}

} // End anonymous namespace

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(planarColumns, eachHasItsImageAcross)
{
    EXPECT_EQ(across(strip()), labelList({3, 4, 5, -1, -1, -1}));
}


TEST(planarColumns, imagesAreEqual)
{
    prismLayers layers(strip());
    makePlanar(across(layers), layers);

    for (label c = 0; c < 3; ++c)
    {
        EXPECT_EQ(layers(c + 3, 0), layers(c, 0) + vector(0, 0, 1));
        EXPECT_EQ(layers(c + 3, 1), layers(c, 1) + vector(0, 0, 1));
    }
}


TEST(planarColumns, noneWithoutEmptySides)
{
    prismLayers layers(strip());
    layers.border.sides[0].type = "symmetry";
    layers.border.sides[1].type = "symmetry";

    EXPECT_TRUE(across(layers).empty());
}


TEST(planarColumns, oneEmptySideIsRefused)
{
    prismLayers layers(strip());
    layers.border.sides[0].type = "symmetry";

    EXPECT_THROW(across(layers), Foam::error);
}


TEST(planarColumns, trianglesAreRefused)
{
    prismLayers layers(strip());
    layers.faces[1] = face({4, 5, 2});

    EXPECT_THROW(across(layers), Foam::error);
}


// ************************************************************************* //
