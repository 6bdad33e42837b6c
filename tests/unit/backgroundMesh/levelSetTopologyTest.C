/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "levelSetTopology.H"
#include "Random.H"
#include "testStages.H"
#include "testSurfaces.H"
#include "wallBridges.H"

#include <map>

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using testSurfaces::stages;

//- 1 on the wall, anything less at free points, 0 elsewhere
static scalarField anyField(const backgroundMesh& mesh)
{
    Random random(12);
    scalarField field(mesh.points.size(), 0);

    forAll(field, p)
    {
        if (mesh.onWall(p))
        {
            field[p] = 1;
        }
        else if (mesh.free[p])
        {
            field[p] = random.sample01<scalar>();
        }
    }

    return field;
}


static wallSurface bodies()
{
    const wallSurface box(testSurfaces::cube(4));

    return testSurfaces::merge
    (
        box, testSurfaces::translated(box, vector(1.02, 0.1, 0.2))
    );
}


static backgroundMesh slitMesh()
{
    return stages(testSurfaces::slitBlock(8, 0.05), 5, 0.15).background();
}


//- How often each side of a triangle runs from one point to another
static std::map<std::pair<label, label>, int> sidesOf(const faceList& triangles)
{
    std::map<std::pair<label, label>, int> sides;

    for (const face& f : triangles)
    {
        forAll(f, i)
        {
            ++sides[{f[i], f.nextLabel(i)}];
        }
    }

    return sides;
}


