/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "memoryMesh.H"
#include "SubField.H"
#include "wedgeMesh.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Two hexahedra beside each other between z = 0 and 0.5, from y = lowest to 1
prismLayers twoHexahedra(const scalar lowest)
{
    prismLayers layers;
    layers.nLayers = 1;
    for (const scalar z : {0.0, 0.5})
    {
        for (label i = 0; i < 3; ++i)
        {
            layers.points.append(point(i, lowest, z));
            layers.points.append(point(i, 1, z));
        }
    }
    layers.faces = {face({3, 4, 1, 0}), face({4, 5, 2, 1})};
    layers.patchIDs = {0, 0};
    layers.patchNames = {"axis"};

    layers.border.sides.setSize(2);
    forAll(layers.border.sides, s)
    {
        layers.border.sides[s].name = s ? "back" : "front";
        layers.border.sides[s].type = "empty";
        layers.border.sides[s].origin = point(0, 0, 0.5*s);
        layers.border.sides[s].normal = vector(0, 0, 2*s - 1);
    }
    layers.border.edges = {edge(1, 0), edge(2, 1), edge(3, 4), edge(4, 5)};
    layers.border.edgeSides = {0, 0, 1, 1};

    return layers;
}


planarControls aWedge()
{
    planarControls controls;
    controls.thickness = 0.5;
    controls.wedgeAngle = 0.1;

    return controls;
}


scalar volumeOf(const polyMesh& mesh)
{
    return sum(mesh.cellVolumes());
}

} // End anonymous namespace

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(wedgeMesh, cellsOnTheAxisEndInAnEdge)
{
    memoryMesh memory(twoHexahedra(0));
    polyMesh& mesh = memory.edited();
    makeWedge(aWedge(), mesh);

    EXPECT_EQ(mesh.nCells(), 2);
    EXPECT_EQ(mesh.nPoints(), 9);
    EXPECT_NEAR(volumeOf(mesh), ::sin(0.1), 1e-14);
    EXPECT_EQ(mesh.boundaryMesh().findPatchID("axis"), -1);
    for (const char* name : {"front", "back"})
    {
        const polyPatch& side = mesh.boundaryMesh()[name];
        EXPECT_EQ(side.type(), "wedge");
        EXPECT_EQ(side.size(), 2);
        EXPECT_NEAR(mag(sum(vectorField(side.faceAreas()))), 2, 1e-14);
    }
    EXPECT_FALSE(mesh.checkMesh(false));
}


TEST(wedgeMesh, beyondTheAxisAllFacesStay)
{
    memoryMesh memory(twoHexahedra(0.5));
    polyMesh& mesh = memory.edited();
    const label nFaces = mesh.nFaces();
    makeWedge(aWedge(), mesh);

    EXPECT_EQ(mesh.nPoints(), 12);
    EXPECT_EQ(mesh.nFaces(), nFaces);
    EXPECT_EQ(mesh.boundaryMesh()["axis"].size(), 2);
    EXPECT_NEAR(volumeOf(mesh), (1 - sqr(0.5))*::sin(0.1), 1e-14);
}


TEST(wedgeMesh, aPointBeyondTheAxisIsRefused)
{
    memoryMesh memory(twoHexahedra(-0.1));

    EXPECT_THROW(makeWedge(aWedge(), memory.edited()), Foam::error);
}


// ************************************************************************* //
