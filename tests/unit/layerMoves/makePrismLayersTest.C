/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "makePrismLayers.H"
#include "layerGeometry.H"
#include "testStages.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using testSurfaces::layeredMesh;

static const label nLayers = 8;

//- A wall and its layers
struct layeredShape
{
    const char* name;
    wallSurface wall;
    prismLayerMesh mesh;
};


static layeredShape makeShape(const char* name, const wallSurface& wall)
{
    return layeredShape{name, wall, layeredMesh(wall, nLayers, 0.1)};
}


//- Made once: all tests look at the same layers
static const List<layeredShape>& shapes()
{
    static const wallSurface box(testSurfaces::cube(6));
    static const List<layeredShape> list
    ({
        makeShape("cube", box),
        makeShape("quadCube", testSurfaces::quadCube(6)),
        makeShape("sphere", testSurfaces::sphere(8)),
        makeShape("quadSphere", testSurfaces::quadSphere(8)),
        makeShape("torus", testSurfaces::torus(24, 12, 1, 0.8)),
        makeShape("lBlock", testSurfaces::lBlock(6)),
        makeShape("wedge", testSurfaces::wedgeBlock(8, 45)),
        makeShape("slit", testSurfaces::slitBlock(8, 0.05)),
        makeShape
        (
            "bodies",
            testSurfaces::merge
            (
                box,
                testSurfaces::translated(box, vector(1.05, 0.1, 0.2))
            )
        )
    });

    return list;
}


static label count(const madeLayers& made, const squeezeCause cause)
{
    label n = 0;

    for (const squeezeCause c : made.causes)
    {
        n += c == cause;
    }

    return n;
}


//- Whether nothing hinders the layers
static bool isFree(const layeredShape& s)
{
    const string name(s.name);

    return name == "cube" || name == "quadCube" || name == "sphere"
        || name == "quadSphere" || name == "lBlock";
}


//- Layers on columns as they are
static prismLayers asProposed
(
    const wallSurface& wall,
    const layerColumns& columns
)
{
    const label n = columns.nLayers;

    prismLayers layers;
    layers.nLayers = n;
    layers.faces = wall.faces;
    layers.patchIDs = wall.patchIDs;
    layers.patchNames = wall.patchNames;
    layers.points.setSize(wall.points.size()*(n + 1));

    forAll(wall.points, p)
    {
        layers.points[layers.pointLabel(p, 0)] = wall.points[p];

        for (label i = 0; i < n; ++i)
        {
            layers.points[layers.pointLabel(p, i + 1)] = wall.points[p]
              + columns.heights[p*n + i]*columns.offsets[p*n + i];
        }
    }

    return layers;
}


