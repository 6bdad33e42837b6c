/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "memoryMesh.H"
#include "openSurfaces.H"
#include "testLayers.H"
#include "testStages.H"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const label nLayers = 3;


//- A wall that ends on side patches, its layers, and their mesh
struct endedMesh
{
    std::string name;
    wallSurface wall;
    prismLayerMesh run;
    std::unique_ptr<memoryMesh> memory;


    endedMesh(const std::string& n, const wallSurface& w)
    :
        name(n),
        wall(w),
        run(layeredMesh(wall, nLayers, 0.1))
    {
        prismLayers layers(run.made.layers);
        memory.reset(new memoryMesh(layers));
    }


    const polyMesh& mesh() const { return (*memory)(); }
    const prismLayers& layers() const { return run.made.layers; }
};


//- Made once: all tests look at the same
static const std::vector<endedMesh>& endedMeshes()
{
    static std::vector<endedMesh> list;

    if (list.empty())
    {
        list.reserve(5);
        list.emplace_back("half sphere", endedOn(halfSphere(6), halfPlanes()));
        list.emplace_back("half cube", endedOn(halfCube(4), halfPlanes()));
        list.emplace_back
        (
            "quarter cube", endedOn(quarterCube(4), quarterPlanes())
        );
        list.emplace_back
        (
            "duct", endedOn(duct(4), wordList({"inlet", "outlet"}))
        );
        list.emplace_back
        (
            "hollow",
            endedOn(reversed(halfSphere(6)), halfPlanes(), false)
        );
    }

    return list;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(endedMesh, allLayersAreFullAndCertified)
{
    for (const endedMesh& m : endedMeshes())
    {
        EXPECT_TRUE(m.run.certificate.valid()) << m.name;
        EXPECT_EQ(m.run.certificate.nCells, nLayers*m.wall.faces.size());
        EXPECT_EQ(m.run.guide.fields.failure, "");

        for (const squeezeCause cause : m.run.made.causes)
        {
            EXPECT_EQ(int(cause), 0) << m.name;
        }
    }
}


TEST(endedMesh, columnsOnSidePatchesAreInTheirPlanes)
{
    for (const endedMesh& m : endedMeshes())
    {
        const wallBorder& border = m.layers().border;
        ASSERT_TRUE(border.edges == m.wall.border.edges) << m.name;

        forAll(border.edges, i)
        {
            const sidePatch& side = border.sides[border.edgeSides[i]];
            const edge& e = border.edges[i];

            for (label k = 0; k <= nLayers; ++k)
            {
                EXPECT_NEAR(side.distance(m.layers()(e[0], k)), 0, 1e-12);
                EXPECT_NEAR(side.distance(m.layers()(e[1], k)), 0, 1e-12);
            }
        }
    }
}


TEST(endedMesh, columnsOnTwoPlanesAreOnTheirLine)
{
    const endedMesh& m = endedMeshes()[2];
    label n = 0;

    forAll(m.wall.points, c)
    {
        const point& x = m.wall.points[c];
        if (x.y() == 0 && x.z() == 0)
        {
            const point& top = m.layers()(c, nLayers);
            EXPECT_NEAR(top.y(), 0, 1e-12);
            EXPECT_NEAR(top.z(), 0, 1e-12);
            // The end of the body is normal to the line
            EXPECT_NEAR(mag(top.x() - x.x()), 0.1, 1e-3);
            ++n;
        }
    }

    EXPECT_EQ(n, 2);
}


TEST(endedMesh, otherColumnsAreInTheFluid)
{
    for (const endedMesh& m : endedMeshes())
    {
        const Map<labelPair> onBorder(m.layers().border.pointSides());

        for (label c = 0; c < m.layers().nColumns(); ++c)
        {
            for (const sidePatch& side : m.layers().border.sides)
            {
                EXPECT_TRUE
                (
                    onBorder.found(c)
                 || side.distance(m.layers()(c, nLayers)) < -1e-3
                );
            }
        }
    }
}


TEST(endedMesh, sidePatchesHaveTheSidesOfTheLayers)
{
    for (const endedMesh& m : endedMeshes())
    {
        const polyBoundaryMesh& patches = m.mesh().boundaryMesh();
        const wallBorder& border = m.wall.border;
        const wordList names(sidePatchNames(border));
        ASSERT_EQ(patches.size(), 2 + names.size()) << m.name;
        EXPECT_EQ(patches[0].type(), "wall");
        EXPECT_EQ(patches[0].size(), m.wall.faces.size());
        EXPECT_EQ(patches[1].name(), layerOuterName);
        EXPECT_EQ(patches[1].size(), m.wall.faces.size());

        forAll(names, i)
        {
            const polyPatch& patch = patches[2 + i];
            EXPECT_EQ(patch.name(), names[i]) << m.name;
            EXPECT_EQ(patch.type(), border.sides[i].type) << m.name;
            EXPECT_EQ(patch.size(), nLayers*nEdgesOn(border, i)) << m.name;

            for (const vector& n : patch.faceNormals())
            {
                EXPECT_LT(mag(n - border.sides[i].normal), 1e-9) << m.name;
            }
        }
    }
}


TEST(endedMesh, isClosedAndSound)
{
    for (const endedMesh& m : endedMeshes())
    {
        EXPECT_FALSE(m.mesh().checkTopology(false)) << m.name;
        EXPECT_FALSE(m.mesh().checkUpperTriangular(false)) << m.name;
        EXPECT_FALSE(m.mesh().checkClosedBoundary(false)) << m.name;
        EXPECT_FALSE(m.mesh().checkClosedCells(false)) << m.name;
        EXPECT_FALSE(m.mesh().checkFacePyramids(false)) << m.name;
        EXPECT_GT(min(m.mesh().cellVolumes()), 0) << m.name;
    }
}


TEST(endedMesh, heightsAreAsAskedAlsoOnTheBorder)
{
    // On the half sphere, along the normal of its facets
    const endedMesh& m = endedMeshes()[0];

    for (label c = 0; c < m.layers().nColumns(); ++c)
    {
        EXPECT_NEAR(mag(m.layers()(c, nLayers)), 1.1, 4e-3);
    }
}


TEST(endedMesh, turnedFileGivesTheSameLayers)
{
    const prismLayerMesh turned
    (
        layeredMesh
        (
            endedOn(reversed(halfCube(4)), halfPlanes()), nLayers, 0.1
        )
    );
    const prismLayers& layers = endedMeshes()[1].layers();

    EXPECT_EQ(turned.made.layers.points.size(), layers.points.size());
    EXPECT_LT(max(mag(turned.made.layers.points - layers.points)), 1e-9);
}


TEST(endedMesh, severalPartsOfOnePatchAreOnePatch)
{
    wallSurface surface(duct(4));
    surface.patchNames = wordList({"walls", "open", "open2"});
    for (label& patchi : surface.patchIDs)
    {
        patchi = min(patchi, label(1));
    }
    const wallSurface wall(endedOn(surface, wordList({"open"})));
    prismLayers layers(straightLayers(wall, {0, 0.05}));
    layers.border = wall.border;
    const memoryMesh memory(layers);
    const polyBoundaryMesh& patches = memory().boundaryMesh();

    ASSERT_EQ(wall.border.sides.size(), 2);
    ASSERT_EQ(patches.names(), wordList({"walls", layerOuterName, "open"}));
    EXPECT_EQ(patches[2].size(), 32);
    EXPECT_FALSE(memory().checkClosedBoundary(false));
}


TEST(endedMesh, multipleNormalsEndAtTheBorder)
{
    prismLayerControls controls;
    controls.layers = layersOf(nLayers, 0.1);
    controls.layers.multipleNormalsAngle = 50;
    const wallSurface wall(endedOn(halfCube(4), halfPlanes()));
    const prismLayerMesh run(layeredMesh(wall, controls));
    EXPECT_FALSE(run.made.layers.extraColumnPoints.empty());
    EXPECT_TRUE(run.certificate.valid());

    prismLayers layers(run.made.layers);
    const memoryMesh memory(layers);
    EXPECT_FALSE(memory().checkTopology(false));
    EXPECT_FALSE(memory().checkClosedBoundary(false));
    EXPECT_EQ(memory().boundaryMesh().size(), 3);

    // Between two columns on each of the four corners there is another edge
    EXPECT_EQ(memory().boundaryMesh()[2].size(), nLayers*(16 + 4));
}


// ************************************************************************* //