static void expectLevelSetsLikeWall
(
    const wallSurface& wall,
    const scalar thickness
)
{
    const stages s(wall, 5, thickness);
    const surfaceTopology levelSet(wallLevelSetTopology(s.background()));
    const surfaceTopology expected(wallTopology(s.wall, s.context.addressing));

    EXPECT_EQ(levelSet.nComponents, expected.nComponents);
    EXPECT_EQ(levelSet.eulerCharacteristic, expected.eulerCharacteristic);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(wallTopology, sphereHasTwo)
{
    const wallSurface wall(testSurfaces::quadSphere(4));
    const surfaceTopology t(wallTopology(wall, makeWallAddressing(wall)));

    EXPECT_EQ(t.nComponents, 1);
    EXPECT_EQ(t.eulerCharacteristic, 2);
}


TEST(wallTopology, torusHasZero)
{
    const wallSurface wall(testSurfaces::torus(12, 8, 3, 1));
    const surfaceTopology t(wallTopology(wall, makeWallAddressing(wall)));

    EXPECT_EQ(t.nComponents, 1);
    EXPECT_EQ(t.eulerCharacteristic, 0);
}


TEST(wallTopology, bodiesAdd)
{
    const wallSurface wall(bodies());
    const surfaceTopology t(wallTopology(wall, makeWallAddressing(wall)));

    EXPECT_EQ(t.nComponents, 2);
    EXPECT_EQ(t.eulerCharacteristic, 4);
}


TEST(levelSetTopology, aroundASphere)
{
    expectLevelSetsLikeWall(testSurfaces::sphere(8), 0.15);
}


TEST(levelSetTopology, aroundATorus)
{
    // With a hole that is wide, and one that is narrower than the layers
    expectLevelSetsLikeWall(testSurfaces::torus(24, 12, 2, 0.5), 0.15);
    expectLevelSetsLikeWall(testSurfaces::torus(36, 18, 1, 0.95), 0.15);
}


TEST(levelSetTopology, betweenBodies)
{
    expectLevelSetsLikeWall(bodies(), 0.15);
}


TEST(levelSetTopology, inASlit)
{
    for (const scalar width : {0.2, 0.05, 0.01, 0.001})
    {
        SCOPED_TRACE(width);
        expectLevelSetsLikeWall(testSurfaces::slitBlock(8, width), 0.15);
    }
}


TEST(levelSetTopology, insideASphere)
{
    expectLevelSetsLikeWall
    (
        testSurfaces::reversed(testSurfaces::sphere(8)), 0.15
    );
}


TEST(levelSetTopology, nothingAboveTheLargestValue)
{
    const backgroundMesh mesh(testSurfaces::shellMesh(4, 1, 2));
    const surfaceTopology t(levelSetTopology(mesh, anyField(mesh), 1.5));

    EXPECT_EQ(t.nComponents, 0);
    EXPECT_EQ(t.eulerCharacteristic, 0);
}


TEST(levelSetTriangles, areClosedAndOriented)
{
    const backgroundMesh mesh(slitMesh());
    const scalarField field(anyField(mesh));

    for (const scalar level : {0.1, 0.5, 0.999})
    {
        pointField points;
        faceList triangles;
        levelSetTriangles(mesh, field, level, points, triangles);
        const auto sides = sidesOf(triangles);

        ASSERT_FALSE(triangles.empty());
        for (const auto& side : sides)
        {
            EXPECT_EQ(side.second, 1);
            EXPECT_EQ(sides.count({side.first.second, side.first.first}), 1u);
        }
    }
}


TEST(levelSetTriangles, haveTheTopologyThatIsCounted)
{
    const backgroundMesh mesh(slitMesh());
    const scalarField field(anyField(mesh));

    for (const scalar level : {0.1, 0.5, 0.999})
    {
        pointField points;
        faceList triangles;
        levelSetTriangles(mesh, field, level, points, triangles);
        const label nEdges = label(sidesOf(triangles).size())/2;

        EXPECT_EQ
        (
            levelSetTopology(mesh, field, level).eulerCharacteristic,
            points.size() - nEdges + triangles.size()
        );
    }
}


TEST(levelSetTriangles, areWhereTheFieldHasTheLevel)
{
    // A field that is linear in the radius, on spheres of points
    const backgroundMesh mesh(testSurfaces::shellMesh(8, 1, 2));
    const scalarField field(2 - mag(mesh.points));
    pointField points;
    faceList triangles;
    levelSetTriangles(mesh, field, 0.4, points, triangles);

    for (const point& x : points)
    {
        // Chords of edges 0.2 to 0.4 long are inside the spheres
        EXPECT_LT(mag(x), 1.6 + 1e-12);
        EXPECT_GT(mag(x), 1.6 - 0.02);
    }
}


TEST(levelSetTriangles, faceTheLowerSide)
{
    const backgroundMesh mesh(testSurfaces::shellMesh(8, 1, 2));
    wallSurface levelSet;
    levelSetTriangles
    (
        mesh, 2 - mag(mesh.points), 0.4, levelSet.points, levelSet.faces
    );

    const scalar volume =
        4.0/3.0*constant::mathematical::pi*pow3(1.6);
    EXPECT_NEAR(testSurfaces::enclosedVolume(levelSet)/volume, 1, 0.05);
}


static label splitBridgesOf(const wallSurface& wall, backgroundMesh& mesh)
{
    return splitWallBridges
    (
        wall.faces, makeWallAddressing(wall).pointPoints, wallSearch(wall), mesh
    );
}


TEST(splitWallBridges, secondTimeFindsNone)
{
    const stages s(testSurfaces::slitBlock(8, 0.05), 5, 0.15);
    backgroundMesh mesh(s.background());

    EXPECT_EQ
    (
        splitWallBridges
        (
            s.wall.faces, s.context.addressing.pointPoints, s.context.search(),
            mesh
        ),
        0
    );
}


TEST(splitWallBridges, keepTheVolume)
{
    // Without nodes, tetrahedra of a ball go from wall to wall
    const wallSurface wall(testSurfaces::reversed(testSurfaces::sphere(4)));
    backgroundMesh mesh(testSurfaces::ballMesh(4));

    const label nBridges =
        splitBridgesOf(wall, mesh);
    EXPECT_GT(nBridges, 0);

    scalar volume = 0;
    forAll(mesh.tets, t)
    {
        EXPECT_GT(mesh.tet(t).mag(), 0);
        volume += mesh.tet(t).mag();
    }
    EXPECT_NEAR(volume, -testSurfaces::enclosedVolume(wall), 1e-12);
}


TEST(splitWallBridges, pointsFarFromTheWallAreOnTheEnvelope)
{
    const wallSurface wall(testSurfaces::reversed(testSurfaces::sphere(4)));
    backgroundMesh mesh(testSurfaces::ballMesh(4));
    splitBridgesOf(wall, mesh);

    // The gap is 1. The facets are up to 0.1 inside of the sphere. Chords
    // between neighbours of a point are shallow anyway.
    for (label p = mesh.nWallPoints; p < mesh.points.size(); ++p)
    {
        const scalar depth = 1 - mag(mesh.points[p]);

        if (mag(depth - domainControls::bridgeShare) > 0.1)
        {
            EXPECT_EQ(mesh.free[p], depth < domainControls::bridgeShare);
        }
    }
}


TEST(splitSlitEdges, closeTheEnvelope)
{
    // A slit that is narrower than the edges of its walls: no free point on one
    // side has a neighbour that is free or on the wall on the other side
    const scalar width = 0.2;
    const stages s(testSurfaces::slitBlock(8, width), 5, 0.15);
    const backgroundMesh mesh(s.background());
    label nInside = 0;

    for (const edge& e : mesh.edges)
    {
        const point& a = mesh.points[e.start()];
        const point& b = mesh.points[e.end()];
        const auto inside = [&](const label p)
        {
            return mesh.onWall(p) || mesh.free[p];
        };
        const auto inSlit = [&](const point& x)
        {
            return mag(x.x() - 1) < 0.5*width + SMALL && x.y() > 1.2
                && x.y() < 1.8 && x.z() > 0.2 && x.z() < 0.8;
        };

        if
        (
            inside(e.start()) && inside(e.end()) && inSlit(a) && inSlit(b)
        )
        {
            ++nInside;
            EXPECT_GT((a.x() - 1)*(b.x() - 1), -SMALL);
        }
    }

    EXPECT_GT(nInside, 20);
}


TEST(splitSlitEdges, noneWithoutASlit)
{
    const stages s(testSurfaces::lBlock(6), 5, 0.15);
    backgroundMesh mesh(s.background());

    EXPECT_EQ(splitSlitEdges(s.context.search(), mesh), 0);
}


// ************************************************************************* //
