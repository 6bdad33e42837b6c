/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gatherShares.H"
#include "makePrismLayers.H"
#include "openSurfaces.H"
#include "patchReport.H"
#include "prismQuality.H"
#include "Random.H"
#include "testLayers.H"
#include "testStages.H"
#include "threadTeam.H"

#include <gtest/gtest.h>

#include <mutex>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using testSurfaces::layeredMesh;

//- Number of points, heights and causes of a share that are not those of the
//  whole front
static label nDifferences
(
    const frontShare& share,
    const madeLayers& made,
    const madeLayers& one
)
{
    label n = 0;
    forAll(share.columns.whole, c)
    {
        const label whole = share.columns.whole[c];

        for (label i = 0; i <= one.layers.nLayers; ++i)
        {
            n += made.layers(c, i) != one.layers(whole, i);
        }
        n += made.thickness[c] != one.thickness[whole];
        n += made.causes[c] != one.causes[whole];
    }
    for (const label c : made.gaveWay)
    {
        n += !one.gaveWay.found(share.columns.whole[c]);
    }

    return n;
}


//- Expects of processes, each with its share of a front, the layers that one
//  process makes, bit for bit
static void expectSameLayers
(
    const char* name,
    const prismLayerMesh& mesh,
    const label n,
    const layerMoveControls& controls = layerMoveControls()
)
{
    SCOPED_TRACE(std::string(name) + " on " + std::to_string(n));
    const layerFront& front = mesh.share.front;
    const layerSpacing spacing(mesh.guide.spacing.at(front.wallPoints));
    const madeLayers one
    (
        makePrismLayers(front, spacing, mesh.columns, controls)
    );
    const label nPoints = max(front.wallPoints) + 1;
    const labelList owners(ownersByRange(nPoints, n));
    std::mutex reporting;
    label nOwn = 0, nGaveWay = 0;

    threadTeam::run(n, [&](const threadTeam& processes)
    {
        const frontShare share
        (
            shareOf(front, owners, n, processes.rank())
        );
        const columnTeam team(share, processes);
        const madeLayers made
        (
            makePrismLayers
            (
                share.front, spacing.at(share.columns.whole),
                mesh.columns.at(share.columns.whole), controls, team
            )
        );
        const bool isValid = certify(made.layers, team).valid();

        const std::lock_guard<std::mutex> lock(reporting);
        for (const bool isOwn : share.columns.isOwn)
        {
            nOwn += isOwn;
        }
        nGaveWay += made.gaveWay.size();
        EXPECT_EQ(nDifferences(share, made, one), 0);
        EXPECT_EQ(made.certified.nRetreats, one.certified.nRetreats);
        EXPECT_TRUE(isValid);
    });

    EXPECT_EQ(nOwn, front.wallPoints.size());
    EXPECT_EQ(nGaveWay, one.gaveWay.size());
}


