/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sidePatchRemainders.H"
#include "openSurfaces.H"
#include "testLayers.H"
#include "thrownMessage.H"

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The boundary with triangles as large as they can be
static farFieldBoundary farFieldBoundaryOf
(
    const prismLayers& layers,
    const farBoundary& far
)
{
    return makeFarFieldBoundary
    (
        layers, far, [](const point&) { return scalar(100); }
    );
}


//- One layer
static prismLayers oneLayer(const wallSurface& wall, const scalar height = 0.1)
{
    prismLayers layers(straightLayers(wall, {0, height}));
    layers.border = wall.border;

    return layers;
}


static farBoundary boxSides(const point& low, const point& high)
{
    farBoundaryControls controls;
    controls.type = farBoundaryType::box;
    controls.box = boundBox(low, high);

    return makeFarBoundary
    (
        controls, [](const fileName& file) { return file; }
    );
}


static farFieldBoundary ofHalfCube(const farBoundary& far)
{
    return farFieldBoundaryOf
    (
        oneLayer(endedOn(halfCube(4), halfPlanes())), far
    );
}


static bool hasFaces(const farFieldBoundary& boundary, const word& patch)
{
    const wordList& names = boundary.surface.patchNames;

    return boundary.surface.patchIDs.found(names.find(patch));
}


//- Area of the triangles of a patch, all of which have a normal
static scalar area
(
    const farFieldBoundary& boundary,
    const word& patch,
    const vector& normal
)
{
    const wallSurface& surface = boundary.surface;
    const label patchi = surface.patchNames.find(patch);
    EXPECT_GE(patchi, 0) << patch;
    scalar sum = 0;

    forAll(surface.faces, facei)
    {
        if (surface.patchIDs[facei] == patchi)
        {
            const vector a(surface.faces[facei].areaNormal(surface.points));
            EXPECT_LT(mag(a - mag(a)*normal), 1e-12) << patch;
            sum += mag(a);
        }
    }

    return sum;
}


