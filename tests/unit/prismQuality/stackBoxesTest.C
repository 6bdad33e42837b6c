/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerOverlaps.H"
#include "testLayers.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static prismLayers layersOnSphere()
{
    return testSurfaces::straightLayers
    (
        testSurfaces::sphere(8), scalarList({0, 0.1, 0.3})
    );
}


//- Whether the box of the group of each face has the face on both levels
static bool holdAll(const stackBoxes& groups, const prismLayers& layers)
{
    boolList isHeld(layers.faces.size(), false);
    forAll(groups.all(), group)
    {
        const boundBox& box = groups.all()[group];
        for (const label facei : groups.faces(group))
        {
            isHeld[facei] = box.contains(boxOf(layers, facei, 0))
             && box.contains(boxOf(layers, facei, layers.nLayers));
        }
    }

    return !isHeld.found(false);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(stackBoxes, holdTheirStacks)
{
    const prismLayers layers(layersOnSphere());
    const stackBoxes groups(layers);

    EXPECT_GT(groups.all().size(), 2);
    EXPECT_LT(groups.all().size(), layers.faces.size()/64);
    EXPECT_TRUE(holdAll(groups, layers));
}


TEST(stackBoxes, followStacksThatChange)
{
    prismLayers layers(layersOnSphere());
    stackBoxes groups(layers);
    const label facei = layers.faces.size()/2;
    for (const label c : layers.faces[facei])
    {
        layers.points[layers.index(c, layers.nLayers)] *= 2;
    }
    EXPECT_FALSE(holdAll(groups, layers));

    // Other faces have these columns, too
    groups.update(identity(layers.faces.size()));
    EXPECT_TRUE(holdAll(groups, layers));
    EXPECT_EQ(groups.all(), stackBoxes(layers).all());
}


// ************************************************************************* //