//- Layers on columns of a mesh that were changed
static madeLayers remade
(
    const wallSurface& wall,
    const prismLayerMesh& m,
    const layerColumns& columns
)
{
    return makePrismLayers
    (
        testSurfaces::frontOf(wall, 0), m.guide.spacing,
        columns
    );
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(makePrismLayers, areCertified)
{
    for (const layeredShape& s : shapes())
    {
        SCOPED_TRACE(s.name);
        const layerCertificate certificate(certify(s.mesh.made.layers));

        EXPECT_TRUE(certificate.valid());
        EXPECT_EQ(certificate.nCells, nLayers*s.wall.faces.size());
    }
}


TEST(makePrismLayers, areOnAllFacesOfTheWall)
{
    for (const layeredShape& s : shapes())
    {
        SCOPED_TRACE(s.name);
        const prismLayers& layers = s.mesh.made.layers;

        EXPECT_EQ(layers.nLayers, nLayers);
        EXPECT_EQ(layers.faces, s.wall.faces);
        EXPECT_EQ(layers.patchIDs, s.wall.patchIDs);
        EXPECT_EQ(layers.patchNames, s.wall.patchNames);
        ASSERT_EQ(layers.nColumns(), s.wall.points.size());
        forAll(s.wall.points, p)
        {
            EXPECT_EQ(layers(p, 0), s.wall.points[p]);
        }
    }
}


TEST(makePrismLayers, haveAllTheirThicknessWhereNothingHinders)
{
    for (const layeredShape& s : shapes())
    {
        if (isFree(s))
        {
            SCOPED_TRACE(s.name);
            EXPECT_EQ(s.mesh.made.thickness, s.mesh.guide.spacing.thickness);

            // A face in a concave corner may be lower than its columns
            EXPECT_GT
            (
                count(s.mesh.made, squeezeCause::none),
                0.99*s.wall.points.size()
            );
        }
    }
}


TEST(makePrismLayers, columnsEndInTheirRoom)
{
    for (const layeredShape& s : shapes())
    {
        SCOPED_TRACE(s.name);
        forAll(s.wall.points, p)
        {
            const point& end = s.mesh.made.layers(p, nLayers);
            const vector column(end - s.wall.points[p]);
            const scalar h =
                s.mesh.visibility.heightCosine(p, column);

            // Faces have the height rather than columns, which may bend
            EXPECT_LE(h, 1.3*s.mesh.made.thickness[p]);
        }
    }
}


TEST(makePrismLayers, facesHaveTheThicknessOfTheirColumns)
{
    for (const layeredShape& s : shapes())
    {
        stackHeights stack(s.mesh.made.layers);
        label nWrong = 0;
        forAll(s.wall.faces, facei)
        {
            const face& f = s.wall.faces[facei];
            const scalarField of(s.mesh.made.thickness, f);
            stack.compute(facei);
            // It varies along curved walls, and beside lower columns
            nWrong += of == scalarField(s.mesh.guide.spacing.thickness, f)
                && mag(sum(stack.heights())/average(of) - 1) > 0.15;
        }
        EXPECT_LT(nWrong, 0.01*s.wall.faces.size()) << s.name;
    }
}


TEST(makePrismLayers, firstHeightIsExactOnFlatFaces)
{
    const layeredShape& s = shapes()[0];
    const scalar h1 = s.mesh.guide.spacing.firstThickness[0];
    label nFlat = 0;

    forAll(s.wall.points, p)
    {
        const vector& n = s.mesh.visibility.cones[p].axis;

        if (s.mesh.visibility.cones[p].cosine > 1 - 1e-12)
        {
            ++nFlat;
            EXPECT_NEAR
            (
                ((s.mesh.made.layers(p, 1) - s.wall.points[p]) & n)/h1, 1, 1e-10
            );
        }
    }

    EXPECT_EQ(nFlat, 6*25);
}


TEST(makePrismLayers, heightsAscend)
{
    for (const layeredShape& s : shapes())
    {
        SCOPED_TRACE(s.name);
        const prismLayers& layers = s.mesh.made.layers;
        forAll(s.wall.points, p)
        {
            const vector& n = s.mesh.visibility.cones[p].axis;

            for (label i = 1; i <= nLayers; ++i)
            {
                EXPECT_GT((layers(p, i) - layers(p, i - 1)) & n, 0);
            }
        }
    }
}


TEST(makePrismLayers, shortColumnsHaveACause)
{
    for (const layeredShape& s : shapes())
    {
        SCOPED_TRACE(s.name);
        forAll(s.wall.points, p)
        {
            const squeezeCause cause = s.mesh.made.causes[p];

            const bool full =
                s.mesh.made.thickness[p] == s.mesh.guide.spacing.thickness[p];

            EXPECT_TRUE(cause != squeezeCause::none || full);
        }
    }
}


TEST(makePrismLayers, columnsThatLeanTooFarTurnBeforeTheyRetreat)
{
    // Every second column lies down almost flat
    const wallSurface wall(testSurfaces::sphere(8));
    const prismLayerMesh m(layeredMesh(wall, nLayers, 0.1));
    layerColumns columns(m.columns);

    for (label p = 0; p < wall.points.size(); p += 2)
    {
        const vector n(normalised(wall.points[p]));
        const vector across(normalised(n ^ vector(0.36, 0.48, 0.8)));

        for (label i = 0; i < nLayers; ++i)
        {
            columns.offsets[p*nLayers + i] = n + 20*across;
        }
    }
    ASSERT_FALSE(certify(asProposed(wall, columns)).valid());

    const madeLayers made(remade(wall, m, columns));

    // Their neighbours stand upright, so that no height need be lost
    EXPECT_TRUE(certify(made.layers).valid());
    EXPECT_EQ(made.thickness, m.guide.spacing.thickness);
}


TEST(makePrismLayers, columnsBeyondTheMiddleRetreat)
{
    const wallSurface wall(testSurfaces::reversed(testSurfaces::sphere(6)));
    const prismLayerMesh m(layeredMesh(wall, nLayers, 3));
    layerColumns columns(m.columns);
    columns.maxThickness = m.guide.spacing.thickness;
    columns.causes = squeezeCause::none;

    const madeLayers made(remade(wall, m, columns));

    EXPECT_TRUE(certify(made.layers).valid());
    EXPECT_GT(count(made, squeezeCause::validity), 0);
    EXPECT_LT(max(made.thickness), 1);
}


TEST(makePrismLayers, columnsThroughTheOppositeWallRetreat)
{
    const wallSurface box(testSurfaces::cube(6));
    const wallSurface wall
    (
        testSurfaces::merge
        (
            box, testSurfaces::translated(box, vector(1.05, 0.1, 0.2))
        )
    );
    const prismLayerMesh m(layeredMesh(wall, nLayers, 0.1));
    layerColumns columns(m.columns);
    columns.maxThickness = m.guide.spacing.thickness;
    columns.causes = squeezeCause::none;
    const madeLayers made(remade(wall, m, columns));

    EXPECT_TRUE(certify(made.layers).valid());
    EXPECT_GT(count(made, squeezeCause::intersection), 0);
    EXPECT_GT(count(made, squeezeCause::none), 0);
}


TEST(makePrismLayers, columnsWithTooMuchRoomInASlitRetreat)
{
    const layeredShape& s = shapes()[7];
    layerColumns columns(s.mesh.columns);
    columns.maxThickness = s.mesh.guide.spacing.thickness;
    columns.causes = squeezeCause::none;
    const madeLayers made(remade(s.wall, s.mesh, columns));

    EXPECT_TRUE(certify(made.layers).valid());
    EXPECT_GT
    (
        count(made, squeezeCause::intersection)
      + count(made, squeezeCause::validity),
        0
    );
    EXPECT_LT(min(made.thickness), 0.05);
}


TEST(makePrismLayers, columnsIntoTheBodyHaveNoHeight)
{
    const wallSurface wall(testSurfaces::cube(2));
    prismLayerMesh m(layeredMesh(wall, 2, 0.01));
    layerFront front(testSurfaces::frontOf(wall, 0));
    for (visibilityCone& cone : front.visibility.cones)
    {
        cone.axis = -cone.axis;
    }
    for (vector& offset : m.columns.offsets)
    {
        offset = -offset;
    }

    const certification certified
    (
        makePrismLayers(front, m.guide.spacing, m.columns).certified
    );

    ASSERT_FALSE(certified.pointsWithoutHeight.empty());
    EXPECT_LT(max(certified.pointsWithoutHeight), wall.points.size());
    EXPECT_EQ(certified.cause, squeezeCause::validity);
}


// ************************************************************************* //