//- Its edges with one face are those of the outer surface of the layers, from
//  the other side
static void expectFits
(
    const farFieldBoundary& boundary,
    const prismLayers& layers
)
{
    wallSurface both;
    both.points = layers.outerPoints();
    both.faces = layers.faces;
    const label nOuter = both.points.size(), n = boundary.columns.size();
    both.points.append(boundary.surface.points);

    for (label i = 0; i < n; ++i)
    {
        EXPECT_EQ
        (
            boundary.surface.points[i],
            layers(boundary.columns[i], layers.nLayers)
        );
    }
    for (face f : boundary.surface.faces)
    {
        for (label& p : f)
        {
            p = p < n ? boundary.columns[p] : p + nOuter;
        }
        both.faces.append(f);
    }

    EXPECT_TRUE(isClosed(both));
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(sidePatchRemainders, ofAPlaneAreTheBoxWithoutTheLayers)
{
    // The box ends on the plane, or goes on beyond it
    for (const scalar low : {0.0, -1.0})
    {
        const prismLayers layers(oneLayer(endedOn(halfCube(4), halfPlanes())));
        const farFieldBoundary boundary
        (
            farFieldBoundaryOf
            (
                layers, boxSides(point(-2, -2, low), point(3, 3, 2))
            )
        );

        expectFits(boundary, layers);
        EXPECT_EQ(boundary.columns.size(), 16);
        EXPECT_NEAR
        (
            area(boundary, "bottom", vector(0, 0, 1)), 25 - 1.44, 1e-13
        );
        EXPECT_NEAR(area(boundary, "xMin", vector(1, 0, 0)), 10, 1e-13);
        EXPECT_NEAR(area(boundary, "zMax", vector(0, 0, -1)), 25, 1e-13);
        EXPECT_FALSE(hasFaces(boundary, "zMin"));
    }
}


TEST(sidePatchRemainders, haveTheTypesOfTheirSides)
{
    const farFieldBoundary boundary
    (
        ofHalfCube(boxSides(point(-2, -2, 0), point(3, 3, 2)))
    );
    const wordList& names = boundary.surface.patchNames;

    ASSERT_EQ(boundary.surface.patchTypes.size(), names.size());
    forAll(names, i)
    {
        EXPECT_EQ
        (
            boundary.surface.patchTypes[i],
            names[i] == "bottom" ? "symmetryPlane" : "patch"
        );
    }
}


TEST(sidePatchRemainders, ofTwoPlanesMeetOnTheirLine)
{
    const prismLayers layers
    (
        oneLayer(endedOn(quarterCube(4), quarterPlanes()))
    );
    const farFieldBoundary boundary
    (
        farFieldBoundaryOf
        (
            layers, boxSides(point(-2, -1, -1), point(3, 3, 2))
        )
    );

    expectFits(boundary, layers);
    EXPECT_NEAR
    (
        area(boundary, "bottom", vector(0, 0, 1)), 15 - 1.2*0.6, 1e-13
    );
    EXPECT_NEAR
    (
        area(boundary, "side", vector(0, 1, 0)), 10 - 1.2*0.6, 1e-13
    );
    EXPECT_FALSE(hasFaces(boundary, "yMin"));
}


TEST(sidePatchRemainders, ofInletsAreWhatTheLayersLeave)
{
    const prismLayers layers
    (
        oneLayer(endedOn(duct(4), wordList({"inlet", "outlet"})))
    );
    const farFieldBoundary boundary(farFieldBoundaryOf(layers, farBoundary()));

    expectFits(boundary, layers);
    EXPECT_EQ(boundary.surface.patchNames, wordList({"inlet", "outlet"}));
    EXPECT_NEAR(area(boundary, "inlet", vector(1, 0, 0)), 0.64, 1e-14);
    EXPECT_NEAR(area(boundary, "outlet", vector(-1, 0, 0)), 0.64, 1e-14);
}


TEST(sidePatchRemainders, severalBodiesStandOnOnePlane)
{
    const wallSurface both
    (
        merge(halfCube(4), translated(halfCube(2), vector(2, 0, 0)))
    );
    const prismLayers layers(oneLayer(endedOn(both, halfPlanes())));
    const farFieldBoundary boundary
    (
        farFieldBoundaryOf(layers, boxSides(point(-2, -2, 0), point(5, 3, 2)))
    );

    expectFits(boundary, layers);
    EXPECT_NEAR
    (
        area(boundary, "bottom", vector(0, 0, 1)), 35 - 2*1.44, 1e-13
    );
}


TEST(sidePatchRemainders, groundBelowABoxIsNoRemainder)
{
    // The wall is the bottom, which ends on the four sides
    const List<sidePatch> planes
    ({
        symmetryPlane("west", Zero, vector(-1, 0, 0)),
        symmetryPlane("east", point(1, 0, 0), vector(1, 0, 0)),
        symmetryPlane("south", Zero, vector(0, -1, 0)),
        symmetryPlane("north", point(0, 1, 0), vector(0, 1, 0))
    });
    const prismLayers layers(oneLayer(endedOn(sheet(4, 0), planes)));
    const farFieldBoundary boundary
    (
        farFieldBoundaryOf(layers, boxSides(point(0, 0, -1), point(1, 1, 2)))
    );

    expectFits(boundary, layers);
    EXPECT_NEAR(area(boundary, "west", vector(1, 0, 0)), 1.9, 1e-13);
    EXPECT_NEAR(area(boundary, "north", vector(0, -1, 0)), 1.9, 1e-13);
    EXPECT_NEAR(area(boundary, "zMax", vector(0, 0, -1)), 1, 1e-13);
    // Below the ground there is no fluid
    EXPECT_FALSE(hasFaces(boundary, "zMin"));
}


TEST(sidePatchRemainders, layersOutsideOfTheBoxAreRefused)
{
    expectWords
    (
        thrownMessage<error>
        (
            []()
            {
                ofHalfCube(boxSides(point(-2, -2, 0), point(1.05, 3, 2)));
            }
        ),
        {"not around the wall", "(1.1 "}
    );
}


TEST(sidePatchRemainders, layersAcrossAnOutlineAreRefused)
{
    // Columns at the inlet lean through its outline
    prismLayers layers
    (
        oneLayer(endedOn(duct(4), wordList({"inlet", "outlet"})))
    );
    for (label c = 0; c < layers.nColumns(); ++c)
    {
        const point& root = layers(c, 0);
        if (mag(root - point(0, 0.5, 0)) < 1e-12)
        {
            layers.points[layers.index(c, 1)] = point(0, 0.5, 1.2);
        }
    }

    expectWords
    (
        thrownMessage<error>
        (
            [&]() { farFieldBoundaryOf(layers, farBoundary()); }
        ),
        {"The edge from (", "crosses another edge"}
    );
}


// ************************************************************************* //
