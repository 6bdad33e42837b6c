/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elementMesh.H"
#include "cellDivision.H"
#include "makeHexCore.H"
#include "memoryMesh.H"
#include "meshBuilder.H"
#include "testLayers.H"
#include "testSurfaces.H"
#include "throwingErrors.H"
#include "thrownMessage.H"

#include <map>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A mesh of one cell, its faces seen from outside, each with a patch of its
//  own
static polyMeshParts oneCell
(
    const pointField& points,
    const faceList& faces,
    const wordList& types = wordList()
)
{
    polyMeshParts parts;
    parts.points = points;
    parts.nCells = 1;
    meshBuilder made;
    forAll(faces, i)
    {
        made.append(faces[i], 0, meshBuilder::onPatch(i));
        parts.patches.append
        (
            "side" + name(i), types.empty() ? word("patch") : types[i]
        );
    }
    const label n = faces.size();
    parts.topology = made.topology(made.order(1, n), n);

    return parts;
}


//- A cell of height 1 on a polygon in the plane z = 0, counter-clockwise seen
//  from above, with its last side cut into triangles on request
static polyMeshParts prismOn(const List<point>& corners, const bool cut = false)
{
    const pointField polygon(corners);
    const label n = polygon.size();
    pointField points(polygon);
    points.append(polygon + vector(0, 0, 1));
    faceList faces(2, face(identity(n)));
    faces[0].flip();
    for (label i = 0; i < n; ++i)
    {
        faces[1][i] = i + n;
        faces.append(face({i, (i + 1)%n, (i + 1)%n + n, i + n}));
    }
    if (cut)
    {
        faces.last() = face({n - 1, 0, n});
        faces.append(face({n - 1, n, 2*n - 1}));
    }

    return oneCell(points, faces);
}


static pointField cubePoints()
{
    return pointField
    ({
        point(0, 0, 0), point(1, 0, 0), point(1, 1, 0), point(0, 1, 0),
        point(0, 0, 1), point(1, 0, 1), point(1, 1, 1), point(0, 1, 1)
    });
}


static const std::vector<face>& cubeFaces()
{
    return facesOf(elementShape::hexahedron);
}


static elementMesh exported(polyMeshParts parts)
{
    const memoryMesh mesh(std::move(parts));
    return elementsOf(mesh());
}


static scalar totalVolume(const elementMesh& mesh)
{
    scalar sum = 0;
    for (const elementGroup& zone : mesh.zones)
    {
        sum += mesh.volume(zone);
    }

    return sum;
}


//- All elements are positive, and each of their faces is one of two elements,
//  or of one element and of one element of a patch
static void expectConformal(const elementMesh& mesh)
{
    std::map<labelList, label> nSides;
    const auto add = [&](const face& f)
    {
        labelList key(f);
        sort(key);
        ++nSides[key];
    };

    for (label i = 0; i < mesh.cells.size(); ++i)
    {
        const labelList labels(mesh.cells.points(i));
        EXPECT_TRUE(isPositive(mesh.cells.shape(i), labels, mesh.points));

        for (const face& f : facesOf(mesh.cells.shape(i)))
        {
            add(renumber(labels, f));
        }
    }
    for (label i = 0; i < mesh.faces.size(); ++i)
    {
        add(face(mesh.faces.points(i)));
    }
    for (const auto& side : nSides)
    {
        EXPECT_EQ(side.second, 2) << name(side.first.size()) << " points";
    }
}


