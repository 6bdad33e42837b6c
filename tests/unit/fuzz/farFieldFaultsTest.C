/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boxSides.H"
#include "farFieldFaults.H"
#include "memoryMesh.H"
#include "testFarField.H"
#include "testStages.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

#include <memory>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Layers on a sphere, and hexahedra in a box around them
struct sphereInBox
{
    const wallSurface wall;
    prismLayers layers;
    fuzzFarField asked;
    std::unique_ptr<memoryMesh> memory;

    sphereInBox()
    :
        wall(testSurfaces::sphere(5))
    {
        const prismLayerMesh run(testSurfaces::layeredMesh(wall, 3, 0.1));
        layers = run.made.layers;

        const boundBox box(point::uniform(-4), point::uniform(4));
        asked.controls.type = farFieldType::hexCore;
        asked.controls.boundary.type = farBoundaryType::box;
        asked.controls.boundary.box = box;
        for (const sidePatch& side : sidesOf(box))
        {
            asked.planes.append(side);
            asked.planePatches.append(wordList(1, side.name));
        }
        memory.reset
        (
            new memoryMesh(layers, farFieldOf(run, asked.controls))
        );
    }

    std::string fault() const
    {
        return findFarFieldFault({wall, layers, asked, (*memory)()});
    }

    void expectFault(const char* what) const
    {
        EXPECT_NE(fault().find(what), std::string::npos) << fault();
    }
};


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(farFieldFaults, aGoodMeshHasNone)
{
    EXPECT_EQ(sphereInBox().fault(), "");
}


TEST(farFieldFaults, facesOutOfTheDomain)
{
    sphereInBox c;
    c.asked.planes[1].origin.x() = 5;
    c.expectFault("the patch xMax is in no plane");
}


TEST(farFieldFaults, patchesOfOtherPlanes)
{
    sphereInBox c;
    c.asked.planePatches[3] = wordList(1, "outlet");
    c.expectFault("the patch yMax is in the wrong plane");
}


TEST(farFieldFaults, fluidOnTheWrongSide)
{
    sphereInBox c;
    c.asked.fluidInside = true;
    c.expectFault("the wall leaves 0");
}


TEST(farFieldFaults, otherLayersThanThoseOfTheMesh)
{
    sphereInBox c;
    for (point& x : c.layers.points)
    {
        x *= 1 + 1e-7;
    }
    c.expectFault("layers leave");
}


TEST(farFieldFaults, zonesOfAnotherMesh)
{
    sphereInBox c;
    c.asked.controls.type = farFieldType::mesh;
    c.expectFault("cells have left the zone of all");
}


// ************************************************************************* //