static void expectSameOnAll(const char* name, const prismLayerMesh& mesh)
{
    for (const label n : {2, 3, 5, 8})
    {
        expectSameLayers(name, mesh, n);
    }
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(layersOnShares, sphere)
{
    expectSameOnAll("sphere", layeredMesh(testSurfaces::sphere(8), 8, 0.1));
}


TEST(layersOnShares, quadrilaterals)
{
    expectSameOnAll
    (
        "quadSphere", layeredMesh(testSurfaces::quadSphere(8), 8, 0.1)
    );
}


TEST(layersOnShares, concaveEdges)
{
    expectSameOnAll("lBlock", layeredMesh(testSurfaces::lBlock(6), 8, 0.1));
    expectSameOnAll
    (
        "wedge", layeredMesh(testSurfaces::wedgeBlock(8, 45), 8, 0.1)
    );
}


TEST(layersOnShares, multipleNormals)
{
    prismLayerControls controls;
    controls.layers = testSurfaces::layersOf(6, 0.1);
    controls.layers.multipleNormalsAngle = 45.1;
    expectSameOnAll
    (
        "quadCube", layeredMesh(testSurfaces::quadCube(4), controls)
    );
    expectSameOnAll
    (
        "blade", layeredMesh(testSurfaces::bladeOnEdge(0.5), 6, 0.1)
    );
}


TEST(layersOnShares, wallsThatEnd)
{
    const wallSurface duct
    (
        testSurfaces::endedOn
        (
            testSurfaces::duct(6), wordList({"inlet", "outlet"})
        )
    );
    expectSameOnAll("duct", layeredMesh(duct, 6, 0.1));
    const wallSurface half
    (
        testSurfaces::endedOn
        (
            testSurfaces::halfSphere(6), testSurfaces::halfPlanes()
        )
    );
    expectSameOnAll("halfSphere", layeredMesh(half, 6, 0.1));
}


TEST(layersOnShares, heightsThatGiveWay)
{
    layerMoveControls controls;
    controls.quality.priority = qualityControls::priorities::quality;
    const prismLayerMesh mesh
    (
        layeredMesh(testSurfaces::wedgeBlock(8, 45), 8, 0.1)
    );
    for (const label n : {2, 5})
    {
        expectSameLayers("wedge", mesh, n, controls);
    }
}


//- Layers of the whole front on a share
static prismLayers layersOn(const frontShare& share, const prismLayers& all)
{
    prismLayers own(all);
    own.points.setSize(share.columns.whole.size()*(all.nLayers + 1));
    forAll(share.columns.whole, c)
    {
        for (label i = 0; i <= all.nLayers; ++i)
        {
            own.points[own.index(c, i)] = all(share.columns.whole[c], i);
        }
    }
    const layerFront& front = share.front;
    own.faces = front.surface.faces;
    own.patchIDs = SubList<label>(front.surface.patchIDs, front.nWallFaces);
    own.extraColumnPoints = front.extraColumnPoints();

    return own;
}


TEST(layersOnShares, theMasterGathersThem)
{
    const wallSurface wall(testSurfaces::lBlock(4));
    const prismLayerMesh mesh(layeredMesh(wall, 5, 0.1));
    const prismLayers& all = mesh.made.layers;
    const label n = 4;
    const labelList owners(ownersByRange(all.nWallPoints(), n));

    threadTeam::run(n, [&](const threadTeam& processes)
    {
        const frontShare share
        (
            shareOf(mesh.share.front, owners, n, processes.rank())
        );
        const prismLayers whole
        (
            layersOnMaster(layersOn(share, all), share, wall, processes)
        );
        if (processes.isMaster())
        {
            EXPECT_EQ(whole.points, all.points);
            EXPECT_EQ(whole.faces, all.faces);
            EXPECT_EQ(whole.patchIDs, all.patchIDs);
        }
        else
        {
            EXPECT_TRUE(whole.points.empty());
        }
    });
}


TEST(layersOnShares, percentilesAreThoseOfAllValues)
{
    const layerFront front(testSurfaces::frontOf(testSurfaces::sphere(6), 0));
    const label nPoints = front.wallPoints.size();
    Random random(5);
    scalarField all(nPoints);
    for (scalar& x : all)
    {
        x = pow3(random.sample01<scalar>() - 0.4);
    }
    const percentiles one(makePercentiles(all));

    for (const label n : {2, 7})
    {
        const labelList owners(ownersByRange(nPoints, n));
        threadTeam::run(n, [&](const threadTeam& processes)
        {
            const frontShare share
            (
                shareOf(front, owners, n, processes.rank())
            );
            const labelList own(findIndices(owners, processes.rank()));
            const percentiles spread
            (
                makePercentiles
                (
                    scalarField(all, own), columnTeam(share, processes)
                )
            );
            EXPECT_EQ(spread.min, one.min);
            EXPECT_EQ(spread.p1, one.p1);
            EXPECT_EQ(spread.p5, one.p5);
            EXPECT_EQ(spread.p50, one.p50);
            EXPECT_EQ(spread.p95, one.p95);
            EXPECT_EQ(spread.p99, one.p99);
            EXPECT_EQ(spread.max, one.max);
            EXPECT_NEAR(spread.mean, one.mean, 1e-15);
        });
    }
}


TEST(layersOnShares, layersThatMeet)
{
    const wallSurface box(testSurfaces::cube(6));
    expectSameOnAll
    (
        "slit", layeredMesh(testSurfaces::slitBlock(8, 0.05), 8, 0.1)
    );
    expectSameOnAll
    (
        "bodies",
        layeredMesh
        (
            testSurfaces::merge
            (
                box, testSurfaces::translated(box, vector(1.05, 0.1, 0.2))
            ),
            8, 0.1
        )
    );
}


// ************************************************************************* //