static std::string refusal(const polyMeshParts& parts)
{
    const throwingErrors throwing;
    return thrownMessage<error>([&]() { exported(parts); });
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(elementMesh, cellsWithTheShapeOfAnElementStay)
{
    const pointField points(cubePoints());
    const labelListList labels
    ({
        {0, 1, 2, 5}, {0, 1, 2, 3, 4}, {0, 1, 2, 4, 5, 6},
        {0, 1, 2, 3, 4, 5, 6, 7}
    });
    forAll(labels, i)
    {
        const elementShape shape =
            elementShape(int(elementShape::tetrahedron) + i);
        faceList faces;
        for (const face& f : facesOf(shape))
        {
            faces.append(face(renumber(labels[i], f)));
        }
        const elementMesh mesh(exported(oneCell(points, faces)));

        ASSERT_EQ(mesh.cells.size(), 1);
        EXPECT_EQ(mesh.cells.shape(0), shape);
        EXPECT_EQ(mesh.nDivided, 0);
        expectConformal(mesh);
    }
}


TEST(elementMesh, aHexahedronWithACutSideIsPyramidsAndTetrahedra)
{
    faceList faces(5);
    std::copy(cubeFaces().begin() + 1, cubeFaces().end(), faces.begin());
    faces.append(face({0, 3, 2}));
    faces.append(face({0, 2, 1}));
    const elementMesh mesh(exported(oneCell(cubePoints(), faces)));

    EXPECT_EQ(mesh.count(elementShape::pyramid), 5);
    EXPECT_EQ(mesh.count(elementShape::tetrahedron), 2);
    EXPECT_NEAR(totalVolume(mesh), 1, 1e-14);
    EXPECT_EQ(mesh.patches.size(), 7);
    EXPECT_EQ(mesh.patches[5].name, "side5");
    EXPECT_NEAR(mesh.area(mesh.patches[5]), 0.5, 1e-14);
    expectConformal(mesh);
}


TEST(elementMesh, hexahedraBesideSmallerOnesAreDivided)
{
    const wallSurface sphere(testSurfaces::sphere(4, 0.3));
    const wallSearch search(sphere);
    hexCoreBox box;
    box.box = boundBox(point::uniform(-1), point(2, 1, 1));
    box.patches.append("low", "patch");
    box.patches.append("high", "wall");
    box.sidePatches = labelList({0, 1, 0, 1, 0, 1});
    polyMeshParts parts
    (
        makeHexCore
        (
            box, coreObstacles{search, search},
            [](const point& x)
            {
                return 0.1 + 0.4*mag(point(x.x() - 2, x.y() - 1, 0));
            },
            100000
        )
    );
    parts.cellZones.append(cellZoneParts("first", labelList({0, 1, 2})));
    const scalar volume = box.box.volume();
    const elementMesh mesh(exported(parts));

    EXPECT_GT(mesh.nDivided, 0);
    EXPECT_GT(mesh.count(elementShape::hexahedron), 0);
    EXPECT_NEAR(totalVolume(mesh), volume, 1e-10);
    expectConformal(mesh);

    ASSERT_EQ(mesh.zones.size(), 2);
    EXPECT_EQ(mesh.zones[0].name, "first");
    EXPECT_EQ(mesh.zones[1].name, "cells");
    EXPECT_EQ(mesh.zones[0].size + mesh.zones[1].size, mesh.cells.size());
}


TEST(elementMesh, quadrilateralsThatAreNotSeenWholeAreDivided)
{
    // A tetrahedron 0 1 2 3 with a point 4 outside of the edge 01: a longer
    // diagonal leaves room for an apex
    const pointField points
    ({
        point(0, 0, 0), point(1, 0, 0.01), point(0, -0.006, 0.01),
        point(0, 0.006, 0.01), point(1, 0, 0)
    });
    const faceList faces
    ({
        face({4, 1, 2, 0}), face({4, 0, 3, 1}), face({1, 3, 2}), face({0, 2, 3})
    });
    const elementMesh mesh(exported(oneCell(points, faces)));

    EXPECT_EQ(mesh.count(elementShape::pyramid), 1);
    EXPECT_EQ(mesh.count(elementShape::tetrahedron), 4);
    expectConformal(mesh);
}


TEST(elementMesh, theApexIsNotNearToAPlaneOfAFace)
{
    // The letter L: the mean of its points is behind all planes, but by 0.001
    const elementMesh mesh
    (
        exported
        (
            prismOn
            ({
                point(0, 0, 0), point(2, 0, 0), point(2, 1, 0),
                point(1.001, 1.001, 0), point(1, 2, 0), point(0, 2, 0)
            }, true)
        )
    );
    expectConformal(mesh);
    for (label i = 0; i < mesh.cells.size(); ++i)
    {
        EXPECT_GT(mesh.volume(i), 0.07);
    }
}


//- The letter U
static const List<point> letterU
({
    point(0, 0, 0), point(3, 0, 0), point(3, 3, 0), point(2, 3, 0),
    point(2, 1, 0), point(1, 1, 0), point(1, 3, 0), point(0, 3, 0)
});


TEST(elementMesh, aPrismOnAPolygonIsPrismsOnItsTriangles)
{
    const elementMesh mesh(exported(prismOn(letterU)));

    EXPECT_EQ(mesh.nDivided, 1);
    EXPECT_EQ(mesh.cells.size(), 6);
    EXPECT_EQ(mesh.count(elementShape::prism), 6);
    EXPECT_NEAR(totalVolume(mesh), 7, 1e-14);
    expectConformal(mesh);
}


TEST(elementMesh, layersOnAPolygonArePrismsOnTheSameTriangles)
{
    const memoryMesh layers(testSurfaces::onePolygon(6, scalarList({0, 1, 3})));
    const elementMesh mesh(elementsOf(layers()));

    EXPECT_EQ(mesh.cells.size(), 8);
    EXPECT_EQ(mesh.count(elementShape::prism), 8);
    expectConformal(mesh);
}


TEST(elementMesh, aCellWithoutACentreIsRefused)
{
    expectWords
    (
        refusal(prismOn(letterU, true)), {"Cell 0 at (1.5 1.75 0.5)", "divided"}
    );
}


TEST(elementMesh, cellsOfTwoZonesAreAGroup)
{
    faceList faces(6);
    std::copy(cubeFaces().begin(), cubeFaces().end(), faces.begin());
    polyMeshParts parts(oneCell(cubePoints(), faces));
    parts.cellZones.append(cellZoneParts("here", labelList(1, Zero)));
    parts.cellZones.append(cellZoneParts("there", labelList(1, Zero)));
    const elementMesh mesh(exported(parts));

    ASSERT_EQ(mesh.zones.size(), 1);
    EXPECT_EQ(mesh.zones[0].name, "here+there");
    EXPECT_EQ(mesh.zones[0].size, 1);
}


TEST(elementMesh, aMeshBetweenEmptyPatchesIsItsPlane)
{
    // Normal to each axis
    const wordList along[3] =
    {
        {"patch", "patch", "patch", "empty", "patch", "empty"},
        {"patch", "patch", "empty", "patch", "empty", "patch"},
        {"empty", "empty", "patch", "patch", "patch", "patch"}
    };
    faceList faces(6);
    std::copy(cubeFaces().begin(), cubeFaces().end(), faces.begin());
    const pointField points(cmptMultiply(cubePoints(), vector(2, 3, 5)));
    const scalar areas[3] = {15, 10, 6};

    for (direction axis = 0; axis < 3; ++axis)
    {
        const elementMesh mesh
        (
            exported(oneCell(points, faces, along[axis]))
        );
        EXPECT_EQ(mesh.dimension, 2);
        EXPECT_EQ(mesh.points.size(), 4);
        ASSERT_EQ(mesh.cells.size(), 1);
        EXPECT_EQ(mesh.cells.shape(0), elementShape::quadrilateral);
        const face plane(mesh.cells.points(0));
        EXPECT_NEAR(plane.areaNormal(mesh.points).z(), areas[axis], 1e-14);

        ASSERT_EQ(mesh.patches.size(), 4);
        scalar length = 0;
        for (const elementGroup& patch : mesh.patches)
        {
            length += mesh.area(patch);
        }
        const vector sides(2, 3, 5);
        EXPECT_NEAR(length, 2*(cmptSum(sides) - sides[axis]), 1e-14);
    }
}


// ************************************************************************* //
